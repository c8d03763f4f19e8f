#!/bin/sh
# manifold-3d 3.5.4 (npm): a mesh whose facets are inside out is taken without a word (status NoError), and booleans reckon with a body of
# negative volume. The union of the unit cube, read inside out, with one moved by a half has volume 0.5 instead of 1.5, what the moved one
# keeps without it 1.5 instead of 0.5, and what both have is negative. STL and OBJ from scanners and modellers are often inside out: look at
# the sign of volume() after reading.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit manifold-3d@3.5.4 >/dev/null
cat > inside_out.mjs <<'C'
import Module from 'manifold-3d';
const manifold = await Module();
manifold.setup();
const { Manifold, Mesh } = manifold;
const cube = Manifold.cube([1, 1, 1]).getMesh();
const triVerts = Uint32Array.from(cube.triVerts);
for (let i = 0; i < triVerts.length; i += 3) [triVerts[i], triVerts[i + 1]] = [triVerts[i + 1], triVerts[i]];
const inside_out = new Manifold(new Mesh({ numProp: 3, vertProperties: cube.vertProperties, triVerts }));
const moved = Manifold.cube([1, 1, 1]).translate([0.5, 0, 0]);
const volumes = [inside_out, inside_out.add(moved), moved.subtract(inside_out), moved.intersect(inside_out)].map((m) => m.volume());
console.log(`${inside_out.status()}; volumes: read ${volumes[0]}, union ${volumes[1]}, difference ${volumes[2]}, intersection ${volumes[3]}`);
const seen = [-1, 0.5, 1.5, -0.5];
process.exit(inside_out.status() === 'NoError' && volumes.every((v, i) => Math.abs(v - seen[i]) < 1e-6) ? 0 : 1);
C
node inside_out.mjs
