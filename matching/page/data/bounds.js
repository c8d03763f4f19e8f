// The box around shapes.

/** Of points of three coordinates each: corners, centre and diagonal (1 where there is no extent). */
export function boundsOf(...lists) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const positions of lists)
    for (let i = 0; i < positions.length; ++i) {
      const k = i % 3;
      if (positions[i] < low[k]) low[k] = positions[i];
      if (positions[i] > high[k]) high[k] = positions[i];
    }
  const size = Math.hypot(...high.map((x, k) => x - low[k]));
  return { low, high, centre: low.map((x, k) => (x + high[k]) / 2), diagonal: size > 0 ? size : 1 };
}
