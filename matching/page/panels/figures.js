// The figures of the result, in tables.

import { bytes, figure, integer, percent, seconds } from "../data/format.js";
import { element, section, table } from "./dom.js";

// Summaries state distances in diagonals of the template.
function distanceTable(model) {
  const { summary } = model, diagonal = summary.template_diagonal ?? NaN;
  const cells = (d) => ["mean", "p95", "max"].map((key) => element("span", {}, figure(d[key] * diagonal), element("small", {}, percent(d[key]))));
  const rows = [["result → template", ...cells(summary.distance.deformed_to_template)], ["template → result", ...cells(summary.distance.template_to_deformed)]];
  if (summary.distance_before)
    rows.push(["reference → template", ...cells(summary.distance_before.deformed_to_template)], ["template → reference", ...cells(summary.distance_before.template_to_deformed)]);
  return [element("p", { class: "caption" }, `Distances in ${model.length}, and below in per cent of the template's diagonal (${figure(diagonal)} ${model.unit || "units"}); the last two rows are from before the run`),
    table(["", "mean", "95 %", "largest"], rows)];
}

export function figuresPanel(model) {
  const { summary } = model, last = summary.levels[summary.levels.length - 1], rows = [];
  const spread = (d, unit) => `${figure(d.p5 ?? d.min)} to ${figure(d.p95 ?? d.max)}${unit}`;
  if (summary.distance?.uncovered !== undefined) rows.push(["template not reached within 1 % of its diagonal", percent(summary.distance.uncovered)]);
  if (summary.area_distortion) rows.push([`${model.dimension === 3 ? "area" : "length"} ratio, 90 % of the ${model.dimension === 3 ? "surface" : "curve"}`, spread(summary.area_distortion, "")]);
  if (summary.angle_distortion) rows.push(["largest turn of a direction, 90 % of the surface", spread(summary.angle_distortion, "°")]);
  if (summary.flipped_share !== undefined) rows.push(["facing away from the template", percent(summary.flipped_share)]);
  rows.push(["smallest det Dφ", figure(last.folds.min_determinant)], ["folded cells", integer(last.folds.folded_cells)]);
  if (summary.correspondence_error !== undefined) rows.push(["mean error of known correspondences, of the diagonal", percent(summary.correspondence_error)]);
  if (summary.alignment) rows.push(["reference was turned before by", `${figure(summary.alignment.angle)}°${summary.alignment.mirrored ? ", mirrored" : ""}`]);
  if (summary.bent) rows.push(["reference was bent before", "as rigidly as possible: the map is one of its surface"]);
  return section("Figures", true, ...(summary.distance ? distanceTable(model) : []), table(null, rows));
}

export function shapesPanel(model) {
  const { summary } = model;
  const describe = (shape) => [integer(shape.vertices), integer(shape.facets), shape.components ?? "", shape.genus ?? ""];
  const notes = [["reference", summary.reference], ["template", summary.template]].flatMap(([name, shape]) => shape.notes.map((note) => element("li", {}, `${name}: ${note}`)));
  return section("Shapes", false,
    table(["", "vertices", model.dimension === 3 ? "triangles" : "segments", "parts", "genus"], [["reference", ...describe(summary.reference)], ["template", ...describe(summary.template)]]),
    element("p", { class: "file" }, `reference: ${summary.reference.file}`), element("p", { class: "file" }, `template: ${summary.template.file}`),
    notes.length > 0 ? element("ul", {}, ...notes) : null);
}

export function timesPanel(model) {
  const { run, levels } = model.summary;
  const rows = levels.map((level, i) => [String(level.level), seconds(run.level_seconds[i] ?? NaN), integer(level.iterations), integer(level.free_nodes), integer(level.cells)]);
  const phases = Object.entries(run.phase_seconds).sort(([, a], [, b]) => b - a).map(([name, s]) => [name, seconds(s)]);
  return section("Times and sizes", false,
    element("p", {}, `${seconds(run.seconds)} until this report was written, on ${run.threads} thread${run.threads === 1 ? "" : "s"}; at most ${bytes(run.peak_memory_bytes)} of memory.`),
    table(["level", "time", "steps", "free nodes", "cells"], rows), element("p", { class: "caption" }, "Phases of the run"), table(null, phases));
}

export function optionsPanel(model) {
  const { options } = model.data;
  const row = (o) => element("tr", { title: o.meaning }, element("th", { scope: "row" }, o.name), element("td", {}, o.value), element("td", {}, o.unit));
  const body = element("tbody");
  const show = (all) => body.replaceChildren(...options.filter((o) => all || o.default !== undefined).map(row));
  const all = element("input", { type: "checkbox", onchange: () => show(all.checked) });
  show(false);
  return section("Options", false, element("p", {}, `Profile ${model.summary.profile}; those that differ from its defaults. The meaning of an option appears under the pointer.`),
    element("label", { class: "check" }, all, "show all"), element("table", { class: "options" }, body));
}
