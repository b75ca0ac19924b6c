import { createStore, type StoreApi } from 'zustand/vanilla';
import { joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { ofDocument } from '../../core/kept/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import type { Results } from '../../workers/index.ts';

/** So many runs can be compared with the shown one. */
export const MOST_COMPARED = 4;

/** What is compared: a run of the level, or an attempt of this session. */
export type Source = { readonly kind: 'run'; readonly name: string } | { readonly kind: 'attempt'; readonly number: number };

/** A run beside the shown one. */
export interface ComparedRun {
  readonly source: Source;
  /** 0 to 3: it decides number and look, and stays while the run is compared. */
  readonly slot: number;
}

/** What is known of a run in one scene. */
export interface Trajectory {
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

export type ComparingStore = StoreApi<Comparing>;

/** The runs that are compared with the shown one of a level. */
export const comparedOf = ofDocument(() => createStore<Comparing>(() => ({ runs: [], trajectories: new Map(), chosen: null })));

export const sourceKey = (source: Source): string => (source.kind === 'run' ? `run ${source.name}` : `attempt ${source.number}`);

/** Its name for people. */
export const sourceName = (source: Source): string => (source.kind === 'run' ? source.name : `attempt ${source.number}`);

/** Its effective holds; null: it is no longer there. */
export function sourceHolds(level: Pick<OpenLevel, 'document' | 'attempts'>, source: Source): readonly Hold[] | null {
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
