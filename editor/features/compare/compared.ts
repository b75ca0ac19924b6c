import { createStore, type StoreApi } from 'zustand/vanilla';
import { ACCURACIES, type AccuracyName, joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type Desk, question } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { ofDocument } from '../../core/kept/index.ts';
import { type LiveProof, withoutRuns } from '../../core/proof/index.ts';
import { termsAt } from '../../core/terms/index.ts';
import { accuracyNameOf, jobs, type Results } from '../../workers/index.ts';

/** So many runs can be compared with the shown one. */
export const MOST_COMPARED = 4;

/** What is compared: a run of the level, an attempt of this session, or the shown run at another accuracy. */
export type Source =
  | { readonly kind: 'run'; readonly name: string }
  | { readonly kind: 'attempt'; readonly number: number }
  | { readonly kind: 'accuracy'; readonly name: AccuracyName };

/** A run beside the shown one. */
export interface ComparedRun {
  readonly source: Source;
  /** 0 to 3: it decides number and look, and stays while the run is compared. */
  readonly slot: number;
}

/** What is known of a run in one scene. */
interface Trajectory {
  readonly scene: Scene;
  /** Its effective holds, joined by commas. */
  readonly holds: string;
  /** null: the simulation was given up */
  readonly found: Results['trajectory'] | null;
}

export interface Comparing {
  /** In order of their slots. */
  readonly runs: readonly ComparedRun[];
  /** By {@link sourceKey}; of an earlier state of the level until the new one is known. */
  readonly trajectories: ReadonlyMap<string, Trajectory>;
  /** The key of the run whose difference is shown; null: that of the first. */
  readonly chosen: string | null;
}

type ComparingStore = StoreApi<Comparing>;

/** The runs that are compared with the shown one of a level. */
export const comparedOf = ofDocument(() => createStore<Comparing>(() => ({ runs: [], trajectories: new Map(), chosen: null })));

export const sourceKey = (source: Source): string =>
  source.kind === 'attempt' ? `attempt ${source.number}` : `${source.kind} ${source.name}`;

/** Its name for people. */
export const sourceName = (source: Source): string => (source.kind === 'attempt' ? `attempt ${source.number}` : source.name);

type ComparedLevel = Pick<OpenLevel, 'document' | 'attempts' | 'proof'>;

/** Its effective holds; null: it is no longer there. */
export function sourceHolds(level: ComparedLevel, source: Source): readonly Hold[] | null {
  if (source.kind === 'accuracy') return joinHolds(level.proof.proof().run.holds);
  const found =
    source.kind === 'run'
      ? level.document.file().runs?.find(({ name }) => name === source.name)
      : level.attempts.store.getState().find(({ number }) => number === source.number);
  return found === undefined ? null : joinHolds(found.holds);
}

/** The run whose difference is shown. */
export const chosenOf = ({ runs, chosen }: Comparing): ComparedRun | null =>
  runs.find(({ source }) => sourceKey(source) === chosen) ?? runs[0] ?? null;

/** Whether a trajectory is that of the level as it is now. */
export const isFresh = (trajectory: Trajectory | undefined, now: Pick<LiveProof, 'scene'>, holds: readonly Hold[]): boolean =>
  trajectory !== undefined && trajectory.scene === now.scene && trajectory.holds === holds.join();

export const isCompared = ({ runs }: Comparing, source: Source): boolean =>
  runs.some((one) => sourceKey(one.source) === sourceKey(source));

/** Puts a run beside the shown one, or takes it away. @returns whether that was possible: there is room for four */
export function toggleCompared(store: ComparingStore, source: Source): boolean {
  const { runs } = store.getState();
  if (isCompared(store.getState(), source)) {
    store.setState({ runs: runs.filter((one) => sourceKey(one.source) !== sourceKey(source)) });
    return true;
  }
  if (runs.length === MOST_COMPARED) return false;
  const slot = [...Array(MOST_COMPARED).keys()].find((free) => runs.every((one) => one.slot !== free)) ?? 0;
  store.setState({ runs: [...runs, { source, slot }].sort((a, b) => a.slot - b.slot) });
  return true;
}

/** Compares the shown run with itself at every accuracy that is not in use, and with nothing else; or stops that. */
export function toggleAccuracies(store: ComparingStore, inUse: AccuracyName): void {
  if (store.getState().runs.some(({ source }) => source.kind === 'accuracy')) {
    store.setState(({ runs }) => ({ runs: runs.filter(({ source }) => source.kind !== 'accuracy') }));
    return;
  }
  const others = (Object.keys(ACCURACIES) as AccuracyName[]).filter((name) => name !== inUse);
  const runs = others.slice(0, MOST_COMPARED).map((name, slot): ComparedRun => ({ source: { kind: 'accuracy', name }, slot }));
  store.setState({ runs, chosen: null });
}

// their trajectories

/** A run whose trajectory is not known. */
interface Unknown {
  readonly source: Source;
  readonly holds: readonly Hold[];
  readonly now: LiveProof;
}

interface Comparisons {
  readonly level: ComparedLevel;
  readonly store: ComparingStore;
  /** When each run was last asked for, counted in requests. */
  readonly asked: ReadonlyMap<string, number>;
}

