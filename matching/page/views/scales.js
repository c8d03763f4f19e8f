// Values as colours: scales with their labels.

import { figure, quantile } from "../data/format.js";
import { diverging, mapColor, sequential } from "./color_maps.js";

/** Colours of values in a scale, three bytes each. */
export function ofValues(values, scale) {
  const colors = new Uint8Array(3 * values.length);
  for (let i = 0; i < values.length; ++i) colors.set(mapColor(scale.map, scale.position(values[i])), 3 * i);
  return colors;
}

/** One colour for all. */
export function plain(n, color) {
  const colors = new Uint8Array(3 * n);
  for (let i = 0; i < n; ++i) colors.set(color, 3 * i);
  return colors;
}

/** From 0 on, up to what 98 % of the values keep to. */
export function fromZero(lists, label) {
  const end = Math.max(...lists.map((values) => quantile(values, 0.98))) || 1;
  return { map: sequential, label, ticks: ["0", figure(end / 2), `≥ ${figure(end)}`], position: (x) => x / end };
}

/** The same on both sides of zero. */
export function around(values, label) {
  const end = quantile(values.map(Math.abs), 0.95) || 1;
  return { map: diverging, label, ticks: [`≤ ${figure(-end)}`, "0", `≥ ${figure(end)}`], position: (x) => 0.5 + x / end / 2 };
}
