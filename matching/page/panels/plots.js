// Energy over the steps, and distances over the levels.

import { CategoryScale, Chart, LogarithmicScale } from "chart.js";
import { figure } from "../data/format.js";
import { chart, lineColors, plotBoxes } from "./chart.js";
import { section } from "./dom.js";

Chart.register(CategoryScale, LogarithmicScale);

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

// An axis in powers of ten.
const logarithmic = (words) => ({ type: "logarithmic", words, callback: (value) => (Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-9 ? figure(value, 1) : "") });

function energyChart(canvas, model, scheme) {
  const { names, series, starts, last } = energySeries(model);
  const datasets = names.map((label, k) => ({ label, data: series[k], borderColor: k === 0 ? scheme.text : lineColors[k % lineColors.length], backgroundColor: "transparent",
    borderWidth: k === 0 ? 2 : 1.3, pointRadius: 0, pointHitRadius: 4 }));
  return chart(canvas, scheme, { type: "linear", min: 0, max: last, words: "accepted steps (lines: begin of a level)" }, logarithmic("energy (unit domain)"), { datasets, plugins: [levelLines(starts, scheme.text)] });
}

function distanceChart(canvas, model, scheme) {
  const { levels, template_diagonal: diagonal } = model.summary, measured = levels.filter((l) => l.distance);
  const ways = [["result → template", "deformed_to_template", lineColors[1]], ["template → result", "template_to_deformed", lineColors[2]]];
  const datasets = ways.flatMap(([name, key, color]) => [["mean", []], ["max", [4, 3]]].map(([what, dash]) => ({
    label: `${name}, ${what}`, data: measured.map((l) => ({ x: String(l.level), y: l.distance[key][what] * (diagonal ?? 1) })),
    borderColor: color, backgroundColor: color, borderDash: dash, borderWidth: 1.5, pointRadius: 2.5 })));
  return chart(canvas, scheme, { type: "category", labels: measured.map((l) => String(l.level)), words: "level" }, logarithmic(`distance (${model.unit || "file units"})`), { datasets });
}

/** \returns the panel and a function that draws it in a scheme of colours */
export function plotsPanel(model) {
  const { boxes, show } = plotBoxes([(canvas, scheme) => energyChart(canvas, model, scheme), "Energy and its terms over the accepted steps"],
    [(canvas, scheme) => distanceChart(canvas, model, scheme), "Distances at the end of each level"]);
  return { panel: section("Course of the run", true, ...boxes), show };
}
