// What is set below the view: the shape, its modes, colours.

import { figure } from "../data/format.js";
import { element } from "../panels/dom.js";
import { checkbox, playButton, slider } from "../panels/inputs.js";
import { fillLegend } from "../panels/legend.js";

const sigmas = (x) => `${x < 0 ? "−" : x > 0 ? "+" : ""}${Math.abs(x).toFixed(1)} SD`;

// The choice of a whole shape: the mean, those of groups, subjects by their names.
function shapeChoice(model, take) {
  const subjects = model.subjects.filter((s) => s.scores).sort((a, b) => a.id.localeCompare(b.id, undefined, { numeric: true }));
  const option = (value, text) => element("option", { value }, text);
  const groups = model.groups.filter((g) => g !== "");
  const choice = element("select", { id: "shape", title: "The shape that is shown", onchange: () => {
    const [kind, number] = choice.value.split(" ");
    if (kind === "mean") take(model.modes.map(() => 0), {});
    if (kind === "group") take(model.meanScores(groups[+number]), { group: groups[+number] });
    if (kind === "subject") take([...model.subjects[+number].scores], { subject: +number });
  } },
    option("mean", "mean of all"), ...groups.map((g, i) => option(`group ${i}`, `mean of group ${g}`)), ...subjects.map((s) => option(`subject ${s.rank}`, s.id)), element("option", { value: "free", hidden: true }, "as the sliders say"));
  return choice;
}

// A slider for each mode, with a button that lets it swing.
function modeSliders(model, state, taken) {
  const players = [];
  const rows = model.modes.map((_, k) => {
    const take = (x) => {
      state.b[k] = x;
      state.mode = k;
      taken({});
    };
    const row = slider(`mode-${k + 1}`, `${k + 1} (${model.shareText(k)})`, -3, 3, 0.05, 0, take, () => {}, sigmas);
    row.box.title = `Mode ${k + 1}: ${model.shareText(k)} of the variance; one standard deviation (SD) is ${figure(model.deviation(k))} ${model.length} (root mean square over the points)`;
    row.box.querySelector("input").setAttribute("aria-label", `Mode ${k + 1}, in standard deviations`);
    let phase = 0;
    const player = playButton({ title: `Play mode ${k + 1}` }, () => {
      players.forEach((p) => p !== player && p.stop());
      phase = Math.asin(Math.min(Math.max(state.b[k] / 3, -1), 1));
    }, (seconds) => {
      take(3 * Math.sin(phase + seconds * 1.6));
      return true;
    });
    row.box.prepend(player.button);
    row.box.querySelector("input").addEventListener("input", player.stop);
    players.push(player);
    return row;
  });
  return { rows, players };
}

/**
 * \param state b, subject, group, coloring, overlay: changed by the controls, after which `changed` is called
 * \returns what the keyboard and the panels may do
 */
export function addControls(container, model, colorings, state, changed, resetView) {
  const taken = ({ subject = null, group = null }) => {
    Object.assign(state, { subject, group });
    changed();
  };
  const stop = () => players.forEach((player) => player.stop());
  const take = (b, whose) => {
    stop();
    state.b = b;
    taken(whose);
  };
  const choice = shapeChoice(model, take);
  const { rows, players } = modeSliders(model, state, taken);
  const legend = element("div", { id: "legend", "aria-live": "polite" });
  const coloring = element("select", { id: "coloring", title: "Colours (C)", onchange: () => { state.coloring = coloring.value; changed(); } },
    ...Object.entries(colorings).map(([key, { name }]) => element("option", { value: key }, name)));
  const overlay = checkbox("overlay", "Mean over it", state.overlay, (value) => { state.overlay = value; changed(); });
  const hasModes = rows.length > 0;
  container.append(
    element("div", { class: "row" }, hasModes ? element("label", { class: "choice" }, "Shape", choice) : null, hasModes ? overlay : null,
      hasModes ? element("button", { type: "button", id: "reset-modes", title: "All modes at 0", onclick: () => take(model.modes.map(() => 0), {}) }, "Reset modes") : null,
      element("button", { type: "button", id: "reset", title: "The first view (0)", onclick: resetView }, "Reset view")),
    element("div", { class: "row" }, element("label", { class: "choice" }, "Colours", coloring), legend),
    hasModes ? element("p", { class: "caption" }, "Modes with their share of the variance, in standard deviations (SD)") : "",
    element("div", { id: "modes" }, ...rows.map((row) => row.box)));
  return {
    take,
    /** Shows what the state says. */
    refresh: () => {
      const { scale, note } = colorings[state.coloring];
      fillLegend(legend, scale, note);
      coloring.value = state.coloring;
      rows.forEach((row, k) => row.set(state.b[k]));
      const groups = model.groups.filter((g) => g !== "");
      choice.value = state.subject !== null ? `subject ${state.subject}` : state.group !== null ? `group ${groups.indexOf(state.group)}` : state.b.some((x) => x !== 0) ? "free" : "mean";
    },
    togglePlaying: () => players[state.mode]?.toggle(),
    nextColoring: () => {
      const keys = Object.keys(colorings);
      state.coloring = keys[(keys.indexOf(state.coloring) + 1) % keys.length];
      changed();
    },
  };
}
