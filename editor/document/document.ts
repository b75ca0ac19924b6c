import { freeze, produce } from 'immer';
import { createStore, type StoreApi } from 'zustand/vanilla';
import { isSame, type LevelFile, OBJECT_LISTS } from '../../schema/index.ts';
import { History } from './history.ts';
import { createListeners } from './listeners.ts';
import { objectsOf } from './objects.ts';
import { applyPatches, diffFiles, type Patch } from './patch.ts';
import { type Refusal, settle } from './settle.ts';

/** Changes a draft of the file in place, as with immer. The result is settled, so numbers may be out of range. */
export type Recipe = (draft: LevelFile) => void;

export interface DocumentState {
  /** A valid level in which every object has an id; frozen. */
  readonly file: LevelFile;
  /** A number that is unique to this content and never reused. */
  readonly revision: number;
  /** The labels of the steps that undo and redo would apply; null if there is none. */
  readonly undoLabel: string | null;
  readonly redoLabel: string | null;
  /** The number of steps done and of all steps, for a list of the history. */
  readonly done: number;
  readonly steps: number;
}

/** A change of the file. */
export interface DocumentEvent {
  readonly kind: 'change' | 'undo' | 'redo';
  readonly label: string;
  readonly before: LevelFile;
  readonly file: LevelFile;
  /** From `before` to `file`. */
  readonly patches: readonly Patch[];
}

export type ChangeResult =
  | {
      readonly ok: true;
      /** Keys of the objects that were added, to select them. */
      readonly added: readonly string[];
    }
  | { readonly ok: false; readonly refusal: Refusal };

/**
 * A change in progress, such as a drag. Every `set` starts from the file as it was when the gesture began, so recipes describe
 * the whole change and nothing accumulates. `commit` makes it one step of the history.
 */
export interface Gesture {
  /** Does nothing once the gesture is over. Another change, an undo or a change on disk ends it. */
  set(recipe: Recipe): ChangeResult;
  commit(): void;
  /** Restores the file as it was before the gesture. */
  cancel(): void;
  readonly isLive: boolean;
}

/** The open level: what is edited, undone, saved and simulated. */
export interface EditedLevel {
  readonly store: StoreApi<DocumentState>;
  file(): LevelFile;
  /** The file as it was before a gesture in progress, else the current file: the version to keep and save. */
  settledFile(): LevelFile;
  /**
   * Makes one step of the history. If the last step has the same `gesture` and is not sealed, it is extended instead: keys held
   * down, letters typed.
   */
  change(label: string, recipe: Recipe, options?: { readonly gesture?: string }): ChangeResult;
  /** Replaces the file in one step: by a version from disk, a merge, a text. */
  replace(label: string, file: LevelFile): ChangeResult;
  begin(label: string): Gesture;
  /** Whether the last step may still be extended: keys held down, letters typed. */
  isGrowing(): boolean;
  /** Seals the last step and ends a gesture in progress: the field lost the focus, the key was released. */
  seal(): void;
  undo(): boolean;
  redo(): boolean;
  /** Undoes or redoes until `done` steps are done. */
  goTo(done: number): void;
  /** The labels of all steps, oldest first; the first `done` of them are done. */
  labels(): string[];
  /** Calls back on every visible change, including those within a gesture. @returns stops it */
  subscribe(listener: (event: DocumentEvent) => void): () => void;
  /** Calls back on every change to keep: changes outside gestures, committed gestures, undo and redo. @returns stops it */
  onStep(listener: (event: DocumentEvent) => void): () => void;
}

/** The last step while it may be extended. */
interface Growing {
  readonly gesture: string;
  readonly before: LevelFile;
}

/** Keys of the objects that are new in a file. */
function addedKeys(before: LevelFile, after: LevelFile): string[] {
  // most changes add none
  const hasSame = (list: (typeof OBJECT_LISTS)[number]) => {
    const [old, now] = [before[list] ?? [], after[list] ?? []];
    return old === now || (old.length === now.length && now.every(({ id }, i) => id === old[i].id));
  };
  if (OBJECT_LISTS.every(hasSame)) return [];
  const old = objectsOf(before);
  return [...objectsOf(after).keys()].filter((key) => !old.has(key));
}

/**
 * Opens a level for editing.
 * @param file a valid level; missing ids are added, which is not a step of the history
 * @throws RangeError if the file is not a valid level
 */
