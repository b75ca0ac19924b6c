import { EFFECTS } from '../../engine/index.ts';
import { type Level, resolveLevel } from '../../schema/index.ts';

/** What every level has: a place to start, something to pull at, and the black hole. */
const BARE: Level = resolveLevel({
  version: 1,
  name: 'bare',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 0, y: 400, radius: 20 },
  asteroids: [{ x: 100, y: 100, radius: 16 }],
});

/** The effects that a level can do without, so that players meet each of them somewhere for the first time. */
const MET = EFFECTS.filter((effect) => !effect.calledFor(BARE).called);

/** The names of all effects that players meet somewhere for the first time, as `gq inspect` gives them. */
export const EFFECT_NAMES: readonly string[] = MET.map(({ name }) => name);

/** The effects of a level that players may not know yet: those that it calls for and that not every level has. */
export const effectsToMeet = (level: Level): readonly string[] =>
  MET.filter((effect) => effect.calledFor(level).called).map(({ name }) => name);

/** An effect's name as words. */
export const effectInWords = (name: string): string => name.replaceAll('-', ' ');

/** A level of a pack, with what players meet in it. */
export interface MetLevel {
  /** The path of its file below the folder, without `.level.json`. */
  readonly id: string;
  /** What {@link effectsToMeet} gives; null while that is not known, as for a file that is no level. */
  readonly effects: readonly string[] | null;
}

/**
 * What each level introduces: the effects that no level before it calls for. Where a level is not known, nothing is said of those
 * after it, since it may be the first with anything.
 *
 * @param levels - in the order in which they are played
 * @returns the effects by the id of their first level; none for a level of which nothing can be said
 */
export function introductionsOf(levels: readonly MetLevel[]): ReadonlyMap<string, readonly string[]> {
  const met = new Set<string>();
  const first = new Map<string, readonly string[]>();
  for (const { id, effects } of levels) {
    if (effects === null) break;
    first.set(
      id,
      effects.filter((name) => !met.has(name)),
    );
    for (const name of effects) met.add(name);
  }
  return first;
}

/** A level that is much harder than all before it. */
interface Jump {
  /** Its place among the levels, from 0. */
  readonly index: number;
  /** The place of the hardest level before it. */
  readonly from: number;
  /** By how much its grade is higher. */
  readonly by: number;
}

/** A grade (1 to 10) that is higher than all before by this much and more is a jump: the words of grades are about as far apart. */
export const JUMP = 2;

/**
 * The jumps of a curve of difficulty: levels whose grade is at least {@link JUMP} above the highest grade before them. A first
 * level is none, since nothing comes before it.
 *
 * @param grades - the grades in the order in which the levels are played; null where none is known
 */
export function jumpsOf(grades: readonly (number | null)[]): Jump[] {
  const jumps: Jump[] = [];
  let hardest: { readonly index: number; readonly grade: number } | null = null;
  for (const [index, grade] of grades.entries()) {
    if (grade === null) continue;
    // tenths, so that rounding of the difference does not decide
    const by: number = hardest === null ? 0 : Math.round(10 * (grade - hardest.grade)) / 10;
    if (hardest !== null && by >= JUMP) jumps.push({ index, from: hardest.index, by });
    if (hardest === null || grade > hardest.grade) hardest = { index, grade };
  }
  return jumps;
}
