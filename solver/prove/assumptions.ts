import { EFFECTS, TICK } from '../../engine/index.ts';
import type { Level, RuleName, Rules } from '../../schema/basics/index.ts';
import type { Prover } from './proof.ts';

// What provers assume about the game: the effects that each of them understands, and the bounds that follow from the effects.
// The checker has its own declarations (solver/verify/assumptions.ts), because an error in a list that both read would be an
// error in both. They share only the engine's names and the table of rules.
//
// Winds and wormholes: what happens at the start happens before either acts. `out-of-range` follows wormholes, `enclosed`
// requires both mouths of each on one side of the barrier, `covered` claims nothing about minerals in levels with wormholes,
// and `doomed` follows winds. All other provers keep clear of winds and mouths: none may come near the stretch, or the places
// of a step.

const FORCES = ['gun', 'recoil', 'repulsor', 'winds', 'speed-limit'];
const JUMPS = ['wormholes'];
const ALIENS = ['alien-chase', 'alien-explosion'];
const THINGS = ['novae', 'hot-asteroids', 'minerals', 'black-hole', 'range'];
const GAME = [...FORCES, ...JUMPS, ...ALIENS, ...THINGS];

/**
 * The effects that each prover understands: it follows what they do, or shows that it does not matter. A prover proves nothing
 * in a level that calls for any other effect, even for one that only ends runs, because an effect may move or turn what it
 * kills.
 */
const UNDERSTOOD: Readonly<Record<Prover, readonly string[]>> = {
  'nothing-in-range': GAME,
  'starts-in-hazard': GAME,
  'out-of-range': GAME,
  covered: GAME,
  enclosed: GAME,
  'line-trap': GAME,
  // Recoil moves the border between two asteroids.
  'dead-end': GAME.filter((name) => name !== 'recoil'),
  doomed: GAME,
  flowpipe: GAME,
  orbits: GAME,
};

/** The rules from which bounds are derived. A level that sets any other rule has no proof. */
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

/** Names of the effects that a level calls for, and of rules that it sets and no prover reads. */
export const effectsOf = (level: Level): readonly string[] => [
  ...EFFECTS.filter((effect) => effect.calledFor(level).called).map(({ name }) => name),
  ...Object.keys(level.rules ?? {})
    .filter((name) => !RULES_READ.includes(name as RuleName))
    .map((name) => `the rule ${name}`),
];

/** Why a prover says nothing where these effects act; null when it understands all of them. */
export function whyNotTried(prover: Prover, effects: readonly string[]): string | null {
  const other = effects.filter((name) => !UNDERSTOOD[prover].includes(name));
  return other.length === 0 ? null : `the level calls for ${other.join(', ')}, which ${prover} does not cover`;
}

/** The greatest possible acceleration, px/s²: the gun and a field never act at the same time, and winds add to either. */
export const strongestPush = ({ repulsors, winds }: Level, { pull, push }: Rules): number =>
  Math.max(pull, repulsors.length > 0 ? push : 0) + winds.reduce((sum, { ax, ay }) => sum + Math.sqrt(ax * ax + ay * ay), 0);

/**
 * The fastest she may be, px/s, after moving `way` px in one direction (lemma `speed`, an energy bound).
 * @param strongest the greatest acceleration, px/s²
 * @param before the square of her speed before, (px/s)²
 */
export const speedAfter = (strongest: number, way: number, before = 0): number => Math.sqrt(before + 2 * strongest * way);

/** How far pushes can take her from a straight path, px: a t² / 2. The time is given squared, s². */
export const bendWithin = (strongest: number, square: number): number => strongest * square * 0.5;

/** A level and its rules. */
interface Game {
  readonly level: Level;
  readonly rules: Rules;
}

/**
 * The farthest that recoil can carry an asteroid, px: a t² / 2 with a = recoil / diameter all the time, plus 1 % (lemma
 * `drift`).
 * @param square the time squared, s²; slightly longer in frames
 */
export const driftWithin = ({ level: { recoil, asteroids }, rules }: Game, asteroid: number, square: number): number =>
  recoil ? (rules.recoil * 1.01 * square) / (4 * asteroids[asteroid].radius) : 0;

/** The same after some seconds of play, in frames or in continuous time. */
export const driftAfter = (game: Game, asteroid: number, seconds: number): number =>
  driftWithin(game, asteroid, seconds * (seconds + TICK));

/**
 * What fixed steps may add to her acceleration with recoil, px/s². Her velocity is the one relative to the asteroid plus the
 * asteroid's own; recoil belongs to both, and a step may turn it in one of them otherwise than in the other (lemma
 * `recoil in steps`).
 */
export const recoilBlur = ({ level: { recoil, asteroids }, rules }: Game): number =>
  recoil ? asteroids.reduce((most, { radius }) => Math.max(most, (1.01 * rules.recoil) / radius), 0) : 0;

/**
 * Below this speed, px/s, an object that is accelerated by at most `strongest`, px/s², does not reach the speed limit within a
 * step, so that the limit does not bend its path.
 */
export const unbentSpeed = ({ speedLimit }: Rules, strongest: number): number =>
  Math.min(0.98 * speedLimit, speedLimit - 2 * strongest * TICK);

/** Below this speed, px/s, she can be followed for several steps without regard to the speed limit. */
export const easySpeed = ({ speedLimit }: Rules): number => speedLimit / 2;

/**
 * Whether she stays below the speed limit throughout the first step, and throughout every step of this many seconds that she
 * begins below {@link easySpeed} on both axes.
 */
export function isEasyFor({ level, rules, strongest }: Game & { readonly strongest: number }, seconds: number): boolean {
  const { vx, vy } = level.astronaut;
  const gain = strongest * (seconds + TICK);
  return Math.max(0.708 * rules.speedLimit, Math.sqrt(vx * vx + vy * vy)) + gain <= rules.speedLimit;
}

/** The longest flight of one frame, px: at the speed limit on both axes. */
export const fastestFrame = ({ speedLimit }: Rules): number => speedLimit * TICK * 1.4143;
