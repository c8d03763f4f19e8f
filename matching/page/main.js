// The page of a result: reads its data, and puts views, controls and panels together.

import "./style.css";
import { readModel } from "./data/model.js";
import { addControls } from "./panels/controls.js";
import { byId, element } from "./panels/dom.js";
import { figuresPanel, optionsPanel, shapesPanel, timesPanel } from "./panels/figures.js";
import { begin, followScheme, listenToKeys } from "./panels/page.js";
import { plotsPanel } from "./panels/plots.js";
import { outcomeText, verdictPanel } from "./panels/verdict.js";
import { versionsPanel } from "./panels/versions.js";
import { colorings } from "./views/colorings.js";
import { PlanarView } from "./views/planar_view.js";
import { SpaceView } from "./views/space_view.js";

function addPanes(container, model) {
  const captions = { result: "Result: the reference, moved", reference: `Reference: ${model.names.reference}`, template: `Template: ${model.names.template}` };
  const panes = {};
  for (const name of ["reference", "template", "result"]) {
    panes[name] = element("div", { class: "pane", id: `pane-${name}` }, element("span", { class: "caption" }, captions[name]), element("i", { class: "mark", hidden: true }));
    container.append(panes[name]);
  }
  return panes;
}

// Where surfaces cannot be drawn there is at least a picture.
function messageInstead(stage, model, error) {
  const picture = model.data.picture;
  stage.classList.add("without-views");
  stage.replaceChildren(element("p", { class: "message" }, `The shapes cannot be turned, since this browser offers no WebGL: ${error.message}. All figures are beside.`),
    picture ? element("img", { alt: "Reference, template and result", src: `data:image/png;base64,${picture}` }) : "");
}

function makeView(stage, panes, model, colors) {
  try {
    return new (model.dimension === 3 ? SpaceView : PlanarView)(stage, panes, model, colors);
  } catch (error) {
    messageInstead(byId("views"), model, error);
    byId("controls").hidden = true;
    return null;
  }
}

function showHead(model) {
  const { summary, names } = model, outcome = byId("outcome");
  document.title = `${names.reference} → ${names.template} (shellmatch)`;
  byId("title").textContent = `${names.reference} → ${names.template}`;
  outcome.textContent = outcomeText(summary.verdict);
  outcome.classList.add(summary.verdict?.outcome ?? "none");
  outcome.hidden = false;
  const levels = summary.levels;
  byId("subtitle").textContent = `levels ${levels[0].level} to ${levels[levels.length - 1].level}, lengths in ${model.length}, shown in the template's coordinates${summary.interrupted ? "; stopped before its last level" : ""}`;
  byId("subtitle").title = byId("subtitle").textContent;
}

async function main() {
  const model = await readModel(document), stage = byId("views");
  showHead(model);
  const colors = colorings(model), state = { t: 1, level: model.levels.length - 1, coloring: "checker", overlay: model.summary.verdict?.outcome !== "matched", grid: "none", place: 0.5, cut: false };
  const panes = addPanes(stage, model), view = makeView(stage, panes, model, colors), plots = plotsPanel(model);
  const reset = () => {
    view?.reset();
    document.querySelectorAll(".place[aria-pressed=true]").forEach((button) => button.setAttribute("aria-pressed", "false"));
  };
  byId("panels").append(verdictPanel(model, (place, shape) => {
    state.t = 1;
    state.level = model.levels.length - 1;
    controls?.show();
    view?.flyTo(place, shape);
  }), plots.panel, figuresPanel(model), shapesPanel(model), timesPanel(model), optionsPanel(model), versionsPanel(model.data));
  const controls = view && addControls(byId("controls"), model, colors, state, () => { view.show(state); controls.refresh(); }, reset);
  if (view) {
    listenToKeys(stage, view, controls, reset);
    view.show(state);
  }
  followScheme(byId("scheme"), (scheme) => {
    view?.setScheme(scheme);
    plots.show(scheme);
  });
  // What tests and other programs may ask for.
  window.shellmatchReport = { model, state, view };
}

begin(main);
