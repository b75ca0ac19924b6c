import type { StoreApi } from 'zustand/vanilla';
import type { Command } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import { copyObjects, deleteObjects, duplicateObjects, objectsOf } from '../core/document/index.ts';
import type { CanvasState } from './canvas-state.ts';
import type { ObjectChanges } from './object-changes.ts';
import { BESIDE, paste } from './paste.ts';

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
