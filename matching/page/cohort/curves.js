// How good the model is, by the number of its modes.

import { Chart, Filler } from "chart.js";
import { chart, lineColors, plotBoxes } from "../panels/chart.js";
import { element, section } from "../panels/dom.js";

Chart.register(Filler);

const points = (values, factor = 1) => values.map((y, i) => ({ x: i + 1, y: factor * (y ?? NaN) })).filter(({ y }) => Number.isFinite(y));
const modesAxis = { type: "linear", min: 0, words: "number of modes M", callback: (x) => (x > 0 && Number.isInteger(x) ? x : "") };
const line = (label, data, color) => ({ label, data, borderColor: color, backgroundColor: color, borderWidth: 1.6, clip: 6, pointRadius: data.length > 30 ? 0 : 2.5 });

function varianceChart(canvas, model, scheme) {
  const each = model.data.model.variances.map((_, k) => model.share(k)), compactness = model.data.curves?.compactness ?? each.map((_, k) => each.slice(0, k + 1).reduce((sum, x) => sum + x, 0));
  const datasets = [line("one mode", points(each, 100), lineColors[2]), line("first M modes together (compactness)", points(compactness, 100), lineColors[1])];
  return chart(canvas, scheme, { ...modesAxis, words: "mode, or number of modes M" }, { type: "linear", min: 0, max: 100, words: "variance (%)" }, { datasets });
}

// A curve between its standard errors.
function bandChart(canvas, model, scheme, name, color) {
  const values = model.data.curves[name], errors = model.data.curves[`${name}_error`];
  const edge = (sign, fill) => ({ label: "", data: points(values.map((y, i) => y + sign * (errors[i] ?? 0))), fill, borderWidth: 0, pointRadius: 0, pointHitRadius: 0, backgroundColor: `${color}40` });
  return chart(canvas, scheme, modesAxis, { type: "linear", beginAtZero: true, words: `${name} (${model.length})` }, {
    datasets: [edge(-1, false), edge(1, "-1"), line(`${name}, ± standard error`, points(values), color)],
    legend: { filter: ({ text }) => text !== "" }, tooltipFilter: ({ dataset }) => dataset.label !== "",
  });
}

/** \returns the panel and a function that draws it in a scheme of colours */
export function curvesPanel(model) {
  const { data } = model;
  if (model.modes.length === 0)
    return { panel: section("Model", false, element("p", {}, data.model ? "All shapes are equal: there are no modes." : "There is no model: it needs two subjects at least.")), draw: () => {} };
  const plots = [[(canvas, scheme) => varianceChart(canvas, model, scheme), "Share of the variance in each mode, and in the first modes together"]];
  if (data.curves)
    for (const [name, color] of [["generalisation", lineColors[3]], ["specificity", lineColors[4]]])
      if (points(data.curves[name]).length > 0) plots.push([(canvas, scheme) => bandChart(canvas, model, scheme, name, color), `${name} by the number of modes`]);
  const { boxes, show } = plotBoxes(...plots);
  boxes.forEach((box) => box.classList.add("low"));
  return { panel: section("Model", true, ...boxes, data.curves ? null : element("p", {}, "Generalisation and specificity need three subjects at least.")), draw: show };
}
