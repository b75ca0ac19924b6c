/** A tick of a ruler. */
export interface Tick {
  /** px of the level */
  readonly value: number;
  /** px of screen from the start of the ruler */
  readonly at: number;
  /** Whether it has a number. */
  readonly isLong: boolean;
}

/** px of screen between two numbers at least */
const ROOM = 64;
/** short ticks per number */
const PARTS = 5;

/** The round step whose numbers have room: 1, 2 or 5 times a power of ten, at least 1 px. @param zoom px of screen per px of the level */
export function stepFor(zoom: number): number {
  const least = Math.max(1, ROOM / zoom);
  const power = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5, 10].find((factor) => factor * power >= least) ?? 10) * power;
}

/**
 * The ticks of a ruler.
 * @param from px of the level at its start
 * @param length px of screen
 * @param zoom px of screen per px of the level
 */
export function ticksOf(from: number, length: number, zoom: number): Tick[] {
  const small = stepFor(zoom) / PARTS;
  const ticks: Tick[] = [];
  for (let k = Math.ceil(from / small); (k * small - from) * zoom <= length; k++) {
    ticks.push({ value: k * small + 0, at: (k * small - from) * zoom, isLong: k % PARTS === 0 });
  }
  return ticks;
}
