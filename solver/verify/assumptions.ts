import { EFFECTS, TICK } from '../../engine/index.ts';
import type { Level, RuleName, Rules } from '../../schema/basics/index.ts';
import type { ProofCode } from '../prove/index.ts';

// What the checker assumes about the game, apart from the lemmas of docs/proofs.md. It is declared here again and not read from
// solver/prove: a new effect must be added here as well, or the checker refuses every proof for a level that calls for it.

/** Effects that move her and the asteroids. */
const MOVED_BY = ['gun', 'recoil', 'repulsor', 'winds', 'wormholes', 'speed-limit'] as const;

/** Effects that end a run or collect something; only aliens move by themselves. */
const MET = ['novae', 'hot-asteroids', 'black-hole', 'range', 'minerals', 'alien-chase', 'alien-explosion'] as const;

const KNOWN: ReadonlySet<string> = new Set([...MOVED_BY, ...MET]);

/** For each kind of certificate, the effects that its check understands. */
const KNOWS: ReadonlyMap<string, ReadonlySet<string>> = new Map<ProofCode, ReadonlySet<string>>([
  ['nothing-in-range', KNOWN],
  ['starts-in-hazard', KNOWN],
  ['out-of-range', KNOWN],
  ['covered', KNOWN],
  ['enclosed', KNOWN],
  ['line-trap', KNOWN],
  ['doomed', KNOWN],
  ['flowpipe', KNOWN],
  ['orbits', KNOWN],
]);

/** The rules that the checks read. */
const NUMBERS: Readonly<Record<RuleName, true>> = {
  pull: true,
  recoil: true,
  push: true,
  alienPull: true,
  alienSight: true,
  speedLimit: true,
  boxWidth: true,
  boxHeight: true,
};

/**
 * Why a certificate cannot be checked for a level: its kind is unknown, or the level has an effect or a rule that the check
 * does not understand; else null.
 */
export function whyNotKnown(kind: unknown, level: Level): string | null {
  const known = typeof kind === 'string' ? KNOWS.get(kind) : undefined;
  if (known === undefined) return 'its kind is unknown';
  const rule = Object.keys(level.rules ?? {}).find((name) => !Object.hasOwn(NUMBERS, name));
  if (rule !== undefined) return `the level sets the rule ${rule}, which no proof covers`;
  const unknown = EFFECTS.find((effect) => !known.has(effect.name) && effect.calledFor(level).called);
  return unknown === undefined ? null : `the level calls for the effect ${unknown.name}, which proofs of this kind do not cover`;
}

/** The greatest possible acceleration, px/s²: a field replaces the gun, and winds add to both and to each other. */
export const mostPush = (level: Level, { pull, push }: Rules): number =>
  level.winds.reduce(
    (most, { ax, ay }) => most + Math.sqrt(ax * ax + ay * ay),
    level.repulsors.length > 0 && push > pull ? push : pull,
  );

/**
 * Lemma `speed`, an energy bound: from rest, over `far` px in one direction, she gains no more than this speed, px/s, if
 * nothing accelerates her by more than `push`, px/s².
 */
export const speedAfter = (push: number, far: number): number => Math.sqrt(2 * push * far);

/**
 * Lemma `drift`: how far recoil can carry an asteroid, px, with an acceleration of recoil / diameter all the time, plus 1 %.
 * The time is given squared, s².
 */
export const driftIn = ({ recoil, asteroids }: Level, rules: Rules, asteroid: number, square: number): number =>
  recoil ? (1.01 * rules.recoil * square) / (4 * asteroids[asteroid].radius) : 0;

/**
 * Lemma `recoil in steps`: how much her acceleration may differ with fixed steps, px/s², from what acts on her. With recoil her
 * velocity is computed relative to the asteroid, whose own velocity is computed apart and added; each contains recoil, at most
 * recoil / diameter, and a step may give it another direction in the one than in the other.
 */
export const stepBlur = ({ recoil, asteroids }: Level, rules: Rules): number =>
  recoil ? asteroids.reduce((most, { radius }) => Math.max(most, rules.recoil / radius), 0) : 0;

/**
 * Up to this speed, px/s, the speed limit does not bend the path of an object that is accelerated by at most `push`, px/s². The
 * margin is what a step may gain.
 */
export const unlimited = ({ speedLimit }: Rules, push: number): number => Math.min(0.99 * speedLimit, speedLimit - push * TICK);

/** The same for each of two axes of her velocity when it is followed for several steps without looking again, px/s. */
export const farFromLimit = ({ speedLimit }: Rules): number => speedLimit / 2;

/** The longest flight of one frame, px, because the limit holds on both axes. */
export const longestFrame = ({ speedLimit }: Rules): number => 1.4143 * speedLimit * TICK;
