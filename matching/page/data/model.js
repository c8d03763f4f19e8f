// The result that the page shows: what the arrays and their description say, under the names that the views use.

import { unpack } from "./arrays.js";
import { boundsOf } from "./bounds.js";
import { placed, readGrid } from "./octree.js";
import { baseName } from "./format.js";

// The vertices in the unit domain, where the grid is a grid.
function inUnitDomain(positions, [origin, ...ends]) {
  const axes = ends.map((end) => end.map((x, j) => x - origin[j]));
  const result = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3)
    axes.forEach((axis, k) => {
      const length2 = axis.reduce((sum, x) => sum + x * x, 0);
      result[i + k] = axis.reduce((sum, x, j) => sum + x * (positions[i + j] - origin[j]), 0) / length2;
    });
  return result;
}

// What was not measured is null in JSON, which would count as 0.
function withoutNull(distance) {
  for (const way of [distance?.deformed_to_template, distance?.template_to_deformed].filter(Boolean))
    for (const key of Object.keys(way)) way[key] ??= NaN;
  if (distance?.uncovered === null) distance.uncovered = NaN;
}

/** Reads the two elements of the page. */
export async function readModel(document) {
  const data = JSON.parse(document.getElementById("data").textContent);
  const arrays = await unpack(data.arrays, document.getElementById("arrays").textContent);
  const { summary } = data, last = summary.levels[summary.levels.length - 1].level;
  [summary.distance, summary.distance_before, ...summary.levels.map((level) => level.distance)].forEach(withoutNull);
  const unit = summary.unit || "";
  const model = {
    data,
    arrays,
    summary,
    dimension: summary.dimension,
    unit,
    length: unit || "units of the files",  // for labels
    names: { reference: baseName(summary.reference.file), template: baseName(summary.template.file) },
    reference: { positions: arrays.reference, facets: arrays["reference.facets"] },
    template: { positions: arrays.template, facets: arrays["template.facets"] },
    levels: [...data.levels.map((level) => ({ level, positions: arrays[`deformed.${level}`] })), { level: last, positions: arrays.deformed }],
    camera: data.camera,
    bounds: boundsOf(arrays.reference, arrays.template, arrays.deformed),
    referenceBounds: boundsOf(arrays.reference),
  };
  let grid;
  /** The grid with the positions of its corners before (`from`) and after (`to`) the map of the reference. */
  model.grid = () => {
    if (grid) return grid;
    grid = readGrid(arrays["grid.levels"], model.dimension, data.grid.finest_level, arrays["grid.images"]);
    const plain = placed(grid.positions, data.grid.domain);
    [grid.from, grid.to] = data.grid.backward ? [grid.images, plain] : [plain, grid.images];
    return grid;
  };
  /** The vertices of the reference where the grid is undeformed, in the unit domain. */
  model.onGrid = () => inUnitDomain(data.grid.backward ? arrays.deformed : arrays.reference, data.grid.domain);
  return model;
}
