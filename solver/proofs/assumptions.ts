import { EFFECTS, TICK } from '../../engine/index.ts';
import type { Level, RuleName, Rules } from '../../schema/index.ts';
import type { Prover } from './proof.ts';

// What provers take for granted about the game. The checker has declarations of its own (solver/verify/assumptions.ts): what is
// wrong in a list that both read would be wrong for both. All they have in common is the engine's names and the table of rules.

const FORCES = ['gun', 'recoil', 'repulsor', 'winds', 'speed-limit'];
const JUMPS = ['wormholes'];
const ALIENS = ['alien-chase', 'alien-explosion'];
const THINGS = ['novae', 'hot-asteroids', 'minerals', 'black-hole', 'range'];
const GAME = [...FORCES, ...JUMPS, ...ALIENS, ...THINGS];

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

/** The numbers of the game that bounds are made of. A level that sets any other is proved by nobody. */
const RULES_READ: readonly RuleName[] = [
  'pull',
  'recoil',
  'push',
  'alienPull',
  'alienSight',
  'speedLimit',
  'boxWidth',
  'boxHeight',
];

/** What of the game a level has to do with: the names of the effects that it calls for, and of rules of its own that nobody reads. */
export const effectsOf = (level: Level): readonly string[] => [
  ...EFFECTS.filter((effect) => effect.calledFor(level).called).map(({ name }) => name),
  ...Object.keys(level.rules ?? {})
    .filter((name) => !RULES_READ.includes(name as RuleName))
    .map((name) => `the rule ${name}`),
];

/** Why a way to prove says nothing where these effects act; null where it understands all of them. */
export function whyNotTried(prover: Prover, effects: readonly string[]): string | null {
  const other = effects.filter((name) => !UNDERSTOOD[prover].includes(name));
  return other.length === 0 ? null : `the level calls for ${other.join(', ')}, which ${prover} does not understand`;
}

/** The most that anything can accelerate her, px/s2: the gun and a field never act at once, and winds add to either. */
export const strongestPush = ({ repulsors, winds }: Level, { pull, push }: Rules): number =>
  Math.max(pull, repulsors.length > 0 ? push : 0) + winds.reduce((sum, { ax, ay }) => sum + Math.sqrt(ax * ax + ay * ay), 0);

/**
 * The fastest she may be, px/s, after a way of so many px in one direction. Lemma `speed`.
 * @param strongest what accelerates her at most, px/s2
 * @param before her speed before, px/s, squared
 */
export const speedAfter = (strongest: number, way: number, before = 0): number => Math.sqrt(before + 2 * strongest * way);

/** Farther than this, px, no push takes her from her straight way in a time, s, that is given squared: a t2 / 2. */
export const bendWithin = (strongest: number, square: number): number => strongest * square * 0.5;

/** A level, and the game's numbers in it. */
interface Game {
  readonly level: Level;
  readonly rules: Rules;
}

/**
 * The farthest that recoil can carry an asteroid, px: a t2 / 2 with a = recoil / diameter all the time, and a hundredth. Lemma `drift`.
 * @param square the time squared, s2; frames make it a little longer
 */
export const driftWithin = ({ level: { recoil, asteroids }, rules }: Game, asteroid: number, square: number): number =>
  recoil ? (rules.recoil * 1.01 * square) / (4 * asteroids[asteroid].radius) : 0;

/** The same after some seconds of play, whether by frames or not. */
export const driftAfter = (game: Game, asteroid: number, seconds: number): number =>
  driftWithin(game, asteroid, seconds * (seconds + TICK));

/** Slower than this, px/s, what is accelerated by no more than `strongest`, px/s2, doesn't come to the speed limit within a step, so that nothing bends its way. */
export const unbentSpeed = ({ speedLimit }: Rules, strongest: number): number =>
  Math.min(0.98 * speedLimit, speedLimit - 2 * strongest * TICK);

/** Slower than this, px/s, she may be followed for some steps at once without a thought of the speed limit. */
export const easySpeed = ({ speedLimit }: Rules): number => speedLimit / 2;

/**
 * Whether she is far from the speed limit all through a step of so many seconds that she begins slower than {@link easySpeed} on two axes, and
 * through the first.
 */
export function isEasyFor({ level, rules, strongest }: Game & { readonly strongest: number }, seconds: number): boolean {
  const { vx, vy } = level.astronaut;
  const gain = strongest * (seconds + TICK);
  return Math.max(0.708 * rules.speedLimit, Math.sqrt(vx * vx + vy * vy)) + gain <= rules.speedLimit;
}

/** The farthest flight of one frame, px: at the speed limit on both axes. */
export const fastestFrame = ({ speedLimit }: Rules): number => speedLimit * TICK * 1.4143;
