// What the words of the page mean, with their sources.

import { element, section } from "../panels/dom.js";

const alignment = {
  none: "none: the shapes are compared as they lie.",
  rigid: "position and direction of each shape are taken out by moving it onto the mean, in turn with the mean; sizes are kept (Gower 1975).",
  similarity: "position, direction and size of each shape are taken out by moving it onto the mean, in turn with the mean (Gower 1975).",
};

function entries({ data, modes, dimension }) {
  const surface = dimension === 3 ? "surface" : "curve", list = [
    ["distance", `greatest distance of a point of the deformed atlas from the subject, and of the subject from the deformed atlas.`],
    ["verdict", "matched, look here (a figure is unusual) or not matched, with the reasons; the report of a subject shows the places."],
    ["Procrustes analysis", alignment[data.procrustes] ?? data.procrustes],
  ];
  if (data.model) {
    list.push(["mean", "mean of each point of the atlas over the aligned subjects."],
      ["standard deviation", "of a point: root of the sum of its squared distances from the mean over n − 1."]);
  }
  if (modes.length > 0) {
    const shown = data.model.variances.slice(0, modes.length).reduce((sum, x) => sum + x, 0) / data.model.total_variance;
    list.push(
      ["mode", `direction in which the cohort varies most, and so on, orthogonal to those before: principal components, in which each point counts by its share of the ${surface} (Cootes, Taylor, Cooper and Graham 1995).`],
      ["score", "coordinate of a subject along a mode: a root mean square displacement of the points from the mean; SD is its standard deviation over the cohort."],
      ["shape of a subject", `here: mean + its scores on the ${modes.length === 1 ? "mode" : `${modes.length} modes`} that this page holds, which have ${(100 * shown).toFixed(shown > 0.9995 ? 0 : 1)} % of the variance.`]);
  }
  if (data.curves)
    list.push(
      ["compactness", "share of the total variance in the first M modes (Davies 2002)."],
      ["generalisation", "mean distance of a subject to its best approximation by M modes of the model of all others (Davies 2002; Styner et al. 2003); small is good."],
      ["specificity", "mean distance of random shapes of the model with M modes to the nearest subject (Davies 2002; Styner et al. 2003); small is good."],
      ["standard error", "standard deviation over the root of the number of subjects, or of random shapes."]);
  if (data.difference)
    list.push(
      ["difference", `mean of group “${data.difference.group_b}” minus mean of group “${data.difference.group_a}”; positive along the normal: outward.`],
      ["corrected p", "share of permutations of the groups whose greatest Hotelling's T² of all points is at least that of this point: the chance of any such point where groups do not differ (family-wise error, Westfall and Young 1993)."],
      ["p of the distance", "share of permutations with at least this root mean square distance of the means, the observed one counted."]);
  return list;
}

const sources = [
  ["Procrustes analysis", "J. C. Gower, Generalized Procrustes analysis, Psychometrika 40, 1975"],
  ["model", "T. F. Cootes, C. J. Taylor, D. H. Cooper, J. Graham, Active shape models: their training and application, Computer Vision and Image Understanding 61, 1995"],
  ["curves", "R. H. Davies, Learning shape: optimal models for analysing natural variability, PhD thesis, University of Manchester, 2002"],
  ["curves", "M. Styner et al., Evaluation of 3D correspondence methods for model building, Information Processing in Medical Imaging, 2003"],
  ["difference", "P. H. Westfall, S. S. Young, Resampling-based multiple testing, Wiley, 1993"],
];

export function definitionsPanel(model) {
  const { data } = model, given = { "Procrustes analysis": data.procrustes !== "none", model: data.model, curves: data.curves, difference: data.difference };
  return section("Definitions", false, element("dl", {}, ...entries(model).flatMap(([word, text]) => [element("dt", {}, word), element("dd", {}, text)])),
    element("ul", { class: "sources" }, ...sources.filter(([what]) => given[what]).map(([, text]) => element("li", {}, text))));
}
