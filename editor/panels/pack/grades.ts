import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import { ENGINE_ID } from '../../../game/index.ts';
import type { LevelEntry } from '../../../schema/index.ts';
import type { Editor } from '../../context/index.ts';
import { keptWith } from '../../kept/index.ts';
import { jobs, type Results, type Running } from '../../workers/index.ts';
import { factsKey } from '../levels/index.ts';
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

function createGrades({ workspace, workers }: Editor): Grades {
  // in the storage of a browser the tag of a level counts its changes, and says nothing of its content
  const lasts = workspace.storage.kind === 'server';
  const store = createStore<GradesState>(() => ({ ...(lasts ? load() : NOTHING), running: null }));
  let waiting: LevelEntry[] = [];
  let job: Running<Results['grade']> | null = null;
  /** Grows with every start and stop, so that what was begun before knows that it is over. */
  let turn = 0;

  const keep = (entry: LevelEntry, key: string, grade: MeasuredGrade) => {
    const { byKey, lastKey } = store.getState();
    const place = `${workspace.store.getState().list?.folder.id ?? ''}/${entry.id}`;
    store.setState({ byKey: new Map(byKey).set(key, grade), lastKey: new Map(lastKey).set(place, key) });
    if (lasts) save(store.getState());
  };
  const measureOne = async (entry: LevelEntry, terms: Terms, mine: number): Promise<void> => {
    const key = factsKey(entry, terms);
    const answer = await workspace.storage.read(entry.id);
    // a file that has changed in the meantime has another grade
    if (mine !== turn || key === null || !answer.ok || answer.value.text === null || answer.value.etag !== entry.etag) return;
    const started = workers.start(jobs.grade, { text: answer.value.text, terms });
    job = started;
    const end = await started.end;
    if (mine !== turn) return;
    if (end.kind === 'done') keep(entry, key, end.result ?? { value: null, word: 'no run completes it' });
  };
  const stop = () => {
    turn++;
    waiting = [];
    job?.cancel();
    job = null;
    if (store.getState().running !== null) store.setState({ running: null });
  };
  return {
    store,
    measure(entries, terms) {
      stop();
      const mine = turn;
      waiting = entries.filter((entry) => entry.status === 'valid' && !store.getState().byKey.has(factsKey(entry, terms) ?? ''));
      const all = waiting.length;
      const go = async () => {
        for (let entry = waiting.shift(); entry !== undefined && mine === turn; entry = waiting.shift()) {
          store.setState({ running: { id: entry.id, done: all - waiting.length - 1, of: all } });
          await measureOne(entry, terms, mine);
        }
        if (mine === turn) store.setState({ running: null });
      };
      if (all > 0) void go();
    },
    stop,
  };
}