export function createEditedLevel(file: LevelFile): EditedLevel {
  const first = settle(file, null);
  if (!first.ok) throw new RangeError(`not a valid level: ${first.refusal.message}`);

  const history = new History();
  let revision = 0;
  let current = freeze(first.file, true);
  let growing: Growing | null = null;
  let open: { readonly start: LevelFile; readonly label: string } | null = null;
  const live = createListeners<DocumentEvent>();
  const steps = createListeners<DocumentEvent>();

  const state = (): DocumentState => {
    const { undoLabel, redoLabel, done, length } = history;
    return { file: current, revision, undoLabel, redoLabel, done, steps: length };
  };
  const store = createStore<DocumentState>(state);

  /**
   * @param known the patches to the new file; null: computed on demand, which never happens while hundreds of objects are
   * dragged
   */
  const show = (kind: DocumentEvent['kind'], label: string, file: LevelFile, known: readonly Patch[] | null): DocumentEvent => {
    const event = eventOf(kind, label, current, file, known);
    current = freeze(file, true);
    revision++;
    store.setState(state(), true);
    live.call(event);
    return event;
  };
  const endGesture = () => {
    if (open === null) return;
    const { start, label } = open;
    open = null;
    const patches = diffFiles(start, current);
    if (patches.length === 0) return;
    history.record(label, start, current, patches);
    store.setState(state(), true);
    steps.call({ kind: 'change', label, before: start, file: current, patches });
  };
  const seal = () => {
    endGesture();
    growing = null;
  };

  const put = (label: string, next: LevelFile, gesture: string | null): ChangeResult => {
    const settled = settle(next, current);
    if (!settled.ok) return settled;
    const before = current;
    const patches = diffFiles(before, settled.file);
    if (patches.length === 0) return { ok: true, added: [] };
    if (gesture !== null && growing?.gesture === gesture && history.mayGrow) {
      history.recordAgain(label, growing.before, settled.file);
    } else {
      history.record(label, before, settled.file, patches);
      growing = gesture === null ? null : { gesture, before };
    }
    steps.call(show('change', label, settled.file, patches));
    return { ok: true, added: addedKeys(before, settled.file) };
  };

  const step = (kind: 'undo' | 'redo'): boolean => {
    seal();
    const gone = history.go(kind);
    if (gone === null) return false;
    steps.call(show(kind, gone.label, applyPatches(current, gone.patches), gone.patches));
    return true;
  };

  const begin = (label: string): Gesture => {
    seal();
    const mine = { start: current, label };
    open = mine;
    return {
      get isLive() {
        return open === mine;
      },
      set(recipe) {
        if (open !== mine) return { ok: true, added: [] };
        const settled = settle(
          produce(mine.start, (draft) => void recipe(draft)),
          mine.start,
        );
        if (!settled.ok) return settled;
        if (!isSame(current, settled.file)) show('change', label, settled.file, null);
        return { ok: true, added: addedKeys(mine.start, settled.file) };
      },
      commit() {
        if (open === mine) endGesture();
      },
      cancel() {
        if (open !== mine) return;
        open = null;
        if (!isSame(current, mine.start)) show('change', label, mine.start, null);
      },
    };
  };

  return {
    store,
    file: () => current,
    settledFile: () => open?.start ?? current,
    change(label, recipe, { gesture } = {}) {
      endGesture();
      return put(
        label,
        produce(current, (draft) => void recipe(draft)),
        gesture ?? null,
      );
    },
    replace(label, file) {
      seal();
      return put(label, file, null);
    },
    begin,
    isGrowing: () => growing !== null,
    seal,
    undo: () => step('undo'),
    redo: () => step('redo'),
    goTo(wanted) {
      while (history.done > wanted && step('undo'));
      while (history.done < wanted && step('redo'));
    },
    labels: () => history.labels(),
    subscribe: live.add,
    onStep: steps.add,
  };
}

/** @param known the patches to the new file; null: computed on demand */
function eventOf(
  kind: DocumentEvent['kind'],
  label: string,
  before: LevelFile,
  file: LevelFile,
  known: readonly Patch[] | null,
): DocumentEvent {
  let patches = known;
  return {
    kind,
    label,
    before,
    file,
    get patches() {
      patches ??= diffFiles(before, file);
      return patches;
    },
  };
}
