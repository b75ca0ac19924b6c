import { type AccuracyName, unlimited, type WorkBudget, WorkLimitReached } from '../../engine/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import { whyNotTried } from './assumptions.ts';
import type { About, Proof, Prover } from './proof.ts';
import { PROVERS, proversThat } from './provers.ts';
import { type Setting, settingOf, type Thing, thingOf } from './setting.ts';

/** For which runs a proof is sought, and what the search for it may cost. */
export interface ProveOptions {
  /**
   * The accuracy that the proof has to cover. By default a proof that covers all accuracies is preferred, then one that covers
   * continuous time.
   */
  readonly accuracy?: AccuracyName;
  /**
   * Length of the longest run, s; 60 by default. It matters only with recoil, which moves asteroids for as long as a run lasts.
   */
  readonly maxTime?: number;
  /** Limits the work; when it is spent, no more proofs are found. There is no limit by default. */
  readonly budget?: WorkBudget;
  /**
   * How finely `doomed`, `orbits` and `flowpipe` divide what they follow: 0, the default, is coarse and takes about a second at
   * most; each next number is finer and takes several times as long. Numbers above {@link FINEST} are the same as that.
   */
  readonly fineness?: number;
}

/** The greatest {@link ProveOptions.fineness} at which any prover differs from a lower one. */
export const FINEST = Math.max(...Object.values(PROVERS).map(({ finest }) => finest));

const CHEAP = proversThat(({ takes }) => takes === 'a glance');
const QUICK = proversThat(({ takes }) => takes === 'a glance' || takes === 'milliseconds');

/** Levels with more minerals than this are examined by the cheap provers only. */
const MOST_MINERALS = 64;

/**
 * Tries to prove that the black hole cannot be reached. The provers are tried from cheap to expensive; `doomed`, `orbits` and
 * `flowpipe`, which may take seconds, come last.
 * @param level the level
 * @param options the accuracy, the length of the longest run and a limit on the work
 * @returns a proof, or null when none was found; the black hole may then still be out of reach
 * @example
 * ```ts
 * import { proveImpossible, verifyProof } from 'gravity-quest-toolkit/solver';
 *
 * const proof = proveImpossible(level, { accuracy: 'precise' });
 * if (proof !== null && verifyProof(level, proof).ok) console.log(proof.reason);
 * ```
 */
export function proveImpossible(level: Level, options: ProveOptions = {}): Proof | null {
  const settings = settingsOf(level, options);
  const goal = thingOf(level, level.blackHole);
  const about = { kind: 'blackHole' } as const;
  return prove(settings, QUICK, about, goal, options) ?? proveSoonOver(settings, about, goal, options);
}

/**
 * Tries one prover only.
 * @param prover the name of the prover
 * @param level the level
 * @param about what is to be proved unreachable
 * @param options the accuracy, the length of the longest run and a limit on the work
 * @returns a proof, or null when this prover finds none
 */
export function proveBy(prover: Prover, level: Level, about: About, options: ProveOptions = {}): Proof | null {
  const goal = thingOf(level, about.kind === 'blackHole' ? level.blackHole : level.minerals[about.index]);
  return prove(settingsOf(level, options), [prover], about, goal, options);
}

/**
 * Whether a prover may find a proof about a level with some fineness. It is a quick look that costs no work: true says nothing.
 */
export function mayProve(prover: Prover, level: Level, options: ProveOptions = {}): boolean {
  const { mayApply } = PROVERS[prover];
  return settingsOf(level, options).some(
    (setting) => whyNotTried(prover, setting.effects) === null && mayApply(setting, options.fineness ?? 0),
  );
}

/**
 * Tries to prove of each mineral that no run can collect it. When there are more than 64 of them, only the cheap provers are
 * used.
 * @param level the level
 * @param options the accuracy, the length of the longest run and a limit on the work
 * @param asked indices of the minerals to examine; all of them by default
 * @returns one proof for each mineral that is proved unreachable, in the order of `asked`
 */
export function proveMineralsUnreachable(
  level: Level,
  options: ProveOptions = {},
  asked: readonly number[] = [...level.minerals.keys()],
): Proof[] {
  const settings = settingsOf(level, options);
  // Whether all runs end soon does not depend on the mineral, so it is decided once.
  let isSoonOver: boolean | null = null;
  return asked.flatMap((index) => {
    const about = { kind: 'mineral', index } as const;
    const goal = thingOf(level, level.minerals[index]);
    const proof = prove(settings, asked.length <= MOST_MINERALS ? QUICK : CHEAP, about, goal, options);
    if (proof !== null) return proof;
    isSoonOver ??= proveSoonOver(settings, { kind: 'blackHole' }, thingOf(level, level.blackHole), options) !== null;
    return isSoonOver ? (proveSoonOver(settings, about, goal, options) ?? []) : [];
  });
}

/** The share of a limited budget that `orbits` may take: it costs most, and what it proves at all it often proves quickly. */
const ORBITS_SHARE = 0.03;

/** The provers that may take seconds and apply only to a moving start. The one that covers frames as well comes first. */
function proveSoonOver(settings: readonly Setting[], about: About, goal: Thing, options: ProveOptions): Proof | null {
  const last = settings.slice(-1);
  const { budget } = last[0];
  return (
    prove(settings.slice(0, 1), ['doomed'], about, goal, options) ??
    prove(last, ['flowpipe'], about, goal, options) ??
    budget.within(ORBITS_SHARE, () => prove(last, ['orbits'], about, goal, options))
  );
}

/** Frames come first, because a proof for them also holds in continuous time. */
function settingsOf(level: Level, { accuracy, maxTime, budget = unlimited() }: ProveOptions): Setting[] {
  const frames = accuracy === undefined || accuracy === 'arcade' ? [settingOf(level, maxTime ?? null, true, budget)] : [];
  const continuous = accuracy !== 'arcade' ? [settingOf(level, maxTime ?? null, false, budget)] : [];
  return [...frames, ...continuous];
}

function prove(
  settings: readonly Setting[],
  provers: readonly Prover[],
  about: About,
  goal: Thing,
  { accuracy, fineness = 0 }: ProveOptions,
): Proof | null {
  for (const setting of settings) {
    for (const prover of provers) {
      if (whyNotTried(prover, setting.effects) !== null) continue;
      const proof = withinBudget(prover, setting, about, goal, fineness);
      if (proof !== null && (accuracy === undefined || proof.covers.includes(accuracy))) return proof;
    }
  }
  return null;
}

/** Runs one prover; null when it finds no proof, or when that would take more work than is left. */
function withinBudget(prover: Prover, setting: Setting, about: About, goal: Thing, fineness: number): Proof | null {
  const { level, budget } = setting;
  try {
    // Every prover examines all objects a few times.
    budget.look((level.asteroids.length + level.novae.length + level.repulsors.length + level.aliens.length) >> 1);
    return PROVERS[prover].prove(setting, about, goal, fineness);
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}
