// Plots, in the colours of the page.

import { Chart, Legend, LinearScale, LineController, LineElement, PointElement, Title, Tooltip } from "chart.js";
import { figure } from "../data/format.js";
import { element } from "./dom.js";

Chart.register(Legend, LinearScale, LineController, LineElement, PointElement, Title, Tooltip);

export const lineColors = ["#8a8f98", "#d1642c", "#3b7dd8", "#2f9e6e", "#b04fb3", "#c2a21f", "#5d6ac9"];

/**
 * \param x, y settings of the axes: `words` for the title, `callback` for the ticks where they are not Chart.js' own
 * \param plot the rest: datasets, type, plugins, what differs in the legend's labels and the tooltips, and further options
 */
export function chart(canvas, scheme, x, y, { type = "line", datasets, plugins = [], legend, tooltip, tooltipFilter, ...options }) {
  const text = { color: scheme.text, font: { size: 11, family: "system-ui, sans-serif" } };
  const axis = ({ words, callback, ...settings }, title) => ({ ...settings, title,
    ticks: { ...text, maxRotation: 0, ...(callback && { callback }) }, grid: { color: scheme.faint, drawBorder: false } });
  return new Chart(canvas, {
    type,
    data: { datasets },
    plugins,
    options: {
      animation: false, responsive: true, maintainAspectRatio: false, normalized: true, spanGaps: false,
      interaction: { mode: "nearest", axis: "x", intersect: false },
      scales: { x: axis(x, { display: true, text: x.words, ...text }), y: axis(y, { display: false }) },
      ...options,
      plugins: {
        // What goes up stands above, on one line: along the axis, low plots would cut it.
        title: { display: true, text: y.words, position: "top", align: "start", padding: { top: 0, bottom: 4 }, color: text.color, font: { ...text.font, weight: "normal" } },
        legend: { position: "bottom", labels: { ...text, boxWidth: 12, boxHeight: 2, padding: 6, ...legend } },
        tooltip: { ...(tooltipFilter && { filter: tooltipFilter }), callbacks: { title: ([item]) => `${x.words.split(" (")[0]} ${item.label}`, label: ({ dataset, parsed }) => `${dataset.label}: ${figure(parsed.y)}`, ...tooltip } },
      },
    },
  });
}

/** The plots of a panel: their boxes, and a function that draws them in a scheme. \param plots [draw(canvas, scheme), description] each */
export function plotBoxes(...plots) {
  const canvases = plots.map(([, label]) => element("canvas", { role: "img", "aria-label": label }));
  let charts = [];
  const show = (scheme) => {
    charts.forEach((c) => c.destroy());
    charts = plots.map(([draw], i) => draw(canvases[i], scheme));
  };
  return { boxes: canvases.map((canvas) => element("div", { class: "plot" }, canvas)), show };
}
