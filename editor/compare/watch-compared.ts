import type { Hold } from '../../schema/index.ts';
import type { OpenLevel } from '../context/index.ts';
import type { LiveProof } from '../proof/index.ts';
import { jobs, type Results, type Running, type Workers } from '../workers/index.ts';
import { type ComparingStore, comparedOf, isCompared, isFresh, type Source, sourceHolds, sourceKey } from './compared.ts';

/** ms between two requests while the level changes: sending a large level takes a part of a frame */
const PACE = 50;

interface WatchParts {
  readonly level: Pick<OpenLevel, 'document' | 'attempts' | 'proof'>;
  readonly workers: Pick<Workers, 'start'>;
  /** Calls back after `ms`. @returns cancels it */
  readonly after: (ms: number, call: () => void) => () => void;
}

interface Wanted {
  readonly source: Source;
  readonly holds: readonly Hold[];
}

/** What was there before a change. */
interface Before {
  /** The names of all runs. */
  readonly names: readonly string[];
  /** The shown run. */
  readonly shown: string | null;
}

/**
 * Runs that are not there any more leave; one that was renamed stays, by its place. A compared run that is now the shown one
 * changes places with the one shown before.
 */
function leave(
  store: ComparingStore,
  level: WatchParts['level'],
  shown: string | null,
  { names: before, shown: last }: Before,
): void {
  const { runs } = store.getState();
  const names = (level.document.file().runs ?? []).map(({ name }) => name);
  const renamed = (name: string): string | null => {
    const at = before.indexOf(name);
    const isRename = names.length === before.length && before.every((old, i) => i === at || old === names[i]);
    return isRename && at >= 0 ? names[at] : null;
  };
  const left = runs.flatMap((one) => {
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
export function watchCompared({ level, workers, after }: WatchParts): () => void {
  const store = comparedOf(level);
  let running: Running<Results['trajectory']> | null = null;
  let forget: (() => void) | null = null;
  /** When each run was last asked for, counted in requests. */
  const asked = new Map<string, number>();
  let requests = 0;
  const seen = (): Before => ({
    names: (level.document.file().runs ?? []).map(({ name }) => name),
    shown: level.proof.proof().run.name,
  });
  let before = seen();

  /** The run that waits longest for its trajectory; null: all are known. */
  const next = (now: LiveProof): Wanted | null => {
    const { runs, trajectories } = store.getState();
    let best: Wanted | null = null;
    let least = Number.POSITIVE_INFINITY;
    for (const { source } of runs) {
      const holds = sourceHolds(level, source);
      const key = sourceKey(source);
      const turn = asked.get(key) ?? 0;
      if (holds === null || isFresh(trajectories.get(key), now, holds) || turn >= least) continue;
      least = turn;
      best = { source, holds };
    }
    return best;
  };
  const ask = () => {
    forget = null;
    const now = level.proof.proof();
    const wanted = now.limit === 'unchecked' || now.limit === 'everything' ? null : next(now);
    if (wanted === null) return;
    const key = sourceKey(wanted.source);
    asked.set(key, ++requests);
    const { scene, terms } = now;
    const { holds } = wanted;
    const mine = workers.start(jobs.trajectory, { level: { ...now.level, runs: [] }, terms, holds });
    running = mine;
    void mine.end.then((end) => {
      if (running !== mine) return;
      running = null;
      if (end.kind === 'cancelled') return;
      const found = end.kind === 'done' ? end.result : null;
      const trajectories = new Map(store.getState().trajectories).set(key, { scene, holds: holds.join(), found });
      store.setState({ trajectories });
      look();
    });
  };
  const look = () => {
    const { runs, trajectories } = store.getState();
    if (runs.length === 0) {
      running?.cancel();
      running = null;
      forget?.();
      forget = null;
      if (trajectories.size > 0) store.setState({ trajectories: new Map(), chosen: null });
      return;
    }
    if (running !== null || forget !== null || next(level.proof.proof()) === null) return;
    forget = after(requests === 0 ? 0 : PACE, ask);
  };
  const settle = () => {
    if (store.getState().runs.length > 0) leave(store, level, level.proof.proof().run.name, before);
    before = seen();
    look();
  };
  settle();
  const stops = [level.proof.store.subscribe(settle), level.attempts.store.subscribe(settle), store.subscribe(look)];
  return () => {
    for (const stop of stops) stop();
    running?.cancel();
    running = null;
    forget?.();
  };
}
