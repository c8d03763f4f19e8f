// Energy over the steps, and distances over the levels.

import { CategoryScale, Chart, Legend, LinearScale, LineController, LineElement, LogarithmicScale, PointElement, Tooltip } from "chart.js";
import { figure } from "../data/format.js";
import { element, section } from "./dom.js";

Chart.register(CategoryScale, Legend, LinearScale, LineController, LineElement, LogarithmicScale, PointElement, Tooltip);

const lineColors = ["#8a8f98", "#d1642c", "#3b7dd8", "#2f9e6e", "#b04fb3", "#c2a21f", "#5d6ac9"];

// Steps of all minimisations one after another. Another nu changes the energy, so that the lines are interrupted.
function energySeries(model) {
  const a = model.arrays, energy = a["history.energy"], levels = a["history.level"], substeps = a["history.substep"];
  const names = ["sum", ...model.data.terms], values = [energy, ...model.data.terms.map((term) => a[`history.${term}`])];
  const largest = energy.reduce((m, x) => Math.max(m, x), 0), series = names.map(() => []), starts = [];
  let step = 0;
  for (let i = 0; i < energy.length; ++i) {
    if (i > 0 && levels[i] === levels[i - 1] && substeps[i] === substeps[i - 1]) ++step;
    else series.forEach((s) => s.push({ x: step, y: NaN }));
    if (i === 0 || levels[i] !== levels[i - 1]) starts.push({ x: step, level: levels[i] });
    // Rounding errors would take up most of the logarithmic axis.
    values.forEach((v, k) => series[k].push({ x: step, y: v[i] > 1e-5 * largest ? v[i] : NaN }));
  }
  return { names, series, starts, last: step };
}

// Lines where levels begin, with their numbers.
function levelLines(starts, ink) {
  return {
    id: "levels",
    beforeDatasetsDraw({ ctx, chartArea: { top, bottom }, scales: { x } }) {
      ctx.save();
      ctx.strokeStyle = ctx.fillStyle = ink;
      ctx.lineWidth = 1;
      ctx.font = "10px system-ui, sans-serif";
      let free = -Infinity;
      for (const start of starts) {
        const at = Math.round(x.getPixelForValue(start.x)) + 0.5;
        ctx.globalAlpha = 0.35;
        ctx.beginPath();
        ctx.moveTo(at, top);
        ctx.lineTo(at, bottom);
        ctx.stroke();
        ctx.globalAlpha = 0.8;
        if (at >= free) ctx.fillText(String(start.level), at + 3, top + 9);
        free = Math.max(free, at + 14);
      }
      ctx.restore();
    },
  };
}

function chart(canvas, scheme, datasets, xAxis, yTitle, plugins = []) {
  const text = { color: scheme.text, font: { size: 11, family: "system-ui, sans-serif" } };
  const title = (words) => ({ display: true, text: words, ...text });
  const power = (value) => (Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-9 ? figure(value, 1) : "");
  return new Chart(canvas, {
    type: "line",
    data: { datasets },
    plugins,
    options: {
      animation: false, responsive: true, maintainAspectRatio: false, normalized: true, spanGaps: false,
      interaction: { mode: "nearest", axis: "x", intersect: false },
      scales: {
        x: { ...xAxis, title: title(xAxis.words), ticks: { ...text, maxRotation: 0 }, grid: { color: scheme.faint, drawBorder: false } },
        y: { type: "logarithmic", title: title(yTitle), ticks: { ...text, callback: power }, grid: { color: scheme.faint, drawBorder: false } },
      },
      plugins: {
        legend: { position: "bottom", labels: { ...text, boxWidth: 12, boxHeight: 2, padding: 6 } },
        tooltip: { callbacks: { title: ([item]) => `${xAxis.words.split(" (")[0]} ${item.label}`, label: ({ dataset, parsed }) => `${dataset.label}: ${figure(parsed.y)}` } },
      },
    },
  });
}

function energyChart(canvas, model, scheme) {
  const { names, series, starts, last } = energySeries(model);
  const datasets = names.map((label, k) => ({ label, data: series[k], borderColor: k === 0 ? scheme.text : lineColors[k % lineColors.length], backgroundColor: "transparent",
    borderWidth: k === 0 ? 2 : 1.3, pointRadius: 0, pointHitRadius: 4 }));
  return chart(canvas, scheme, datasets, { type: "linear", min: 0, max: last, words: "accepted steps (lines: begin of a level)" }, "energy (unit domain)", [levelLines(starts, scheme.text)]);
}

function distanceChart(canvas, model, scheme) {
  const { levels, template_diagonal: diagonal } = model.summary, measured = levels.filter((l) => l.distance);
  const ways = [["result → template", "deformed_to_template", lineColors[1]], ["template → result", "template_to_deformed", lineColors[2]]];
  const datasets = ways.flatMap(([name, key, color]) => [["mean", []], ["max", [4, 3]]].map(([what, dash]) => ({
    label: `${name}, ${what}`, data: measured.map((l) => ({ x: String(l.level), y: l.distance[key][what] * (diagonal ?? 1) })),
    borderColor: color, backgroundColor: color, borderDash: dash, borderWidth: 1.5, pointRadius: 2.5 })));
  return chart(canvas, scheme, datasets, { type: "category", labels: measured.map((l) => String(l.level)), words: "level" }, `distance (${model.unit || "file units"})`);
}

/** \returns the panel and a function that draws it in a scheme of colours */
export function plotsPanel(model) {
  const canvases = [energyChart, distanceChart].map((draw) => [draw, element("canvas", { role: "img", "aria-label": draw === energyChart ? "Energy and its terms over the accepted steps" : "Distances at the end of each level" })]);
  let charts = [];
  const show = (scheme) => {
    charts.forEach((c) => c.destroy());
    charts = canvases.map(([draw, canvas]) => draw(canvas, model, scheme));
  };
  return { panel: section("Course of the run", true, ...canvases.map(([, canvas]) => element("div", { class: "plot" }, canvas))), show };
}
