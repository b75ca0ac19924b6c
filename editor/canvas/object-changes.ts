import type { Editor, OpenLevel } from '../context/index.ts';
import type { ChangeResult, Recipe } from '../document/index.ts';

/** Changes of the selection by commands. */
export interface ObjectChanges {
  /** What must be selected first for a command; null if enough is. */
  readonly needsSelected: (least: 1 | 2 | 3) => () => string | null;
  /** Changes the level; a refusal is shown as a notice. @param gesture changes with the same gesture form one step */
  readonly change: (label: string, recipe: Recipe, gesture?: string) => ChangeResult;
  /** Changes the level and selects the added objects. */
  readonly add: (label: string, recipe: Recipe) => void;
}

export function objectChanges({ notices }: Editor, { document, selection }: OpenLevel): ObjectChanges {
  const change = (label: string, recipe: Recipe, gesture?: string): ChangeResult => {
    const result = document.change(label, recipe, gesture === undefined ? {} : { gesture });
    if (!result.ok) notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`, { topic: 'refused' });
    return result;
  };
  return {
    needsSelected: (least) => () =>
      selection.keys().length >= least ? null : `select ${['an object', 'two objects', 'three objects'][least - 1]} first`,
    change,
    add(label, recipe) {
      const result = change(label, recipe);
      if (result.ok && result.added.length > 0) selection.select(result.added);
    },
  };
}
