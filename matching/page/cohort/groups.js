// Figures of the difference of two groups, and of the rounds of the atlas.

import { figure, integer, percent } from "../data/format.js";
import { element, section, table } from "../panels/dom.js";

const pValue = (p) => (p < 0.001 ? figure(p, 1) : figure(p, 2));

export function groupsPanel(model) {
  const d = model.data.difference;
  if (!d) return null;
  const smallest = model.arrays.p_corrected.reduce((least, p) => (p < least ? p : least), 1), where = model.dimension === 3 ? "surface" : "curve";
  return section("Groups", true, element("p", { class: "caption" }, "Permutation tests of the difference of the means; where it lies, the colours show."), table(["", d.group_a, d.group_b], [["subjects", integer(d.n_a), integer(d.n_b)]]),
    table(null, [
      [`distance of the means (root mean square, ${model.length})`, figure(d.distance)],
      [`p of this distance, ${d.all_permutations ? `all ${integer(d.permutations)} permutations` : `${integer(d.permutations)} permutations at random`}`, pValue(d.global_p)],
      ["smallest corrected p of a point", pValue(smallest)],
      ...(d.significant_share === undefined ? [] : [[`share of the ${where} with corrected p < 0.05`, percent(d.significant_share)]])]));
}

export function roundsPanel(model) {
  const { rounds } = model.data;
  if (rounds.length === 0) return null;
  return section("Atlas", true, element("p", { class: "caption" }, "Rounds in which the atlas became the mean. Change: of the mean from the round's atlas; spread: of the subjects about the mean; root mean squares over the diagonal."),
    table(["round", "subjects", "change", "spread"], rounds.map((r) => [String(r.round), integer(r.subjects), percent(r.change ?? NaN), percent(r.spread ?? NaN)])));
}
