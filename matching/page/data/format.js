// Numbers and units in words.

/** Three significant digits, without needless zeros. */
export function figure(x, digits = 3) {
  if (x === null || x === undefined || Number.isNaN(x)) return "not known";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
  if (x === 0) return "0";
  const size = Math.abs(x);
  const text = size >= 1e6 || size < 1e-4 ? x.toExponential(digits - 1) : Number(x.toPrecision(digits)).toString();
  return text.replace("e+", "e").replace("-", "−");
}

export function integer(n) {
  return Math.round(n).toString().replace(/\B(?=(\d{3})+$)/g, "\u202f");
}

export function seconds(s) {
  const whole = Math.round(s);
  if (whole >= 120) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  return `${figure(s)} s`;
}

export function bytes(n) {
  return n >= 1e9 ? `${figure(n / 1e9)} GB` : `${figure(n / 1e6)} MB`;
}

export function percent(share) {
  return Number.isNaN(share) ? "not known" : `${figure(100 * share)} %`;
}

/** The last part of a path. */
export function baseName(path) {
  return path.startsWith("generate:") ? path.slice(9) : path.replace(/^.*\//, "");
}

/** The q-quantile of the finite values. */
export function quantile(values, q) {
  const finite = Array.from(values).filter(Number.isFinite).sort((a, b) => a - b);
  return finite.length === 0 ? 0 : finite[Math.round(q * (finite.length - 1))];
}
