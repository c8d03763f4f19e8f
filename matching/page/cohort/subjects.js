// The subjects in a table, the worst first; it can be sorted and filtered.

import { figure, percent } from "../data/format.js";
import { element, section } from "../panels/dom.js";

// A path relative to the page: its parts are names, also where they look like something else.
function reportAddress(folder) {
  return `./${folder.split("/").map(encodeURIComponent).join("/")}/report.html`;
}

function distanceCell(subject, way) {
  const d = subject.distance?.[way];
  if (!d) return element("td", {}, "–");
  return element("td", { title: `mean ${figure(d.mean * subject.diagonal)} (${percent(d.mean)}), 95 % within ${figure(d.p95 * subject.diagonal)} (${percent(d.p95)})` },
    figure(d.max * subject.diagonal), element("small", {}, percent(d.max)));
}

function reasons(subject) {
  const list = subject.reasons.map((reason) => element("li", { title: reason.advice }, reason.what));
  return [subject.message ? element("p", { class: "why" }, subject.message) : null, list.length > 0 ? element("ul", { class: "why" }, ...list) : null,
    subject.bent ? element("p", { class: "why", title: "as rigidly as possible: the map is one of its surface" }, "atlas bent before") : null,
    subject.finished && subject.column === undefined ? element("p", { class: "why" }, "not in the statistics") : null];
}

function rowOf(subject, hasGroups, show) {
  const name = subject.column === undefined ? element("span", {}, subject.id) : element("button", { type: "button", class: "name", title: "Show this shape", onclick: show }, subject.id);
  const picture = subject.thumbnail ? element("img", { class: "thumbnail", alt: "", src: `data:image/png;base64,${subject.thumbnail}`, onclick: show }) : null;
  return element("tr", {}, element("td", { class: "picture" }, picture),
    element("th", { scope: "row" }, name, subject.has_page ? element("a", { href: reportAddress(subject.folder), target: "_blank", rel: "noopener" }, "report") : null),
    hasGroups ? element("td", { class: "words" }, subject.group) : null, distanceCell(subject, "atlas_to_subject"), distanceCell(subject, "subject_to_atlas"),
    element("td", { class: "words" }, element("span", { class: `outcome ${subject.kind}` }, subject.result), ...reasons(subject)));
}

const byText = (key) => (a, b) => a[key].localeCompare(b[key], undefined, { numeric: true });
// What was not measured is last.
const byDistance = (way) => (a, b) => (b.distance?.[way].max ?? -1) - (a.distance?.[way].max ?? -1) || a.rank - b.rank;

/** \param show (rank) shows a subject's shape \returns the panel, and mark(rank) for the row that is shown */
export function subjectsPanel(model, show) {
  const { subjects, data } = model, hasGroups = subjects.some((s) => s.group !== "");
  const rows = subjects.map((s) => rowOf(s, hasGroups, () => s.column !== undefined && show(s.rank)));
  const texts = subjects.map((s) => [s.id, s.group, s.result, s.message, ...s.reasons.map((r) => r.what)].join(" ").toLowerCase());
  const body = element("tbody"), count = element("span", { class: "caption", "aria-live": "polite" });
  const columns = [[null, ""], ["id", "subject", byText("id")], ...(hasGroups ? [["group", "group", byText("group")]] : []),
    ["there", "atlas → subject", byDistance("atlas_to_subject")], ["back", "subject → atlas", byDistance("subject_to_atlas")], ["verdict", "verdict", (a, b) => a.rank - b.rank]];
  let key = "verdict", turned = false;
  const filter = element("input", { type: "search", id: "filter", placeholder: "filter", "aria-label": "Filter the subjects by text", oninput: () => fill() });
  const heads = columns.map(([name, text]) => element("th", { scope: "col" }, name ? element("button", { type: "button", class: "sort", id: `sort-${name}`, onclick: () => {
    turned = key === name && !turned;
    key = name;
    fill();
  } }, text) : text));
  const fill = () => {
    const wanted = filter.value.trim().toLowerCase(), compare = columns.find(([name]) => name === key)[2];
    const shown = subjects.filter((s) => texts[s.rank].includes(wanted)).sort((a, b) => (turned ? -1 : 1) * compare(a, b));
    body.replaceChildren(...shown.map((s) => rows[s.rank]));
    count.textContent = `${shown.length} of ${subjects.length}`;
    heads.forEach((head, i) => head.setAttribute("aria-sort", columns[i][0] !== key ? "none" : turned ? "descending" : "ascending"));
  };
  fill();
  const { scale_end: end, left_out: leftOut } = data.thumbnails;
  const panel = section("Subjects", true,
    element("p", { class: "caption" }, `The worst first. Greatest distances in ${model.length}, and below over the diagonal of the subject's box; means under the pointer.`),
    element("div", { class: "row" }, filter, count),
    element("div", { class: "rows", id: "subjects" }, element("table", { class: hasGroups ? "grouped" : "" }, element("thead", {}, element("tr", {}, ...heads)), body)),
    rows.length > 0 && subjects.some((s) => s.thumbnail) ? element("p", { class: "caption" }, `Pictures: the atlas on each subject, as the statistics have it, from one side.${end > 0 ? ` Colours: distance from the mean shape, from 0 (dark) to ${figure(end)} ${model.length} and more (yellow).` : ""}${leftOut > 0 ? ` ${leftOut} subjects, the best ones, have no picture, to keep this page small.` : ""}`) : null);
  return { panel, mark: (rank) => rows.forEach((row, i) => row.classList.toggle("shown", i === rank)) };
}
