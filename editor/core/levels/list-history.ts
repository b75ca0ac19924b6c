import { createStore, type StoreApi } from 'zustand/vanilla';
import { isSame } from '../../../schema/index.ts';
import type { Editor } from '../context/index.ts';
import type { EditedLevel } from '../document/index.ts';
import { keptWith } from '../kept/index.ts';

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
  /**
   * Does an action that takes time, after those before it. It counts at once: an undo that is asked for while it goes on waits and
   * takes this action back, not the step before it.
   * @param act resolves to the step; null: nothing was done, which the function itself reports
   */
  perform(label: string, act: () => Promise<ListStep | null>): Promise<void>;
  /** Takes a step back wherever it stands, and removes it. */
  takeBack(step: ListStep): void;
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

/** An action that goes on or waits. */
interface Pending {
  readonly label: string;
  isDone: boolean;
}

function createListHistory({ open }: Editor): ListHistory {
  let done: readonly Placed[] = [];
  /** those that no undo was asked for yet */
  let pending: readonly Pending[] = [];
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
    const awaited = pending.at(-1);
    const redoes = awaited === undefined ? next('redo') : null;
    return {
      undoLabel: awaited?.label ?? next('undo')?.step.label ?? state?.undoLabel ?? null,
      redoLabel: redoes?.step.label ?? state?.redoLabel ?? null,
      undoesList: awaited !== undefined || next('undo') !== null,
      redoesList: redoes !== null,
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
  const inTurn = (act: () => Promise<void>): Promise<void> => {
    const turn = last.then(act, act);
    last = turn;
    return turn;
  };
  return {
    store,
    perform(label, act) {
      const action: Pending = { label, isDone: false };
      pending = [...pending, action];
      show();
      return inTurn(async () => {
        const step = await act().finally(() => {
          pending = pending.filter((other) => other !== action);
        });
        if (step !== null) {
          action.isDone = true;
          done = [...done, place(step)];
          undone = [];
        }
        show();
      });
    },
    takeBack(step) {
      void inTurn(async () => {
        const isDone = done.some((placed) => placed.step === step);
        done = done.filter((placed) => placed.step !== step);
        undone = undone.filter((placed) => placed.step !== step);
        if (isDone) await step.undo();
        show();
      });
    },
    undo() {
      const awaited = pending.at(-1);
      pending = pending.slice(0, -1);
      const undo = go('undo');
      void inTurn(async () => {
        if (awaited?.isDone !== false) await undo();
      });
      show();
    },
    redo: () => void inTurn(go('redo')),
  };
}

/** The history of the page. */
export const listHistoryOf = keptWith(createListHistory);
