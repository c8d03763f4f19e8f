// A view on its way.

/** Calls move(s) with s from 0 to 1 within 0.7 s, or once with 1 where no motion is wanted. \returns a function that ends it */
export function fly(move) {
  const begin = performance.now();
  const step = (now) => {
    const s = Math.min(Math.max((now - begin) / 700, 0), 1);
    move(s * s * (3 - 2 * s));
    frame = s < 1 ? requestAnimationFrame(step) : 0;
  };
  let frame = 0;
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) move(1);
  else frame = requestAnimationFrame(step);
  return () => cancelAnimationFrame(frame);
}
