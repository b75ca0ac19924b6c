import { compile, EFFECTS, type Mode, maxTicksOf, type Run, simulate, type Terms, type Work } from '../../../engine/index.ts';
import { playerOf } from '../../../engine/work-precision/index.ts';
import { type Hold, kindOfList, type Level, OBJECT_LISTS, type Rules } from '../../../schema/index.ts';
import { timeInTurns } from '../../core/figures/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

export interface SimulatedEffect {
  readonly name: string;
  readonly because: string;
  readonly summary: string;
  readonly cost: EffectCost;
}

/** The effects that a level calls for, those it does not, and what its shown run costs. */
export interface Survey {
  /** equal for the same level and run */
  readonly key: string;
  readonly simulated: readonly SimulatedEffect[];
  readonly notCalledFor: readonly { readonly name: string; readonly because: string; readonly summary: string }[];
  readonly modes: readonly Mode[];
  readonly work: Work;
  /** s */
  readonly time: number;
  readonly runName: string | null;
}

const summaryOf = (name: string, rules: Rules): string => EFFECTS.find((effect) => effect.name === name)?.summary(rules) ?? '';

let count = 0;
const sceneNumbers = new WeakMap<object, number>();

/** A number for a scene, unique to it. */
function numberOf(scene: object): number {
  const number = sceneNumbers.get(scene) ?? ++count;
  sceneNumbers.set(scene, number);
  return number;
}

/**
 * Surveys a level and its shown run, simulating once without each effect that can be left out. @returns null if the level takes
 * too much work for that
 */
export function surveyOf({ level, scene, terms, run, full, limit }: LiveProof): Survey | null {
  if (limit !== null || full === null) return null;
  const { simulated, notCalledFor } = scene.effects;
  return {
    key: `${numberOf(scene)} ${run.holds.join()}`,
    simulated: simulated.map(({ name, because }) => ({
      name,
      because,
      summary: summaryOf(name, scene.rules),
      cost: costOf(level, terms, run.holds, full, name),
    })),
    notCalledFor: notCalledFor.map(({ name, because }) => ({ name, because, summary: summaryOf(name, scene.rules) })),
    modes: full.modes,
    work: full.work,
    time: full.time,
    runName: run.name,
  };
}

// what an effect costs: the run with and without it

/** Functions that leave one effect out of a level, by the effect's name. */
const LEAVE_OUT: Readonly<Record<string, (level: Level) => Level>> = {
  recoil: (level) => ({ ...level, recoil: false }),
  'alien-chase': (level) => ({ ...level, aliens: [] }),
  'hot-asteroids': (level) => ({ ...level, asteroids: level.asteroids.map((asteroid) => ({ ...asteroid, hot: false })) }),
};

/**
 * The level without one effect; null if no level can do without it. An effect named like a kind or its list is left out with
 * its objects.
 */
export function withoutEffect(level: Level, effect: string): Level | null {
  const leaveOut = LEAVE_OUT[effect];
  if (leaveOut !== undefined) return leaveOut(level);
  const list = OBJECT_LISTS.find((one) => one === effect || kindOfList(one) === effect);
  return list === undefined ? null : { ...level, [list]: [] };
}

/** What an effect costs in the shown run. */
type EffectCost =
  /** no level can do without it */
  | { readonly kind: 'always' }
  /** Without it the path is the same: the saved work is its cost. */
  | { readonly kind: 'same'; readonly saved: Work; readonly level: Level }
  /** Without it the path differs, so the two runs can't be compared. */
  | { readonly kind: 'other'; readonly run: Run };

/** s: largest difference of two end times that count as equal */
const SAME_TIME = 1e-6;

/**
 * The cost of an effect: compares the run with the same holds in the level without it.
 * @param full the run with all effects
 */
export function costOf(level: Level, terms: Terms, holds: readonly Hold[], full: Run, effect: string): EffectCost {
  const without = withoutEffect(level, effect);
  if (without === null) return { kind: 'always' };
  const run = simulate(compile(without, terms), holds);
  const isSame =
    run.outcome === full.outcome &&
    run.with?.kind === full.with?.kind &&
    Math.abs(run.time - full.time) < SAME_TIME &&
    Math.hypot(run.final.x - full.final.x, run.final.y - full.final.y) < 1;
  if (!isSame) return { kind: 'other', run };
  const saved: Work = {
    pieces: full.work.pieces - run.work.pieces,
    forceEvaluations: full.work.forceEvaluations - run.work.forceEvaluations,
    guards: full.work.guards - run.work.guards,
    roots: full.work.roots - run.work.roots,
  };
  return { kind: 'same', saved, level: without };
}

/** Measured times, microseconds per simulated second. */
export interface EffectTime {
  /** Of the run with all effects. */
  readonly all: number;
  /** What leaving the effect out saves. */
  readonly saved: number;
  /** The bounds of `saved` from the even and the odd rounds alone: how far it can be trusted. */
  readonly low: number;
  readonly high: number;
}

// Disturbances only make a measurement longer, so the minimum is closest to the truth.
const least = (samples: readonly number[]): number => Math.min(...samples);
const half = (samples: readonly number[], which: number): readonly number[] => samples.filter((_, i) => i % 2 === which);

/** What leaving an effect out saves, from the samples with and without it. */
export function savingOf(base: readonly number[], without: readonly number[]): EffectTime {
  const halves = [0, 1].map((which) => least(half(base, which)) - least(half(without, which)));
  const saved = least(base) - least(without);
  return { all: least(base), saved, low: Math.min(saved, ...halves), high: Math.max(saved, ...halves) };
}

/**
 * Times a run with all effects and without each effect, in turns.
 * @param without the level without each effect, by the effect's name
 * @returns the times by effect
 */
export function* timeEffects(
  level: Level,
  terms: Terms,
  holds: readonly Hold[],
  without: ReadonlyMap<string, Level>,
): Generator<null, ReadonlyMap<string, EffectTime>, void> {
  const players = [level, ...without.values()].map((played) =>
    playerOf([{ level: played, holds }], terms.accuracy, maxTicksOf(terms)),
  );
  const samples = yield* timeInTurns(players, () => performance.now());
  return new Map([...without.keys()].map((name, i) => [name, savingOf(samples[0], samples[i + 1])]));
}
