// What the colours of the shapes can mean.

import { figure, quantile } from "../data/format.js";
import { diverging } from "./color_maps.js";
import { around, fromZero, ofValues, plain } from "./scales.js";

const plainColors = { reference: [196, 148, 116], template: [122, 152, 190], result: [196, 148, 116] };

// Position as red, green and blue, softened.
function ofPositions(positions, bounds) {
  const colors = new Uint8Array(positions.length), flat = bounds.high[2] <= bounds.low[2];
  for (let i = 0; i < positions.length; ++i) {
    const k = i % 3, side = bounds.high[k] - bounds.low[k];
    const s = k === 2 && flat ? 0.6 : side > 0 ? (positions[i] - bounds.low[k]) / side : 0.5;
    colors[i] = 70 + 165 * Math.min(Math.max(s, 0), 1);
  }
  return colors;
}

// Ratios on a logarithmic scale that is the same on both sides of 1.
function aroundOne(values, label) {
  const factor = Math.max(Math.exp(quantile(values.map((x) => Math.abs(Math.log(x))), 0.95)), 1.05);
  const end = Math.log(factor);
  return { map: diverging, label, ticks: [`≤ ${figure(1 / factor)}`, "1", `≥ ${figure(factor)}`], position: (x) => 0.5 + Math.log(x) / end / 2 };
}

/**
 * The ways of colouring, by key: name, what it shows, a scale where there is one, and the colours of `reference` (which the result
 * carries along) and `template`. Colours are made when they are first asked for.
 */
export function colorings(model) {
  const a = model.arrays, n = a.reference.length / 3, nTemplate = a.template.length / 3, space = model.dimension === 3;
  const plainTemplate = () => plain(nTemplate, plainColors.template);
  const scaled = (scale, values, templateValues) => ({
    scale,
    reference: () => ofValues(values, scale),
    template: templateValues ? () => ofValues(templateValues, scale) : plainTemplate,
  });
  const list = {
    checker: {
      name: "Checker", note: "A pattern of the reference, carried along by the map.", checker: true,
      reference: () => ofPositions(a.reference, model.referenceBounds), template: plainTemplate,
    },
    position: {
      name: "Position", note: "Colours of the reference's coordinates, carried along by the map.",
      reference: () => ofPositions(a.reference, model.referenceBounds), template: plainTemplate,
    },
    plain: { name: "Plain", note: "Each shape in its own colour.", reference: () => plain(n, plainColors.reference), template: plainTemplate },
    distance: {
      name: "Distance, both ways", note: "Of the result to the template; on the template, of the template to the result. Grey: no data.",
      ...scaled(fromZero([a.distance_to_template, a.distance_to_deformed], `distance (${model.length})`), a.distance_to_template, a.distance_to_deformed),
    },
    measure: {
      name: space ? "Area distortion" : "Length distortion", note: `${space ? "Area" : "Length"} after the map over that before it.`,
      ...scaled(aroundOne(a.measure_ratio, `${space ? "area" : "length"} ratio, after / before (no unit)`), a.measure_ratio),
    },
  };
  if (a.angle_change)
    list.angle = {
      name: "Angle distortion",
      note: "How far a tangent direction turns at most against the principal ones, at each place: half of the largest change of an angle.",
      ...scaled(fromZero([a.angle_change], "largest turn of a direction (degrees)"), a.angle_change),
    };
  list.curvature = {
    name: "Curvature mismatch", note: `${space ? "Mean curvature" : "Curvature"} of the template next to the image, minus that of the reference.`,
    ...scaled(around(a.curvature_change, `difference of ${space ? "mean " : ""}curvature (1 / ${model.unit || "unit of the files"})`), a.curvature_change),
  };
  const made = {};
  for (const [key, coloring] of Object.entries(list))
    for (const shape of ["reference", "template"]) {
      const make = coloring[shape];
      coloring[shape] = () => (made[`${key} ${shape}`] ??= make());
    }
  return list;
}
