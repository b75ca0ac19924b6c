/** ms between two frames that differ in decorations alone: they turn and sway slowly, and each frame costs milliseconds. */
const PACE = 30;
/** The same where decorations stand still. Something is drawn all the same, as a browser may lose what a canvas shows. */
const CALM_PACE = 1000;

/**
 * Whether a frame would show anything new.
 * @param last what the last frame showed, by parts that are other objects once they change
 * @param since ms since the last frame
 */
export function isFrameDue<T extends { readonly calm: boolean }>(last: T, now: T, since: number): boolean {
  if (since < 0 || since >= (now.calm ? CALM_PACE : PACE)) return true;
  return (Object.keys(now) as (keyof T)[]).some((part) => now[part] !== last[part]);
}
