// The page of a cohort: reads its data, and puts view, controls and panels together.

import "../style.css";
import "./cohort.css";
import { percent } from "../data/format.js";
import { byId, element } from "../panels/dom.js";
import { begin, followScheme, listenToKeys } from "../panels/page.js";
import { versionsPanel } from "../panels/versions.js";
import { colorings } from "./colorings.js";
import { addControls } from "./controls.js";
import { curvesPanel } from "./curves.js";
import { definitionsPanel } from "./definitions.js";
import { groupsPanel, roundsPanel } from "./groups.js";
import { readCohort } from "./model.js";
import { CohortPlanarView } from "./planar_view.js";
import { scatterPanel } from "./scatter.js";
import { CohortSpaceView } from "./space_view.js";
import { subjectsPanel } from "./subjects.js";

// How many subjects have each result, the worst first.
function chips(model) {
  const counts = new Map();
  for (const { result, kind } of model.subjects) counts.set(result, { kind, n: (counts.get(result)?.n ?? 0) + 1 });
  return Array.from(counts, ([result, { kind, n }]) => element("span", { class: `outcome ${kind}` }, `${n} ${result}`));
}

function showHead(model) {
  const { data, subjects } = model, title = data.title || "Cohort", n = subjects.length, inModel = subjects.filter((s) => s.column !== undefined).length;
  const last = data.rounds[data.rounds.length - 1], subtitle = byId("subtitle");
  document.title = `${title} (shellmatch)`;
  byId("title").textContent = title;
  byId("outcome").replaceWith(...chips(model));
  subtitle.textContent = [`${n} subject${n === 1 ? "" : "s"}, ${inModel === n ? "all" : inModel} in the statistics`, `lengths in ${model.length}`,
    last ? `atlas of ${data.rounds.length} round${data.rounds.length === 1 ? "" : "s"}, last change ${percent(last.change ?? NaN)} of the diagonal` : null].filter(Boolean).join("; ");
  subtitle.title = subtitle.textContent;
}

function captionOf(model, state) {
  const { data } = model;
  if (data.shape === "atlas") return "The atlas: no subject is in the statistics";
  if (data.shape === "subject") return `The atlas on ${model.subjects.find((s) => s.column !== undefined).id}, the only subject in the statistics`;
  if (state.subject !== null) return `${model.subjects[state.subject].id}: mean + its scores on ${model.modes.length} mode${model.modes.length === 1 ? "" : "s"}`;
  if (state.group !== null) return `Mean of group ${state.group}`;
  return state.b.some((x) => x !== 0) ? "Mean + modes" : "Mean shape";
}

function makeView(stage, pane, model, colors) {
  try {
    return new (model.dimension === 3 ? CohortSpaceView : CohortPlanarView)(stage, { shape: pane }, model, colors);
  } catch (error) {
    stage.classList.add("without-views");
    stage.replaceChildren(element("p", { class: "message" }, `Shapes cannot be turned, since this browser offers no WebGL: ${error.message}. Pictures and figures are beside.`));
    return null;
  }
}

async function main() {
  const model = await readCohort(document), stage = byId("views"), colors = colorings(model);
  showHead(model);
  const state = { b: model.modes.map(() => 0), mode: 0, subject: null, group: null, coloring: colors.deviation ? "deviation" : "plain", overlay: false };
  const caption = element("span", { class: "caption", id: "caption" }), pane = element("div", { class: "pane", id: "pane-shape" }, caption);
  stage.append(pane);
  const view = makeView(stage, pane, model, colors);
  let b = null;
  const changed = () => {
    // The same shape keeps its array, so that a view sees that it is the same.
    if (!b || b.some((x, k) => x !== state.b[k])) state.positions = model.shapeOf((b = [...state.b]));
    caption.textContent = captionOf(model, state);
    view?.show(state);
    controls.refresh();
    subjects.mark(state.subject);
    scatter.mark(state.b);
  };
  const reset = () => view?.reset();
  const controls = addControls(byId("controls"), model, colors, state, changed, reset);
  const show = (rank) => { if (model.subjects[rank].scores) controls.take([...model.subjects[rank].scores], { subject: rank }); };
  const subjects = subjectsPanel(model, show), scatter = scatterPanel(model, show), curves = curvesPanel(model);
  byId("panels").append(...[subjects.panel, scatter.panel, groupsPanel(model), curves.panel, roundsPanel(model), definitionsPanel(model), versionsPanel(model.data)].filter(Boolean));
  if (view) listenToKeys(stage, view, controls, reset);
  else byId("controls").hidden = true;
  changed();
  followScheme(byId("scheme"), (scheme) => {
    view?.setScheme(scheme);
    scatter.draw(scheme);
    curves.draw(scheme);
  });
  // What tests and other programs may ask for.
  window.shellmatchReport = { model, state, view, scatter };
}

begin(main);
