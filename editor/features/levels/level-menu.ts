import { moveLevel } from '../../../check/pack/index.ts';
import type { LevelEntry } from '../../../schema/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { folderOf, folderPackIn, idsIn } from '../../core/files/index.ts';
import { deleteLevel, duplicateLevel, editPack, orderLevels } from '../../core/levels/index.ts';
import type { MenuEntry } from '../../core/tree/index.ts';
import type { LevelRow } from './level-rows.ts';

interface MenuParts {
  /** The id of the open level. */
  readonly opened: string | null;
  readonly onOpen: () => void;
  /** Called to edit the level as text. */
  readonly onText: (entry: LevelEntry) => void;
  /** Called to rename the level. */
  readonly onRename: (id: string) => void;
}

/** The context menu of a row in the list of levels. @param levels all levels */
export function levelMenu(
  editor: Editor,
  levels: readonly LevelEntry[],
  { entry, list, place }: LevelRow,
  { opened, onOpen, onText, onRename }: MenuParts,
): readonly MenuEntry[] {
  const newLevel = { title: 'New level…', keys: 'Alt N', run: () => editor.session.setState({ overlay: 'newLevel' }) };
  if (entry === null) return [newLevel];
  const isFixed = list === null;
  const last = idsIn(levels, folderOf(entry.id)).length - 1;
  const move = (to: number) => () => moveTo(editor, levels, entry, to);
  return [
    { title: 'Open', keys: 'Enter', disabled: entry.status !== 'valid' || entry.id === opened, run: onOpen },
    { title: 'Edit as text…', disabled: entry.status === 'unreadable', run: () => onText(entry) },
    null,
    newLevel,
    { title: 'Rename…', keys: 'F2', disabled: entry.readOnly !== null, run: () => onRename(entry.id) },
    { title: 'Duplicate', disabled: entry.etag === null, run: () => void duplicateLevel(editor, entry) },
    {
      title: 'History',
      keys: 'Y',
      disabled: entry.id !== opened,
      run: () => editor.session.setState({ overlay: 'history' }),
    },
    { title: 'Delete', keys: 'Del', disabled: entry.etag === null, run: () => void deleteLevel(editor, entry) },
    null,
    { title: 'Move up', keys: 'Alt ↑', disabled: isFixed || place === 0, run: move(place - 1) },
    { title: 'Move down', keys: 'Alt ↓', disabled: isFixed || place >= last, run: move(place + 1) },
    { title: 'Copy file path', run: () => void copyPath(editor, entry.file) },
  ];
}

/** Moves a level to another place in its folder: in the order of the pack, or, without one, by the numbers of the files. */
export function moveTo(editor: Editor, levels: readonly LevelEntry[], entry: LevelEntry | null, place: number): void {
  if (entry === null) return;
  const folder = folderOf(entry.id);
  const ids = idsIn(levels, folder);
  const from = ids.indexOf(entry.id);
  ids.splice(from, 1);
  ids.splice(place, 0, entry.id);
  if (ids.indexOf(entry.id) === from) return;
  if (folderPackIn(editor.workspace.store.getState()).kind === 'none') void orderLevels(editor, folder, ids);
  else {
    const all = levels.map(({ id }) => id);
    void editPack(editor, 'Reorder levels', (pack) =>
      moveLevel(pack, all, entry.id, ids[place - 1] ?? null, ids[place + 1] ?? null),
    );
  }
}

/** Copies the path of a file to the clipboard. */
export async function copyPath({ notices }: Editor, path: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(path);
    notices.show('info', `Copied ${path}`, { topic: 'clipboard' });
  } catch {
    notices.show('warning', `The browser does not let this page write to the clipboard. The path is ${path}`, {
      topic: 'clipboard',
    });
  }
}
