// Colours of values: stops of perceptually even maps, in sRGB from 0 to 255.

/** viridis, of matplotlib */
export const sequential = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121], [110, 206, 88], [181, 222, 43], [253, 231, 37]];
/** from blue over a light grey to red, after Moreland's */
export const diverging = [[59, 76, 192], [104, 138, 239], [153, 186, 255], [201, 215, 240], [224, 222, 220], [240, 205, 187], [245, 164, 134], [224, 101, 79], [180, 4, 38]];
export const unknown = [150, 150, 150];

/** The colour at s in [0, 1] of a map, a list of colours; grey for what is no number. */
export function mapColor(stops, s) {
  if (Number.isNaN(s)) return unknown;
  const x = Math.min(Math.max(s, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(x), stops.length - 2), f = x - i;
  return stops[i].map((c, k) => c + f * (stops[i + 1][k] - c));
}

/** As a CSS gradient from left to right. */
export function gradient(stops) {
  return `linear-gradient(to right, ${stops.map((c) => `rgb(${c.join(" ")})`).join(", ")})`;
}
