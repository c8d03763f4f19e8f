// Scores of two modes against each other, one point for each subject.

import { Chart, ScatterController } from "chart.js";
import { figure } from "../data/format.js";
import { chart, lineColors } from "../panels/chart.js";
import { element, section } from "../panels/dom.js";

Chart.register(ScatterController);

const colors = [lineColors[2], lineColors[1], ...lineColors.slice(3), lineColors[0]];

function modeChoice(model, id, label, value, changed) {
  const choice = element("select", { id, onchange: () => changed(+choice.value) }, ...model.modes.map((_, k) => element("option", { value: String(k) }, `mode ${k + 1} (${model.shareText(k)})`)));
  choice.value = String(value);
  return element("label", { class: "choice" }, label, choice);
}

/** \param show (rank) shows a subject's shape \returns the panel, and functions that draw it in a scheme and mark what is shown */
export function scatterPanel(model, show) {
  if (model.modes.length === 0) return { panel: section("Scores", false, element("p", {}, "There are no modes: these need two subjects at least, which differ.")), draw: () => {}, mark: () => {} };
  const axes = [0, Math.min(1, model.modes.length - 1)], subjects = model.subjects.filter((s) => s.scores);
  const canvas = element("canvas", { id: "scatter", role: "img", "aria-label": "Scores of the subjects; a shape can also be chosen below the view or in the table" });
  let plot = null, scheme = null, shown = [];
  const place = (b) => ({ x: b[axes[0]] * model.deviation(axes[0]), y: b[axes[1]] * model.deviation(axes[1]) });
  const datasets = () => [
    ...model.groups.map((group, i) => ({ label: group || "no group", backgroundColor: colors[i % colors.length], borderColor: colors[i % colors.length], pointRadius: 4.5, pointHoverRadius: 6.5,
      data: subjects.filter((s) => s.group === group).map((s) => ({ ...place(s.scores), rank: s.rank })) })),
    { label: "shown", data: [place(shown)], pointRadius: 8, pointHoverRadius: 8, pointHitRadius: 0, borderWidth: 2, pointBackgroundColor: "transparent", backgroundColor: "transparent", borderColor: scheme.text },
  ];
  const subjectAt = (event) => plot.getElementsAtEventForMode(event, "nearest", { intersect: true }, false).map(({ datasetIndex, index }) => plot.data.datasets[datasetIndex].data[index].rank).find((rank) => rank !== undefined);
  const axis = (k) => ({ type: "linear", grace: "6%", words: `score of mode ${k + 1} (${model.length})` });
  const draw = (newScheme) => {
    scheme = newScheme;
    plot?.destroy();
    plot = chart(canvas, scheme, axis(axes[0]), axis(axes[1]), {
      type: "scatter", datasets: datasets(), interaction: { mode: "nearest", intersect: true },
      onClick: (event) => { const rank = subjectAt(event); if (rank !== undefined) show(rank); },
      onHover: (event) => { canvas.style.cursor = subjectAt(event) === undefined ? "" : "pointer"; },
      legend: { boxHeight: 8, boxWidth: 8, usePointStyle: true },
      tooltip: { title: () => "", label: ({ raw, dataset }) => (raw.rank === undefined ? "shown" : `${model.subjects[raw.rank].id} (${dataset.label}): ${figure(raw.x)}, ${figure(raw.y)}`) },
    });
  };
  const choices = ["across", "up"].map((label, i) => modeChoice(model, `axis-${"xy"[i]}`, label, axes[i], (k) => { axes[i] = k; draw(scheme); }));
  const panel = section("Scores", true, element("p", { class: "caption" }, "Each point is a subject; a click shows its shape. Scores are root mean square displacements of the points from the mean."),
    element("div", { class: "row" }, ...choices), element("div", { class: "plot scatter" }, canvas));
  return {
    panel,
    draw,
    mark: (b) => {
      shown = b;
      if (!plot) return;
      plot.data.datasets[plot.data.datasets.length - 1].data = [place(b)];
      plot.update();
    },
    /** What the tooltip says, line by line. */
    hovered: () => plot.tooltip.body.flatMap(({ lines }) => lines),
    /** Where a subject's point is, in pixels of the canvas. */
    pixelOf: (rank) => { const { x, y } = place(model.subjects[rank].scores); return [plot.scales.x.getPixelForValue(x), plot.scales.y.getPixelForValue(y)]; },
  };
}
