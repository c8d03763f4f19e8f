// The grid, rebuilt from the levels of its cells along the Morton curve (matching/report/grid_outline.h).

/** Corners of cells as { positions: undeformed, images, cells: corner numbers, sides, cornersPerCell }; positions in the unit domain. */
export function readGrid(levels, dimension, finestLevel, images) {
  const n = 1 << dimension, side = 1 << finestLevel, row = side + 1;
  const lower = new Uint32Array(dimension * levels.length);
  let place = 0;
  const descend = (level, corner) => {
    if (levels[place] === level) {
      lower.set(corner, dimension * place);
      ++place;
      return;
    }
    const half = side >> (level + 1);
    for (let c = 0; c < n; ++c) descend(level + 1, corner.map((x, k) => x + ((c >> k) & 1) * half));
  };
  descend(0, new Array(dimension).fill(0));

  const keyOf = (cell, c) => {
    const width = side >> levels[cell];
    let key = 0;
    for (let k = dimension - 1; k >= 0; --k) key = key * row + lower[dimension * cell + k] + ((c >> k) & 1) * width;
    return key;
  };
  const keys = new Float64Array(n * levels.length);
  for (let cell = 0; cell < levels.length; ++cell) for (let c = 0; c < n; ++c) keys[n * cell + c] = keyOf(cell, c);
  const sorted = Float64Array.from(keys).sort();
  const numbers = new Map();
  for (const key of sorted) if (!numbers.has(key)) numbers.set(key, numbers.size);

  const positions = new Float32Array(3 * numbers.size);
  for (const [key, number] of numbers) {
    let rest = key;
    for (let k = 0; k < dimension; ++k) {
      positions[3 * number + k] = (rest % row) / side;
      rest = Math.floor(rest / row);
    }
  }
  if (images.length !== positions.length) throw new Error("the grid of the report is damaged");
  return { dimension, finestLevel, levels, positions, images, cells: Uint32Array.from(keys, (key) => numbers.get(key)), cornersPerCell: n };
}

/** Carries points of the unit domain to where the shapes are shown. \param domain images of the origin and of the unit vectors */
export function placed(positions, domain) {
  const [origin, ...ends] = domain;
  const result = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; i += 3)
    for (let j = 0; j < 3; ++j) {
      let x = origin[j];
      ends.forEach((end, k) => (x += positions[i + k] * (end[j] - origin[j])));
      result[i + j] = x;
    }
  return result;
}

// Pairs of corners along the sides of a square.
const squareSides = [[0, 1], [1, 3], [3, 2], [2, 0]];

/** All sides of the cells of a grid in the plane: pairs of corner numbers, each pair once. */
export function edgesOfPlane(grid) {
  const pairs = new Map();
  for (let i = 0; i < grid.cells.length; i += 4)
    for (const [a, b] of squareSides) {
      const from = Math.min(grid.cells[i + a], grid.cells[i + b]), to = Math.max(grid.cells[i + a], grid.cells[i + b]);
      pairs.set(from * grid.positions.length + to, [from, to]);
    }
  return Array.from(pairs.values());
}

/**
 * The sides of the cells that the plane x[axis] = place of the unit domain cuts, moved into that plane: pairs of points, as
 * (corner below, corner above, weight of the latter) each.
 */
export function sliceOfSpace(grid, axis, place) {
  const ends = [];
  const [a, b] = [0, 1, 2].filter((k) => k !== axis);
  const seen = new Set();
  for (let cell = 0; cell < grid.levels.length; ++cell) {
    const first = 8 * cell, low = grid.positions[3 * grid.cells[first] + axis], side = 1 / (1 << grid.levels[cell]);
    if (place < low || place >= low + side) continue;
    const weight = (place - low) / side;
    const corner = (c) => [grid.cells[first + c], grid.cells[first + c + (1 << axis)], weight];
    const square = [0, 1 << a, (1 << a) + (1 << b), 1 << b].map(corner);
    for (let k = 0; k < 4; ++k) {
      const from = square[k], to = square[(k + 1) % 4];
      const name = from[0] < to[0] ? `${from[0]},${to[0]},${low}` : `${to[0]},${from[0]},${low}`;
      if (seen.has(name)) continue;
      seen.add(name);
      ends.push(from, to);
    }
  }
  return ends;
}