/** The run that waits longest for its trajectory; null: all are known, or the level is not simulated. */
function nextOf({ level, store, asked }: Comparisons): Unknown | null {
  const now = level.proof.proof();
  if (now.limit === 'unchecked' || now.limit === 'everything') return null;
  const { runs, trajectories } = store.getState();
  let best: Unknown | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const { source } of runs) {
    const holds = sourceHolds(level, source);
    const key = sourceKey(source);
    const turn = asked.get(key) ?? 0;
    if (holds === null || isFresh(trajectories.get(key), now, holds) || turn >= least) continue;
    least = turn;
    best = { source, holds, now };
  }
  return best;
}

/** The trajectory of a compared run. */
export const trajectoryQuestion = question({
  job: jobs.trajectory,
  request: ({ source, holds, now }: Unknown) => ({
    level: withoutRuns(now.level),
    terms: source.kind === 'accuracy' ? termsAt(now.terms, source.name) : now.terms,
    holds,
  }),
  follows: {
    // sending a large level takes a part of a frame
    wait: { pace: 50 },
    of: nextOf,
    same: (asked, now) =>
      asked.now.scene === now.now.scene &&
      sourceKey(asked.source) === sourceKey(now.source) &&
      asked.holds.join() === now.holds.join(),
    on: ({ level, store }) => [level.proof.store.subscribe, level.attempts.store.subscribe, store.subscribe],
  },
});

/** What was there before a change. */
interface Before {
  /** The names of all runs. */
  readonly names: readonly string[];
  /** The shown run. */
  readonly shown: string | null;
  /** The accuracy in use. */
  readonly accuracy: AccuracyName;
}

/**
 * Runs that are not there any more leave; one that was renamed stays, by its place. A compared run that is now the shown one
 * changes places with the one shown before, and so does an accuracy that is now in use.
 */
function leave(store: ComparingStore, level: ComparedLevel, now: Before, { names: before, shown: last, accuracy }: Before): void {
  const { runs } = store.getState();
  const { shown } = now;
  const names = (level.document.file().runs ?? []).map(({ name }) => name);
  const renamed = (name: string): string | null => {
    const at = before.indexOf(name);
    const isRename = names.length === before.length && before.every((old, i) => i === at || old === names[i]);
    return isRename && at >= 0 ? names[at] : null;
  };
  const left = runs.flatMap((one) => {
    if (one.source.kind === 'accuracy') {
      if (one.source.name !== now.accuracy) return [one];
      const source = { kind: 'accuracy' as const, name: accuracy };
      return accuracy === now.accuracy || isCompared(store.getState(), source) ? [] : [{ ...one, source }];
    }
    if (one.source.kind === 'run' && one.source.name === shown) {
      const isFree =
        last !== null && last !== shown && names.includes(last) && !isCompared(store.getState(), { kind: 'run', name: last });
      return isFree ? [{ ...one, source: { kind: 'run' as const, name: last } }] : [];
    }
    if (sourceHolds(level, one.source) !== null) return [one];
    const to = one.source.kind === 'run' ? renamed(one.source.name) : null;
    return to === null || to === shown ? [] : [{ ...one, source: { kind: 'run' as const, name: to } }];
  });
  if (left.length !== runs.length || left.some((one, i) => one !== runs[i])) store.setState({ runs: left });
}

/**
 * Keeps the trajectories of compared runs up to date, by a worker: one request at a time, for the level as it is when the last one is
 * answered. Nothing is done while no run is compared. @returns stops it
 */
export function watchCompared(level: ComparedLevel, desk: Desk): () => void {
  const store = comparedOf(level);
  const asked = new Map<string, number>();
  const seen = (): Before => ({
    names: (level.document.file().runs ?? []).map(({ name }) => name),
    shown: level.proof.proof().run.name,
    accuracy: accuracyNameOf(level.proof.proof().terms),
  });
  let before = seen();
  const follow = () => {
    if (store.getState().runs.length > 0) leave(store, level, seen(), before);
    before = seen();
  };
  const empty = () => {
    const { runs, trajectories } = store.getState();
    if (runs.length === 0 && trajectories.size > 0) store.setState({ trajectories: new Map(), chosen: null });
  };
  follow();
  empty();
  // first, as the question is about the runs that are left
  const stops = [level.proof.store.subscribe(follow), level.attempts.store.subscribe(follow), store.subscribe(empty)];
  const trajectory = trajectoryQuestion(desk, { level, store, asked });
  stops.push(
    trajectory.store.subscribe(({ phase, of, answer }) => {
      if (of === null) return;
      const key = sourceKey(of.source);
      if (phase === 'asking') asked.set(key, asked.size === 0 ? 1 : Math.max(...asked.values()) + 1);
      if (phase !== 'done' && phase !== 'failed') return;
      const found = { scene: of.now.scene, holds: of.holds.join(), found: answer };
      store.setState(({ trajectories }) => ({ trajectories: new Map(trajectories).set(key, found) }));
    }),
  );
  return () => {
    for (const stop of stops) stop();
    trajectory.close();
  };
}
