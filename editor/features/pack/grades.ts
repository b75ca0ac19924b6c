import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import { ENGINE_ID } from '../../../game/index.ts';
import type { LevelEntry } from '../../../schema/index.ts';
import { keepAnswers, onDemand } from '../../core/ask/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { keptWith } from '../../core/kept/index.ts';
import { factsKey } from '../../core/levels/index.ts';
import { jobs } from '../../workers/index.ts';
import type { ShownGrade } from './pack-model.ts';

/** A measured grade; `value` is null if none of the level's runs completes it. */
interface MeasuredGrade {
  readonly value: number | null;
  readonly word: string;
}

export interface GradesState {
  /** By what the grade depends on: content and terms. */
  readonly byKey: ReadonlyMap<string, MeasuredGrade>;
  /** The last key of each level that has a grade. */
  readonly lastKey: ReadonlyMap<string, string>;
  /** What is being measured; null: nothing. */
  readonly running: { readonly id: string; readonly done: number; readonly of: number } | null;
}

export interface Grades {
  readonly store: StoreApi<GradesState>;
  /** Measures the levels that have no grade yet, one after the other. */
  measure(entries: readonly LevelEntry[], terms: Terms): void;
  stop(): void;
}

const KEY = 'gravity-quest-editor-grades';
/** number of grades that are kept in this browser */
const KEPT = 2000;

/** What is kept, for one state of the engine: another one may grade differently. */
interface Stored {
  readonly engine: string;
  readonly grades: readonly (readonly [key: string, grade: MeasuredGrade])[];
  readonly last: readonly (readonly [id: string, key: string])[];
}

const NOTHING = { byKey: new Map(), lastKey: new Map() };

function load(): Pick<GradesState, 'byKey' | 'lastKey'> {
  try {
    const stored = JSON.parse(window.localStorage.getItem(KEY) ?? 'null') as Stored | null;
    if (stored?.engine === ENGINE_ID) return { byKey: new Map(stored.grades), lastKey: new Map(stored.last) };
  } catch {
    // without the storage of the browser, or with one that somebody else has written, grades are measured anew
  }
  return NOTHING;
}

function save({ byKey, lastKey }: GradesState): void {
  const stored: Stored = { engine: ENGINE_ID, grades: [...byKey].slice(-KEPT), last: [...lastKey].slice(-KEPT) };
  try {
    window.localStorage.setItem(KEY, JSON.stringify(stored));
  } catch {
    // they last as long as the page
  }
}

/** The grade of a level's file as it is; if that has none, the grade that it had before; null if there is neither. */
export function gradeOf(state: GradesState, folder: string, entry: LevelEntry, terms: Terms): ShownGrade | null {
  const key = entry.status === 'valid' ? factsKey(entry, terms) : null;
  const now = key === null ? undefined : state.byKey.get(key);
  if (now !== undefined) return { ...now, isOld: false };
  const before = state.byKey.get(state.lastKey.get(`${folder}/${entry.id}`) ?? '');
  return before === undefined ? null : { ...before, isOld: true };
}

/** The grades of the levels, measured on demand and kept by content, so that none is measured twice. */
export const gradesOf = keptWith(createGrades);

/** The grade of a level file by its own runs. */
export const gradeQuestion = onDemand(jobs.grade);

interface WantedGrade {
  readonly entry: LevelEntry;
  readonly terms: Terms;
  /** How many are measured before it, and how many in all. */
  readonly done: number;
  readonly of: number;
}

function createGrades({ workspace, desk }: Editor): Grades {
  // in the storage of a browser the tag of a level counts its changes, and says nothing of its content
  const lasts = workspace.storage.kind === 'server';
  const { byKey, lastKey } = lasts ? load() : NOTHING;
  const measured = keepAnswers(
    desk,
    {
      ask: gradeQuestion,
      async of({ entry, terms }: WantedGrade) {
        const answer = await workspace.storage.read(entry.id);
        // a file that has changed in the meantime has another grade
        if (!answer.ok || answer.value.text === null || answer.value.etag !== entry.etag) return null;
        return { text: answer.value.text, terms };
      },
      value({ phase, answer }, { entry }, key): MeasuredGrade | null {
        if (phase !== 'done') return null;
        const place = `${workspace.store.getState().list?.folder.id ?? ''}/${entry.id}`;
        store.setState(({ lastKey }) => ({ lastKey: new Map(lastKey).set(place, key) }));
        return answer ?? { value: null, word: 'no run completes it' };
      },
      first: 'earliest',
      most: Number.POSITIVE_INFINITY,
    },
    byKey,
  );
  const store = createStore<GradesState>(() => ({ byKey, lastKey, running: null }));
  measured.store.subscribe(({ byKey, making }) => {
    const isNew = byKey !== store.getState().byKey;
    store.setState({ byKey, running: making && { id: making.entry.id, done: making.done, of: making.of } });
    if (isNew && lasts) save(store.getState());
  });
  return {
    store,
    measure(entries, terms) {
      measured.stop();
      const known = store.getState().byKey;
      const waiting = entries.flatMap((entry) => {
        const key = entry.status === 'valid' ? factsKey(entry, terms) : null;
        return key === null || known.has(key) ? [] : [{ entry, key }];
      });
      for (const [done, { entry, key }] of waiting.entries()) measured.want(key, { entry, terms, done, of: waiting.length });
    },
    stop: measured.stop,
  };
}
