import { ALIEN_PULL, EFFECTS, GUN_PULL, REPULSOR_PUSH, SPEED_LIMIT, TICK } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import type { Prover } from './proof.ts';

// What provers take for granted about the game. The checker has declarations of its own (solver/verify/assumptions.ts): what is
// wrong in a list that both read would be wrong for both. All they have in common is the engine's names and constants.

const FORCES = ['gun', 'recoil', 'repulsor', 'speed-limit'];
const ALIENS = ['alien-chase', 'alien-explosion'];
const THINGS = ['novae', 'hot-asteroids', 'minerals', 'black-hole', 'range'];
const GAME = [...FORCES, ...ALIENS, ...THINGS];

/**
 * The effects that each way to prove understands: whatever they do is followed, or shown not to matter. In a level that calls for
 * any other effect it proves nothing.
 */
const UNDERSTOOD: Readonly<Record<Prover, readonly string[]>> = {
  'nothing-in-range': GAME,
  'starts-in-hazard': GAME,
  'out-of-range': GAME,
  covered: GAME,
  enclosed: GAME,
  'line-trap': GAME,
  // recoil moves the border between two asteroids
  'dead-end': GAME.filter((name) => name !== 'recoil'),
  doomed: GAME,
  flowpipe: GAME,
};

/** The names of the effects that a level calls for; rules of its own count as one, which no way to prove understands. */
export const effectsOf = (level: Level): readonly string[] => [
  ...EFFECTS.filter((effect) => effect.calledFor(level).called).map(({ name }) => name),
  ...(level.rules === undefined ? [] : ['rules of its own']),
];

/** Why a way to prove says nothing where these effects act; null where it understands all of them. */
export function whyNotTried(prover: Prover, effects: readonly string[]): string | null {
  const other = effects.filter((name) => !UNDERSTOOD[prover].includes(name));
  return other.length === 0 ? null : `the level calls for ${other.join(', ')}, which ${prover} does not understand`;
}

/** The most that anything can accelerate her, px/s2: the gun and a field never act at once. */
export const strongestPush = ({ repulsors }: Level): number => Math.max(GUN_PULL, repulsors.length > 0 ? REPULSOR_PUSH : 0);

/** The most that anything can accelerate an alien, px/s2. */
export const STRONGEST_CHASE = ALIEN_PULL;

/**
 * The fastest she may be, px/s, after a way of so many px in one direction. Lemma `speed`.
 * @param strongest what accelerates her at most, px/s2
 * @param before her speed before, px/s, squared
 */
export const speedAfter = (strongest: number, way: number, before = 0): number => Math.sqrt(before + 2 * strongest * way);

/** Farther than this, px, no push takes her from her straight way in a time, s, that is given squared: a t2 / 2. */
export const bendWithin = (strongest: number, square: number): number => strongest * square * 0.5;

/**
 * The farthest that recoil can carry an asteroid, px: a t2 / 2 with a = 1 / diameter all the time, and a hundredth. Lemma `drift`.
 * @param square the time squared, s2; frames make it a little longer
 */
export const driftWithin = ({ recoil, asteroids }: Level, asteroid: number, square: number): number =>
  recoil ? (1.01 * square) / (4 * asteroids[asteroid].radius) : 0;

/** The same after some seconds of play, whether by frames or not. */
export const driftAfter = (level: Level, asteroid: number, seconds: number): number =>
  driftWithin(level, asteroid, seconds * (seconds + TICK));

/** Slower than this, px/s, she doesn't come to the speed limit within a step, so that nothing bends her way. */
export const UNBENT_SPEED = 0.98 * SPEED_LIMIT;

/** Slower than this, px/s, she may be followed for many steps at once without a thought of the speed limit. */
export const EASY_SPEED = SPEED_LIMIT / 2;

/** The farthest flight of one frame, px: at the speed limit on both axes. */
export const FASTEST_FRAME = SPEED_LIMIT * TICK * 1.4143;
