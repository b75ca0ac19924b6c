import type { StoreApi } from 'zustand/vanilla';
import { formatLevel, type LevelFile } from '../../../schema/index.ts';
import { keptWith } from '../kept/index.ts';
import type { Refusal } from './normalize.ts';
import type { Patch } from './patch.ts';

/** Changes a draft of the file in place, as with immer. The result is normalized, so numbers may be out of range. */
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
  /** Within a change: edited by hand, replaced as a whole, or a step that was extended afterwards. */
  readonly how: 'edited' | 'replaced' | 'amended';
  readonly label: string;
  /** The file before the step that this belongs to: a gesture and a growing step change it several times. */
  readonly start: LevelFile;
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
  /**
   * What the gesture changes besides: it follows the recipe, and stays while that is set anew. It replaces an earlier one; null
   * removes it.
   */
  also(recipe: Recipe | null): ChangeResult;
  commit(): void;
  /** Restores the file as it was before the gesture. */
  cancel(): void;
  readonly isLive: boolean;
}

/** A step of the history that may be amended. */
export type StepMark = symbol;

/** The open level: what is edited, undone, saved and simulated. */
export interface EditedLevel {
  readonly store: StoreApi<DocumentState>;
  file(): LevelFile;
  /** The file as it was before a gesture in progress, else the current file: the version to keep and save. */
  committedFile(): LevelFile;
  /**
   * Makes one step of the history. If the last step has the same `gesture` and is not sealed, it is extended instead: keys held
   * down, letters typed.
   */
  change(label: string, recipe: Recipe, options?: { readonly gesture?: string }): ChangeResult;
  /** Replaces the file in one step: by a version from disk, a merge, a text. */
  replace(label: string, file: LevelFile): ChangeResult;
  begin(label: string): Gesture;
  /** The gesture in progress; null if there is none. */
  gesture(): Gesture | null;
  /** The last step; null if there is none or it was undone. */
  lastStep(): StepMark | null;
  /**
   * Extends a step, so that one undo takes back both. Refused once there was another step, an undo or a change on disk, and while
   * a gesture is in progress.
   */
  amend(step: StepMark, recipe: Recipe): ChangeResult;
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

/** The canonical text of a level file. It is made once: saving, telling other tabs and recording need the same one. */
export const levelText = keptWith((file: LevelFile) => formatLevel(file));

/** The listeners for events of one kind. */
interface Listeners<E> {
  /** @returns removes it */
  add(listener: (event: E) => void): () => void;
  /** Calls all current listeners. */
  call(event: E): void;
}

export function createListeners<E>(): Listeners<E> {
  const all = new Set<(event: E) => void>();
  return {
    add(listener) {
      all.add(listener);
      return () => all.delete(listener);
    },
    call(event) {
      for (const listener of [...all]) listener(event);
    },
  };
}
