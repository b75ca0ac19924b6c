/** The least and the greatest square of a number between two. */
export const leastSquare = (a: number, b: number): number => (a > 0 ? a * a : b < 0 ? b * b : 0);
export const mostSquare = (a: number, b: number): number => Math.max(a * a, b * b);

/** Tightens radial speed, momentum and energy of a polar box by each other; false when nothing is left. */
export function agree(part: Float64Array): boolean {
  const p0 = leastSquare(part[8], part[9]) / (part[1] * part[1]);
  const p1 = mostSquare(part[8], part[9]) / (part[0] * part[0]);
  const most = 2 * part[11] - p0 + 1e-4;
  if (most < 0) return false;
  const W = Math.sqrt(most);
  if (part[4] < -W) part[4] = -W;
  if (part[5] > W) part[5] = W;
  const lo = 2 * part[10] - p1 - 1e-4;
  if (lo > 0) {
    const s = Math.sqrt(lo);
    if (part[4] > -s && part[4] < s) part[4] = s;
    if (part[5] < s && part[5] > -s) part[5] = -s;
  }
  if (part[4] > part[5]) return false;
  const q0 = leastSquare(part[4], part[5]);
  const q1 = mostSquare(part[4], part[5]);
  const e0 = (q0 + p0) / 2 - 1e-4;
  const e1 = (q1 + p1) / 2 + 1e-4;
  if (part[10] < e0) part[10] = e0;
  if (part[11] > e1) part[11] = e1;
  if (part[10] > part[11]) return false;
  const l = part[1] * Math.sqrt(Math.max(0, 2 * part[11] - q0)) + 1e-3;
  if (part[9] > l) part[9] = l;
  if (part[8] < -l) part[8] = -l;
  if (part[8] > part[9]) return false;
  const d = (Math.sqrt(leastSquare(part[8], part[9])) - 1e-3) / Math.sqrt(Math.max(1e-9, 2 * part[11] - q0 + 1e-3));
  if (part[0] < d) part[0] = d;
  return part[0] <= part[1];
}
