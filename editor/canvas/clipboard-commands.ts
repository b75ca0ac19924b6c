import type { StoreApi } from 'zustand/vanilla';
import type { Command } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import {
  copyObjects,
  deleteObjects,
  duplicateObjects,
  middleOf,
  objectsOf,
  pasteObjects,
  readClipping,
} from '../core/document/index.ts';
import { isPlayText } from '../core/shelf/index.ts';
import type { CanvasState } from './canvas-state.ts';
import type { ObjectChanges } from './selection-changes.ts';
import type { Point, View } from './view.ts';

/** Delete, duplicate, copy, cut and paste. */
export function clipboardCommands(
  editor: Editor,
  { document, selection }: OpenLevel,
  canvas: StoreApi<CanvasState>,
  changes: ObjectChanges,
): readonly Command[] {
  const { notices } = editor;
  const { needsSelected, free, change, add } = changes;
  const copy = async (): Promise<boolean> => {
    const text = copyObjects(document.file(), selection.keys());
    if (text === null) {
      notices.show('info', "A level has one astronaut and one black hole: they can't be copied.", { topic: 'clipboard' });
      return false;
    }
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      notices.show('warning', 'The browser does not let this page write to the clipboard.', { topic: 'clipboard' });
      return false;
    }
  };
  const remove = (label: string) => {
    if (selection.store.getState().holds.length > 0) return;
    const keys = free();
    if (keys.length === 0) return;
    const fixed = keys.filter((key) => objectsOf(document.file()).get(key)?.list === null);
    if (fixed.length === keys.length) {
      notices.show('info', 'Every level has one astronaut and one black hole: they can be moved, not deleted.', {
        topic: 'refused',
      });
      return;
    }
    change(label, deleteObjects(keys));
  };

  return [
    {
      id: 'edit.delete',
      title: 'Delete',
      group: 'Edit',
      keys: ['Delete', 'Backspace'],
      needs: needsSelected(1),
      run: () => remove('Delete'),
    },
    {
      id: 'edit.duplicate',
      title: 'Duplicate',
      group: 'Edit',
      keys: ['$mod+d'],
      needs: needsSelected(1),
      run: () => add('Duplicate', duplicateObjects(selection.keys(), BESIDE, BESIDE)),
    },
    { id: 'edit.copy', title: 'Copy', group: 'Edit', keys: ['$mod+c'], needs: needsSelected(1), run: () => void copy() },
    {
      id: 'edit.cut',
      title: 'Cut',
      group: 'Edit',
      keys: ['$mod+x'],
      needs: needsSelected(1),
      run: () => void copy().then((copied) => copied && remove('Cut')),
    },
    {
      id: 'edit.paste',
      title: 'Paste',
      group: 'Edit',
      keys: ['$mod+v'],
      run: () => void paste(editor, changes, canvas.getState().view, null),
    },
  ];
}

/** offset of copies from their originals, px */
const BESIDE = 32;

/**
 * Pastes objects, or opens a play that was copied as text.
 * @param at the middle of what is pasted; null: at its old place if that is visible, else in the middle of the view
 */
export async function paste(
  { notices, commands }: Pick<Editor, 'notices' | 'commands'>,
  { add }: Pick<ObjectChanges, 'add'>,
  view: View,
  at: Point | null,
): Promise<void> {
  let text: string;
  try {
    text = await navigator.clipboard.readText();
  } catch {
    notices.show('warning', 'The browser does not let this page read the clipboard.', { topic: 'clipboard' });
    return;
  }
  if (isPlayText(text)) {
    commands.run('plays.paste');
    return;
  }
  const reading = readClipping(text);
  if (!reading.ok) {
    notices.show('warning', `${reading.refusal.message}. ${reading.refusal.hint}`, { topic: 'clipboard' });
    return;
  }
  const middle = middleOf(reading.clipping);
  const to = at ?? { x: view.x, y: view.y };
  const seen =
    Math.abs(middle.x - view.x) * view.zoom < view.width / 2 && Math.abs(middle.y - view.y) * view.zoom < view.height / 2;
  const move =
    at === null && seen ? { x: BESIDE, y: BESIDE } : { x: Math.round(to.x - middle.x), y: Math.round(to.y - middle.y) };
  add(`Paste ${reading.count}`, pasteObjects(reading.clipping, move.x, move.y));
}
