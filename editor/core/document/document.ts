import { freeze, produce } from 'immer';
import { createStore } from 'zustand/vanilla';
import { isSame, type LevelFile, OBJECT_LISTS } from '../../../schema/index.ts';
import {
  type ChangeResult,
  createListeners,
  type DocumentEvent,
  type DocumentState,
  type EditedLevel,
  type Gesture,
  type Recipe,
  type StepMark,
} from './edited-level.ts';
import { normalize } from './normalize.ts';
import { objectsOf } from './objects.ts';
import { applyPatches, diffFiles, type Patch } from './patch.ts';

/** The last step while it may be extended. */
interface Growing {
  readonly gesture: string;
  readonly before: LevelFile;
}

/** The last step, as long as it was not undone. */
interface LastStep {
  readonly mark: StepMark;
  readonly label: string;
  readonly before: LevelFile;
}

const NOT_LAST = {
  ok: false,
  refusal: { message: 'the step is not the last one any more', hint: 'Something else was done since.' },
} as const;

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
  const first = normalize(file, null);
  if (!first.ok) throw new RangeError(`not a valid level: ${first.refusal.message}`);

  const history = new History();
  let revision = 0;
  let current = freeze(first.file, true);
  let growing: Growing | null = null;
  let open: { readonly start: LevelFile; readonly label: string; readonly gesture: Gesture } | null = null;
  let last: LastStep | null = null;
  const live = createListeners<DocumentEvent>();
  const steps = createListeners<DocumentEvent>();

  const state = (): DocumentState => {
    const { undoLabel, redoLabel, done, length } = history;
    return { file: current, revision, undoLabel, redoLabel, done, steps: length };
  };
  const store = createStore<DocumentState>(state);

  /** @param event its patches are computed on demand, which never happens while hundreds of objects are dragged */
  const show = (event: DocumentEvent): DocumentEvent => {
    current = freeze(event.file, true);
    revision++;
    store.setState(state(), true);
    live.call(event);
    return event;
  };
  const record = (label: string, before: LevelFile, file: LevelFile, patches: readonly Patch[]) => {
    history.record(label, before, file, patches);
    last = { mark: Symbol(label), label, before };
  };
  const recordAgain = (label: string, before: LevelFile, file: LevelFile) => {
    history.recordAgain(label, before, file);
    last = { mark: Symbol(label), label, before };
  };
  const endGesture = () => {
    if (open === null) return;
    const { start, label } = open;
    open = null;
    const patches = diffFiles(start, current);
    if (patches.length === 0) return;
    record(label, start, current, patches);
    store.setState(state(), true);
    steps.call(changed('edited', label, start, start, current, patches));
  };
  const seal = () => {
    endGesture();
    growing = null;
  };

  const put = (how: DocumentEvent['how'], label: string, next: LevelFile, gesture: string | null): ChangeResult => {
    const normalized = normalize(next, current);
    if (!normalized.ok) return normalized;
    const before = current;
    const patches = diffFiles(before, normalized.file);
    if (patches.length === 0) return { ok: true, added: [] };
    if (gesture !== null && growing?.gesture === gesture && history.mayGrow) {
      recordAgain(label, growing.before, normalized.file);
    } else {
      record(label, before, normalized.file, patches);
      growing = gesture === null ? null : { gesture, before };
    }
    steps.call(show(changed(how, label, growing?.before ?? before, before, normalized.file, patches)));
    return { ok: true, added: addedKeys(before, normalized.file) };
  };

  const step = (kind: 'undo' | 'redo'): boolean => {
    seal();
    const gone = history.go(kind);
    if (gone === null) return false;
    last = null;
    const file = applyPatches(current, gone.patches);
    const { label, patches } = gone;
    steps.call(show({ kind, how: 'edited', label, start: current, before: current, file, patches }));
    return true;
  };

  const begin = (label: string): Gesture => {
    seal();
    const start = current;
    let recipes: { readonly main: Recipe | null; readonly also: Recipe | null } = { main: null, also: null };
    const isLive = () => open?.gesture === gesture;
    /** Makes the file anew from the one before the gesture. What is refused changes nothing. */
    const make = (wanted: typeof recipes): ChangeResult => {
      if (!isLive()) return { ok: true, added: [] };
      const { main, also } = wanted;
      const made = main === null ? start : produce(start, (draft) => void main(draft));
      const normalized = normalize(also === null ? made : produce(made, (draft) => void also(draft)), start);
      if (!normalized.ok) return normalized;
      recipes = wanted;
      if (!isSame(current, normalized.file)) show(changed('edited', label, start, current, normalized.file, null));
      return { ok: true, added: addedKeys(start, normalized.file) };
    };
    const gesture: Gesture = {
      get isLive() {
        return isLive();
      },
      set: (main) => make({ ...recipes, main }),
      also: (also) => make({ ...recipes, also }),
      commit() {
        if (isLive()) endGesture();
      },
      cancel() {
        if (!isLive()) return;
        open = null;
        if (!isSame(current, start)) show(changed('edited', label, start, current, start, null));
      },
    };
    open = { start, label, gesture };
    return gesture;
  };

  const amend = (step: StepMark, recipe: Recipe): ChangeResult => {
    if (open !== null || last?.mark !== step || !history.mayGrow) return NOT_LAST;
    const { label, before: start } = last;
    const normalized = normalize(
      produce(current, (draft) => void recipe(draft)),
      current,
    );
    if (!normalized.ok) return normalized;
    const patches = diffFiles(current, normalized.file);
    if (patches.length === 0) return { ok: true, added: [] };
    const added = addedKeys(current, normalized.file);
    history.recordAgain(label, start, normalized.file);
    steps.call(show(changed('amended', label, start, current, normalized.file, patches)));
    return { ok: true, added };
  };

  return {
    store,
    file: () => current,
    committedFile: () => open?.start ?? current,
    change(label, recipe, { gesture } = {}) {
      endGesture();
      return put(
        'edited',
        label,
        produce(current, (draft) => void recipe(draft)),
        gesture ?? null,
      );
    },
    replace(label, file) {
      seal();
      return put('replaced', label, file, null);
    },
    begin,
    isGrowing: () => growing !== null,
    gesture: () => open?.gesture ?? null,
    lastStep: () => (history.mayGrow ? (last?.mark ?? null) : null),
    amend,
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
function changed(
  how: DocumentEvent['how'],
  label: string,
  start: LevelFile,
  before: LevelFile,
  file: LevelFile,
  known: readonly Patch[] | null,
): DocumentEvent {
  let patches = known;
  return {
    kind: 'change',
    how,
    label,
    start,
    before,
    file,
    get patches() {
      patches ??= diffFiles(before, file);
      return patches;
    },
  };
}

interface Step {
  readonly label: string;
  readonly patches: readonly Patch[];
  readonly inverse: readonly Patch[];
}

/** The steps that led to a level, and those that were undone. Steps are only added at the end. */
class History {
  private readonly steps: Step[] = [];
  private count = 0;

  /** The number of steps done. */
  get done(): number {
    return this.count;
  }

  get length(): number {
    return this.steps.length;
  }

  get undoLabel(): string | null {
    return this.count > 0 ? this.steps[this.count - 1].label : null;
  }

  get redoLabel(): string | null {
    return this.count < this.steps.length ? this.steps[this.count].label : null;
  }

  /** The labels of all steps, oldest first. */
  labels(): string[] {
    return this.steps.map(({ label }) => label);
  }

  /** Adds a step and discards the undone ones. @param patches from `before` to `after` */
  record(label: string, before: LevelFile, after: LevelFile, patches: readonly Patch[]): void {
    this.steps.length = this.count;
    this.steps.push({ label, patches, inverse: diffFiles(after, before) });
    this.count++;
  }

  /** Whether the last step may be extended: there is one, and nothing was undone after it. */
  get mayGrow(): boolean {
    return this.count === this.steps.length && this.count > 0;
  }

  /** Replaces the last step by one from `before` to `after`. */
  recordAgain(label: string, before: LevelFile, after: LevelFile): void {
    this.count--;
    this.record(label, before, after, diffFiles(before, after));
  }

  /** Undoes or redoes a step. @returns its label and the patches to apply; null if there is none */
  go(kind: 'undo' | 'redo'): { readonly label: string; readonly patches: readonly Patch[] } | null {
    const step = this.steps[kind === 'undo' ? this.count - 1 : this.count];
    if (step === undefined) return null;
    this.count += kind === 'undo' ? -1 : 1;
    return { label: step.label, patches: kind === 'undo' ? step.inverse : step.patches };
  }
}
