#!/bin/sh
# @gltf-transform/functions 4.5.1 (npm): clearNodeTransform(node), which gives a node's transformation to its children, moves the children. It
# multiplies child by parent instead of parent by child: below a parent turned a quarter about z, what lies at (0,3,0) is at (3,0,0) afterwards;
# below one scaled by two, what lies at 6 is at 3. Where both are only moved the order does not matter and the child stays. flatten() of the
# same package has the order right.
set -eu
version=4.5.1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --prefix . "@gltf-transform/core@$version" "@gltf-transform/functions@$version" >/dev/null
cat > child.mjs <<'C'
import { Document, Logger } from '@gltf-transform/core';
import { clearNodeTransform, flatten } from '@gltf-transform/functions';
// A child 3 along x, below a parent that is turned, scaled or moved.
const scene = (change) => {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT));
  const child = document.createNode().setTranslation([3, 0, 0]).setMesh(document.createMesh());
  const parent = change(document.createNode()).addChild(child);
  document.getRoot().setDefaultScene(document.createScene().addChild(parent));
  return { document, parent, child, where: () => child.getWorldTranslation().map((x) => Math.round(x * 1e6) / 1e6 + 0).join() };
};
const changes = { turned: (n) => n.setRotation([0, 0, Math.SQRT1_2, Math.SQRT1_2]), scaled: (n) => n.setScale([2, 2, 2]), moved: (n) => n.setTranslation([0, 5, 0]) };
const seen = {};
for (const [name, change] of Object.entries(changes)) {
  const cleared = scene(change), flat = scene(change), before = cleared.where();
  clearNodeTransform(cleared.parent);
  await flat.document.transform(flatten({ cleanup: false }));
  console.log(`parent ${name}: child at (${before}); after clearNodeTransform at (${cleared.where()}), after flatten at (${flat.where()})`);
  seen[name] = [before, cleared.where(), flat.where()].join(' ');
}
const expected = { turned: '0,3,0 3,0,0 0,3,0', scaled: '6,0,0 3,0,0 6,0,0', moved: '3,5,0 3,5,0 3,5,0' };
process.exit(Object.keys(expected).every((name) => seen[name] === expected[name]) ? 0 : 1);
C
node child.mjs
