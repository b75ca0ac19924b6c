import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Goal, Objective } from '../../../solver/index.ts';

/** The settings of a search for runs. */
export interface SearchSettings {
  readonly minerals: 'any' | 'all' | 'some';
  /** the number for `some` */
  readonly some: number;
  readonly objective: Objective;
  /** s */
  readonly budget: number;
  readonly seed: number;
}

export type SearchSettingsStore = StoreApi<SearchSettings>;

export const createSearchSettings = (): SearchSettingsStore =>
  createStore<SearchSettings>(() => ({ minerals: 'any', some: 1, objective: 'robust', budget: 10, seed: 0 }));

/** The goal of a run. @param count minerals in the level */
export function goalOf({ minerals, some }: SearchSettings, count: number): Goal {
  if (minerals === 'some') return { minerals: Math.min(some, count) };
  // Without minerals in the level, all means any.
  return { minerals: minerals === 'all' && count > 0 ? 'all' : 'any' };
}

const AIMS: Readonly<Record<Objective, string>> = { robust: 'safest', presses: 'simplest', time: 'quickest', first: 'found' };

/** The name of a run found with these settings: `safest`, `all minerals, quickest`, `safest 2` for the second best. */
export function aimOf({ minerals, some, objective }: SearchSettings, place: number): string {
  const taken =
    minerals === 'all' ? ['all minerals'] : minerals === 'some' ? [`${some} ${some === 1 ? 'mineral' : 'minerals'}`] : [];
  // for runs with minerals, safest is the default and goes without saying
  const best = taken.length > 0 && (objective === 'robust' || objective === 'first') ? [] : [AIMS[objective]];
  return [...taken, ...best].join(', ') + (place > 1 ? ` ${place}` : '');
}
