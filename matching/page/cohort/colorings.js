// What the colours of the shape can mean.

import { figure, percent, quantile } from "../data/format.js";
import { around, fromZero, ofValues, plain } from "../views/scales.js";

const plainColor = [196, 148, 116];

// Grey from p = 1 to 0.05, and from there on yellow to dark red: a step where p is 0.05.
const significance = [[226, 226, 222], [212, 213, 212], [198, 200, 202], [184, 187, 192], [170, 174, 182], [250, 204, 92], [246, 158, 60], [232, 106, 40], [200, 46, 32], [128, 0, 38]];

function positionOfP(p) {
  if (Number.isNaN(p)) return NaN;
  const last = 4 / 9, first = 5 / 9;
  return p >= 0.05 ? last * (Math.log(p) / Math.log(0.05)) : first + (1 - first) * Math.min(1, Math.log(0.05 / p) / Math.log(50));
}

function lengthsOf(vectors, factor = 1) {
  return Float32Array.from({ length: vectors.length / 3 }, (_, i) => factor * Math.hypot(vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]));
}

// A scale that holds while modes are moved: up to what three standard deviations of the mode that moves most reach.
function displacement(model) {
  const lists = model.modes.map((mode) => lengthsOf(mode, 3)), largest = lists.reduce((best, list) => (quantile(list, 0.98) > quantile(best, 0.98) ? list : best), lists[0]);
  const scale = fromZero([largest], `distance from the mean shape (${model.length})`);
  return {
    name: "Displacement from the mean", note: "Of each point of the shape shown, from where it is in the mean.", scale, moves: true,
    colors: (positions) => ofValues(lengthsOf(positions.map((x, i) => x - model.mean[i])), scale),
  };
}

function differences(model) {
  const a = model.arrays, d = model.data.difference, pair = `“${d.group_b}” minus “${d.group_a}”`;
  const of = (scale, values) => ({ scale, colors: () => ofValues(values, scale) });
  const share = d.significant_share === undefined ? "" : d.significant_share > 0 ? ` Below 0.05 on ${percent(d.significant_share).replace(" ", "\u00a0")} of the ${model.dimension === 3 ? "surface" : "curve"} (yellow to red).` : " Nowhere below 0.05.";
  return {
    difference: { name: "Difference of groups", note: `Length of mean of ${pair}, at each point.`, ...of(fromZero([a.difference], `difference (${model.length})`), a.difference) },
    normal: { name: "Difference, along the normal", note: `Mean of ${pair} along the outward normal: red where “${d.group_b}” lies further out.`,
      ...of(around(a.difference_normal, `normal difference (${model.length})`), a.difference_normal) },
    p: { name: "Difference, corrected p", note: `Of ${d.permutations} permutations, corrected for all points.${share}`,
      ...of({ map: significance, label: "corrected p (no unit)", ticks: ["1", "0.05", `≤ ${figure(0.001)}`], position: positionOfP }, a.p_corrected) },
  };
}

/** The ways of colouring, by key: name, note, a scale where there is one, and colors(positions); `moves`: they depend on the shape shown. */
export function colorings(model) {
  const a = model.arrays, list = { plain: { name: "Plain", note: "One colour.", colors: () => plain(model.mean.length / 3, plainColor) } };
  if (a.deviation) {
    const scale = fromZero([a.deviation], `standard deviation (${model.length})`);
    list.deviation = { name: "Standard deviation", note: "Of each point about the mean, over the cohort.", scale, colors: () => ofValues(a.deviation, scale) };
  }
  if (model.modes.length > 0) list.displacement = displacement(model);
  if (model.data.difference) Object.assign(list, differences(model));
  for (const coloring of Object.values(list)) {
    const make = coloring.colors;
    let made;
    if (!coloring.moves) coloring.colors = () => (made ??= make());
  }
  return list;
}
