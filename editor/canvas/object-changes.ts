import type { Editor, OpenLevel } from '../context/index.ts';
import type { ChangeResult, Recipe } from '../document/index.ts';

/** Changes of what is selected, as commands make them. */
export interface ObjectChanges {
  /** Why a command needs more to be selected; null: it does not. */
  readonly needsSelected: (least: 1 | 2 | 3) => () => string | null;
  /** Changes the level; a refusal is shown. @param gesture changes of one gesture are one step */
  readonly change: (label: string, recipe: Recipe, gesture?: string) => ChangeResult;
  /** The same, and selects what was added. */
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
