import { createStore, type StoreApi } from 'zustand/vanilla';
import { isSame } from '../../../schema/index.ts';
import type { Editor } from '../../context/index.ts';
import type { EditedLevel } from '../../document/index.ts';
import { keptWith } from '../../kept/index.ts';

/** An undoable action on the list of levels, not on the contents of a level. */
export interface ListStep {
  readonly label: string;
  /** @returns whether it succeeded; a failure is reported by the function itself */
  readonly undo: () => Promise<boolean>;
  readonly redo: () => Promise<boolean>;
}

export interface HistoryState {
  /** The labels of the steps that undo and redo would apply next; null if there is none. */
  readonly undoLabel: string | null;
  readonly redoLabel: string | null;
  /** Whether these are steps of the list, not of the open level. */
  readonly undoesList: boolean;
  readonly redoesList: boolean;
}

/** Undo and redo in order of time, over both the steps of the open level and the steps of the list. */
export interface ListHistory {
  readonly store: StoreApi<HistoryState>;
  /** Adds a step that was just done. */
  add(step: ListStep): void;
  /** Removes a step that was undone in another way. */
  drop(step: ListStep): void;
  undo(): void;
  redo(): void;
}

/**
 * A step of the list, with the number of steps that each level had at that time. The step is the latest if a level now has no
 * more steps than that.
 */
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
  /** For a level that was not open at the time, counts from when it was opened. */
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
  /** The step of the list that comes before those of the level; null if a step of the level comes first or there is none. */
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
      undoesList: next('undo') !== null,
      redoesList: next('redo') !== null,
    };
  };
  const store = createStore<HistoryState>(look);
  const show = () => {
    const [now, before] = [look(), store.getState()];
    if (!isSame(now, before)) store.setState(now, true);
  };
  const follow = () => {
    stop();
    const edited = level();
    if (edited !== null) {
      for (const placed of [...done, ...undone]) markOf(placed, edited);
      const stops = [
        edited.store.subscribe(show),
        edited.onStep(({ kind }) => {
          // a new step replaces what was undone
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
    // A step that failed is dropped, so that it does not block the steps before it.
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

/** The history of the page. */
export const listHistoryOf = keptWith(createListHistory);
