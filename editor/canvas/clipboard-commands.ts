import type { StoreApi } from 'zustand/vanilla';
import type { Command } from '../commands/index.ts';
import type { Editor, OpenLevel } from '../context/index.ts';
import {
  copyObjects,
  deleteObjects,
  duplicateObjects,
  middleOf,
  objectsOf,
  pasteObjects,
  readClipping,
} from '../document/index.ts';
import { isPlayText } from '../shelf/index.ts';
import type { CanvasState } from './canvas-state.ts';
import type { ObjectChanges } from './object-changes.ts';

/** offset of copies from their originals, px */
const BESIDE = 32;

/** Delete, duplicate, copy, cut and paste. */
export function clipboardCommands(
  { notices, commands }: Editor,
  { document, selection }: OpenLevel,
  canvas: StoreApi<CanvasState>,
  { needsSelected, change, add }: ObjectChanges,
): readonly Command[] {
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
  const paste = async () => {
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
    const { view } = canvas.getState();
    const middle = middleOf(reading.clipping);
    // At its old place if that is visible, else in the middle of the view.
    const seen =
      Math.abs(middle.x - view.x) * view.zoom < view.width / 2 && Math.abs(middle.y - view.y) * view.zoom < view.height / 2;
    const move = seen ? { x: BESIDE, y: BESIDE } : { x: Math.round(view.x - middle.x), y: Math.round(view.y - middle.y) };
    add(`Paste ${reading.count}`, pasteObjects(reading.clipping, move.x, move.y));
  };
  const remove = (label: string) => {
    if (selection.store.getState().holds.length > 0) return;
    const fixed = selection.keys().filter((key) => objectsOf(document.file()).get(key)?.list === null);
    if (fixed.length === selection.keys().length) {
      notices.show('info', 'Every level has one astronaut and one black hole: they can be moved, not deleted.', {
        topic: 'refused',
      });
      return;
    }
    change(label, deleteObjects(selection.keys()));
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
    { id: 'edit.paste', title: 'Paste', group: 'Edit', keys: ['$mod+v'], run: () => void paste() },
  ];
}
