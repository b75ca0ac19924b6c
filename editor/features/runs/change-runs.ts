import type { Editor, OpenLevel } from '../../core/context/index.ts';
import {
  addRun,
  type ChangeResult,
  deleteRun,
  duplicateRun,
  freeRunName,
  type Recipe,
  renameRun,
  reorderRun,
} from '../../core/document/index.ts';
import type { RunRow } from './RunLine.tsx';
import { renameDraft } from './script-draft.ts';

/** Edits of the runs of a level. Each returns the name of the run to continue with; undefined if nothing was done. */
export interface RunChanges {
  /** Shows a run; null shows none. */
  show(name: string | null): void;
  add(): string | undefined;
  rename(name: string, to: string): string | undefined;
  duplicate(name: string): string | undefined;
  /** null: no run is left */
  remove(row: RunRow): string | null | undefined;
  move(row: RunRow, place: number): void;
}

/** @param shown the name of the shown run */
export function runChanges({ session, notices }: Editor, level: OpenLevel, shown: string | null): RunChanges {
  const { document } = level;
  const change = (label: string, recipe: Recipe): ChangeResult => {
    const result = document.change(label, recipe);
    if (!result.ok) notices.refuse(result.refusal);
    return result;
  };
  const show = (name: string | null) => session.setState({ run: name, tick: 0, hoverTick: null, isPlayingBack: false });
  return {
    show,
    add() {
      const name = freeRunName(document.file(), 'solution');
      if (!change('New run', addRun(name, [])).ok) return;
      show(name);
      return name;
    },
    rename(name, to) {
      if (!change('Rename run', renameRun(name, to)).ok) return;
      renameDraft(level, name, to);
      if (shown === name) session.setState({ run: to });
      return to;
    },
    duplicate(name) {
      const as = freeRunName(document.file(), name);
      if (!change('Duplicate run', duplicateRun(name, as)).ok) return;
      show(as);
      return as;
    },
    remove({ key, place }) {
      const { runs = [] } = document.file();
      const next = runs[place + 1]?.name ?? runs[place - 1]?.name ?? null;
      if (!change('Delete run', deleteRun(key)).ok) return;
      if (shown === key) show(next);
      return next;
    },
    move: ({ key }, place) => void change('Reorder runs', reorderRun(key, place)),
  };
}
