import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Editor } from '../../context/index.ts';
import type { EditedLevel } from '../../document/index.ts';

/** Something that was done to the list of levels and not to what is in one. */
export interface ListStep {
  readonly label: string;
  /** @returns whether it was done; why not is reported by whoever does it */
  readonly undo: () => Promise<boolean>;
  readonly redo: () => Promise<boolean>;
}

export interface HistoryState {
  /** What undo and redo would take back or bring again; null when there is nothing. */
  readonly undoLabel: string | null;
  readonly redoLabel: string | null;
}

/** Undo and redo in the order of time, across the history of the open level and what was done to the list. */
export interface ListHistory {
  readonly store: StoreApi<HistoryState>;
  /** A step that was just done. */
  add(step: ListStep): void;
  /** Takes a step out that was taken back in another way. */
  drop(step: ListStep): void;
  undo(): void;
  redo(): void;
}

/** A step and how many steps of each level were done then: fewer or as many are done now where it is the last of all. */
interface Placed {
  readonly step: ListStep;
  readonly marks: WeakMap<EditedLevel, number>;
}

function createListHistory({ open }: Editor): ListHistory {
  let done: readonly Placed[] = [];
  let undone: readonly Placed[] = [];
  let last: Promise<unknown> = Promise.resolve();
  let stop = () => {};

  const level = (): EditedLevel | null => open.getState()?.document ?? null;
  /** Of a level that was not open then nothing was done until it was opened. */
  const markOf = ({ marks }: Placed, edited: EditedLevel): number => {
    const mark = marks.get(edited) ?? edited.store.getState().done;
    marks.set(edited, mark);
    return mark;
  };
  const place = (step: ListStep): Placed => {
    const placed: Placed = { step, marks: new WeakMap() };
    const edited = level();
    if (edited !== null) markOf(placed, edited);
    return placed;
  };
  /** The step of the list that comes before those of the level; null: the level's comes first, or there is none. */
  const next = (kind: 'undo' | 'redo'): Placed | null => {
    const placed = (kind === 'undo' ? done : undone).at(-1) ?? null;
    const edited = level();
    if (placed === null || edited === null) return placed;
    const now = edited.store.getState().done;
    return kind === 'undo' ? (now <= markOf(placed, edited) ? placed : null) : now >= markOf(placed, edited) ? placed : null;
  };
  const look = (): HistoryState => {
    const state = level()?.store.getState();
    return {
      undoLabel: next('undo')?.step.label ?? state?.undoLabel ?? null,
      redoLabel: next('redo')?.step.label ?? state?.redoLabel ?? null,
    };
  };
  const store = createStore<HistoryState>(look);
  const show = () => {
    const [now, before] = [look(), store.getState()];
    if (now.undoLabel !== before.undoLabel || now.redoLabel !== before.redoLabel) store.setState(now, true);
  };
  const follow = () => {
    stop();
    const edited = level();
    if (edited !== null) {
      for (const placed of [...done, ...undone]) markOf(placed, edited);
      const stops = [
        edited.store.subscribe(show),
        edited.onStep(({ kind }) => {
          // what is done anew takes the place of what was taken back
          if (kind === 'change') undone = [];
        }),
      ];
      stop = () => {
        for (const end of stops) end();
      };
    }
    show();
  };
  follow();
  open.subscribe(follow);

  const go = (kind: 'undo' | 'redo') => async () => {
    const placed = next(kind);
    if (placed === null) {
      const edited = level();
      if (kind === 'undo') edited?.undo();
      else edited?.redo();
      return;
    }
    const { step } = placed;
    if (kind === 'undo') done = done.slice(0, -1);
    else undone = undone.slice(0, -1);
    // what can't be done is no step any more: it must not be in the way of those before it
    if (await step[kind]()) {
      if (kind === 'undo') undone = [...undone, place(step)];
      else done = [...done, place(step)];
    }
    show();
  };
  const inTurn = (act: () => Promise<void>) => {
    last = last.then(act, act);
  };
  return {
    store,
    add(step) {
      done = [...done, place(step)];
      undone = [];
      show();
    },
    drop(step) {
      done = done.filter((placed) => placed.step !== step);
      undone = undone.filter((placed) => placed.step !== step);
      show();
    },
    undo: () => inTurn(go('undo')),
    redo: () => inTurn(go('redo')),
  };
}

const histories = new WeakMap<Editor, ListHistory>();

/** The page's history. */
export function listHistoryOf(editor: Editor): ListHistory {
  const known = histories.get(editor);
  if (known !== undefined) return known;
  const made = createListHistory(editor);
  histories.set(editor, made);
  return made;
}
