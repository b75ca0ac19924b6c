import { EFFECTS, TICK } from '../../engine/index.ts';
import type { Level, RuleName, Rules } from '../../schema/index.ts';
import type { ProofCode } from '../proofs/index.ts';

// What the checker takes for granted about the game, apart from the lemmas. It is said here again and not read from solver/proofs: whoever adds an
// effect has to teach the checker by itself, or it refuses every proof for a level that calls for the effect.

/** How she and the asteroids are moved. */
const MOVED_BY = ['gun', 'recoil', 'repulsor', 'winds', 'wormholes', 'speed-limit'] as const;

/** What ends a run or is collected, and moves by itself only as aliens do. */
const MET = ['novae', 'hot-asteroids', 'black-hole', 'range', 'minerals', 'alien-chase', 'alien-explosion'] as const;

const KNOWN: ReadonlySet<string> = new Set([...MOVED_BY, ...MET]);

/** For each kind of certificate the effects of which its check knows what they can do. */
const KNOWS: ReadonlyMap<string, ReadonlySet<string>> = new Map<ProofCode, ReadonlySet<string>>([
  ['nothing-in-range', KNOWN],
  ['starts-in-hazard', KNOWN],
  ['out-of-range', KNOWN],
  ['covered', KNOWN],
  ['enclosed', KNOWN],
  ['line-trap', KNOWN],
  ['doomed', KNOWN],
  ['flowpipe', KNOWN],
]);

/** The game's numbers that checks ask for. */
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

/** Why a certificate of a kind says nothing about a level: the kind is none, or the level has an effect or a rule that it doesn't know. */
export function whyNotKnown(kind: unknown, level: Level): string | null {
  const known = typeof kind === 'string' ? KNOWS.get(kind) : undefined;
  if (known === undefined) return 'its kind is unknown';
  const rule = Object.keys(level.rules ?? {}).find((name) => !Object.hasOwn(NUMBERS, name));
  if (rule !== undefined) return `the level has a rule of its own, ${rule}, which no proof knows`;
  const unknown = EFFECTS.find((effect) => !known.has(effect.name) && effect.calledFor(level).called);
  return unknown === undefined
    ? null
    : `the level calls for the effect ${unknown.name}, which a proof of this kind does not know`;
}

/** Nothing accelerates her by more, px/s2: a field acts instead of the gun, winds beside both and each other. */
export const mostPush = (level: Level, { pull, push }: Rules): number =>
  level.winds.reduce(
    (most, { ax, ay }) => most + Math.sqrt(ax * ax + ay * ay),
    level.repulsors.length > 0 && push > pull ? push : pull,
  );

/** Lemma `speed`: on a way of `far` px in one direction she gains no more speed than this, px/s, from rest, where nothing accelerates her by more than `push`, px/s2. */
export const speedAfter = (push: number, far: number): number => Math.sqrt(2 * push * far);

/** Lemma `drift`: acceleration recoil / diameter all the time, for a time squared, s2, and a hundredth more: how far it carries an asteroid, px. */
export const driftIn = ({ recoil, asteroids }: Level, rules: Rules, asteroid: number, square: number): number =>
  recoil ? (1.01 * rules.recoil * square) / (4 * asteroids[asteroid].radius) : 0;

/** Up to this speed, px/s, the way of what nothing accelerates by more than `push`, px/s2, isn't bent by the speed limit; the rest is for what a step may gain. */
export const unlimited = ({ speedLimit }: Rules, push: number): number => Math.min(0.99 * speedLimit, speedLimit - push * TICK);

/** The same for each of two axes of her velocity where it is followed for some steps before it is asked again, px/s. */
export const farFromLimit = ({ speedLimit }: Rules): number => speedLimit / 2;

/** No frame takes her farther, px: the limit holds on both axes. */
export const longestFrame = ({ speedLimit }: Rules): number => 1.4143 * speedLimit * TICK;
