// The cohort that the page shows: what the arrays and their description say, under the names that the panels use.

import { unpack } from "../data/arrays.js";
import { boundsOf } from "../data/bounds.js";

const statusWords = { failed: "failed", crashed: "crashed", timed_out: "timed out", out_of_memory: "out of memory", diverged: "diverged", not_run: "not run" };
const outcomeWords = { matched: "matched", "look-here": "look here", "not-matched": "not matched" };

// What was not measured is null in JSON, which would count as 0.
function withoutNull(way) {
  for (const key of Object.keys(way ?? {})) way[key] ??= NaN;
  return way;
}

function readSubject(row, rank, scores, nModes) {
  const { distance } = row, finished = row.status === "finished";
  withoutNull(distance?.atlas_to_subject);
  withoutNull(distance?.subject_to_atlas);
  return {
    ...row,
    rank,  // in the order of the page, the worst first
    finished,
    result: finished ? outcomeWords[row.outcome] ?? (row.outcome || "no verdict") : statusWords[row.status] ?? row.status,
    kind: finished ? row.outcome || "none" : "not-matched",  // of its colour
    scores: row.column === undefined || nModes === 0 ? null : Array.from(scores.subarray(row.column * nModes, (row.column + 1) * nModes)),
  };
}

/** Reads the two elements of the page. Scores are in standard deviations, modes displacements by one of these. */
export async function readCohort(document) {
  const data = JSON.parse(document.getElementById("data").textContent);
  const arrays = await unpack(data.arrays, document.getElementById("arrays").textContent);
  const nModes = data.model?.modes ?? 0, modes = Array.from({ length: nModes }, (_, k) => arrays[`mode.${k + 1}`]);
  const variances = data.model?.variances ?? [], total = data.model?.total_variance || 1;
  const subjects = data.subjects.map((row, rank) => readSubject(row, rank, arrays.scores, nModes));
  const model = {
    data,
    arrays,
    subjects,
    modes,
    facets: arrays.facets,
    mean: arrays.mean,
    dimension: data.dimension,
    unit: data.unit,
    length: data.unit || "units of the files",  // for labels
    share: (k) => variances[k] / total,
    /** In words, for labels. */
    shareText: (k) => (variances[k] / total < 0.0005 ? "< 0.1 %" : `${(100 * variances[k] / total).toFixed(1)} %`),
    deviation: (k) => Math.sqrt(variances[k]),
    groups: [...new Set(subjects.filter((s) => s.column !== undefined).map((s) => s.group))].sort(),
    camera: data.camera,
    /** mean + sum b_k mode_k, for b in standard deviations. */
    shapeOf(b) {
      const shape = Float32Array.from(arrays.mean);
      modes.forEach((mode, k) => { if (b[k]) for (let i = 0; i < shape.length; ++i) shape[i] += b[k] * mode[i]; });
      return shape;
    },
    /** The means of the scores of the subjects in a group. */
    meanScores(group) {
      const members = subjects.filter((s) => s.scores && s.group === group);
      return modes.map((_, k) => members.reduce((sum, s) => sum + s.scores[k], 0) / members.length);
    },
  };
  model.bounds = model.referenceBounds = boundsOf(arrays.mean, ...(nModes > 0 ? [model.shapeOf([-3]), model.shapeOf([3])] : []));
  return model;
}
