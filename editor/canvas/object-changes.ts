import type { Editor, OpenLevel } from '../core/context/index.ts';
import { type ChangeResult, type ObjectKey, type Recipe, unlocked } from '../core/document/index.ts';

/** Changes of the selection by commands. */
export interface ObjectChanges {
  /** What must be selected first for a command; null if enough is. */
  readonly needsSelected: (least: 1 | 2 | 3) => () => string | null;
  /** The selected objects that are not locked; if all are locked, says so and returns none. */
  readonly free: () => readonly ObjectKey[];
  /** Says why something is not done. */
  readonly refuse: (why: string) => void;
  /** Changes the level; a refusal is shown as a notice. @param gesture changes with the same gesture form one step */
  readonly change: (label: string, recipe: Recipe, gesture?: string) => ChangeResult;
  /** Changes the level and selects the added objects. */
  readonly add: (label: string, recipe: Recipe) => void;
}

const LOCKED = 'What is selected is locked.';

export function objectChanges({ notices, commands }: Editor, { document, selection }: OpenLevel): ObjectChanges {
  const change = (label: string, recipe: Recipe, gesture?: string): ChangeResult => {
    const result = document.change(label, recipe, gesture === undefined ? {} : { gesture });
    if (!result.ok) notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`, { topic: 'refused' });
    return result;
  };
  return {
    needsSelected: (least) => () =>
      selection.keys().length >= least ? null : `select ${['an object', 'two objects', 'three objects'][least - 1]} first`,
    free() {
      const keys = unlocked(document.file(), selection.keys());
      if (keys.length === 0 && selection.keys().length > 0) {
        const actions = [{ title: 'Unlock', run: () => void commands.run('object.lock') }];
        notices.show('info', LOCKED, { topic: 'refused', actions });
      }
      return keys;
    },
    refuse: (why) => void notices.show('warning', why, { topic: 'refused' }),
    change,
    add(label, recipe) {
      const result = change(label, recipe);
      if (result.ok && result.added.length > 0) selection.select(result.added);
    },
  };
}
