/** px by which two runs must be apart to have parted. */
export const APART = 1;

/** px: two runs that were farther from each other than `AWAY` meet again where they are at most `TOGETHER` apart. */
export const TOGETHER = 8;
export const AWAY = 16;

/**
 * How far two runs are from each other at every tick, px, as long as both last.
 * @param one x, y at every tick, alternating
 * @param other likewise
 */
export function distancesOf(one: ArrayLike<number>, other: ArrayLike<number>): Float64Array {
  const count = Math.floor(Math.min(one.length, other.length) / 2);
  return Float64Array.from({ length: count }, (_, tick) => {
    const [dx, dy] = [one[2 * tick] - other[2 * tick], one[2 * tick + 1] - other[2 * tick + 1]];
    return Math.sqrt(dx * dx + dy * dy);
  });
}

/** Where two runs are nearest again. */
export interface Meeting {
  readonly tick: number;
  /** px */
  readonly distance: number;
}

/** Where two runs part and meet. */
export interface Partings {
  /** The first tick at which they are more than `APART` from each other; null: they never are. */
  readonly parts: number | null;
  /** Their nearest moments after they were away from each other, in order of time. */
  readonly meets: readonly Meeting[];
}

/** Finds where two runs part and meet again, tick by tick. @param distances what {@link distancesOf} gives */
export function partingsOf(distances: ArrayLike<number>): Partings {
  let parts: number | null = null;
  let isAway = false;
  let near: Meeting | null = null;
  const meets: Meeting[] = [];
  for (let tick = 0; tick < distances.length; tick++) {
    const distance = distances[tick];
    if (distance > APART) parts ??= tick;
    if (distance > AWAY) isAway = true;
    if (isAway && distance <= TOGETHER && (near === null || distance < near.distance)) near = { tick, distance };
    else if (near !== null && distance > AWAY) {
      meets.push(near);
      near = null;
    }
  }
  return { parts, meets: near === null ? meets : [...meets, near] };
}
