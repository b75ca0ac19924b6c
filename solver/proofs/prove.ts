import { type AccuracyName, unlimited, type WorkBudget, WorkLimitReached } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { whyNotTried } from './assumptions.ts';
import { proveNothingInRange, proveStartsInHazard } from './at-start.ts';
import { proveCovered } from './covered.ts';
import { proveDoomed } from './doomed.ts';
import { proveEnclosed } from './enclosure.ts';
import { proveFlowpipe } from './flowpipe.ts';
import { proveOutOfRange } from './islands.ts';
import { proveDeadEnds, proveLineTrap } from './line.ts';
import type { About, Proof, Prover } from './proof.ts';
import { type Setting, settingOf, type Thing, thingOf } from './setting.ts';

export interface ProveOptions {
  /** the accuracy the proof has to cover; when left out one that covers all is looked for first, then one that covers continuous time */
  readonly accuracy?: AccuracyName;
  /** longest run, s; 60 when left out. Only recoil makes a difference: it moves asteroids as long as a run lasts */
  readonly maxTime?: number;
  /** what looking for proofs may cost: used up, no more is found. No limit when left out */
  readonly budget?: WorkBudget;
}

type Kind = (setting: Setting, about: About, goal: Thing) => Proof | null;

// those a designer understands at a glance first
const CHEAP: readonly Prover[] = ['nothing-in-range', 'starts-in-hazard', 'out-of-range', 'line-trap'];

/** Cost milliseconds each. */
const DEAR: readonly Prover[] = ['covered', 'enclosed', 'dead-end'];

/** For so many minerals the dear ones are tried. */
const MOST_MINERALS = 64;

/** A proof that the black hole can't be reached, or null where none is found: then it may still be out of reach. */
export function proveImpossible(level: Level, options: ProveOptions = {}): Proof | null {
  const settings = settingsOf(level, options);
  const goal = thingOf(level, level.blackHole);
  const about = { kind: 'blackHole' } as const;
  return prove(settings, [...CHEAP, ...DEAR], about, goal, options) ?? proveSoonOver(settings, about, goal, options);
}

/** Ways to prove, each by itself; `dead-end` makes proofs of the kind `line-trap`. */
export const PROVERS = {
  'nothing-in-range': proveNothingInRange,
  'starts-in-hazard': proveStartsInHazard,
  'out-of-range': proveOutOfRange,
  'line-trap': proveLineTrap,
  covered: proveCovered,
  enclosed: proveEnclosed,
  'dead-end': proveDeadEnds,
  doomed: proveDoomed,
  flowpipe: proveFlowpipe,
} as const satisfies Record<Prover, Kind>;

/** A proof by one of the ways alone, for who wants to know what that one would say; null where it finds none. */
export function proveBy(prover: Prover, level: Level, about: About, options: ProveOptions = {}): Proof | null {
  const goal = thingOf(level, about.kind === 'blackHole' ? level.blackHole : level.minerals[about.index]);
  return prove(settingsOf(level, options), [prover], about, goal, options);
}

/** A proof for each mineral that is proved to be out of reach in every run; of very many minerals only by what is cheap to prove. */
export function proveMineralsUnreachable(level: Level, options: ProveOptions = {}): Proof[] {
  const settings = settingsOf(level, options);
  // where not all runs are over soon, that is so whatever mineral is looked at
  let isSoonOver: boolean | null = null;
  return level.minerals.flatMap((mineral, index) => {
    const about = { kind: 'mineral', index } as const;
    const goal = thingOf(level, mineral);
    const proof = prove(settings, level.minerals.length <= MOST_MINERALS ? [...CHEAP, ...DEAR] : CHEAP, about, goal, options);
    if (proof !== null) return proof;
    isSoonOver ??= proveSoonOver(settings, { kind: 'blackHole' }, thingOf(level, level.blackHole), options) !== null;
    return isSoonOver ? (proveSoonOver(settings, about, goal, options) ?? []) : [];
  });
}

/** What costs up to seconds, and only where she starts moving: first what holds for frames and for continuous time alike. */
function proveSoonOver(settings: readonly Setting[], about: About, goal: Thing, options: ProveOptions): Proof | null {
  return (
    prove(settings.slice(0, 1), ['doomed'], about, goal, options) ?? prove(settings.slice(-1), ['flowpipe'], about, goal, options)
  );
}

/** Frames first: what holds for them holds for continuous time. */
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
  { accuracy }: ProveOptions,
): Proof | null {
  for (const setting of settings) {
    for (const prover of provers) {
      if (whyNotTried(prover, setting.effects) !== null) continue;
      const proof = withinBudget(PROVERS[prover], setting, about, goal);
      if (proof !== null && (accuracy === undefined || proof.covers.includes(accuracy))) return proof;
    }
  }
  return null;
}

/** What a kind of proof comes to; null too where it would take more work than is left. */
function withinBudget(kind: Kind, setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, budget } = setting;
  try {
    // each kind looks at all things some times
    budget.look((level.asteroids.length + level.novae.length + level.repulsors.length + level.aliens.length) >> 1);
    return kind(setting, about, goal);
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}
