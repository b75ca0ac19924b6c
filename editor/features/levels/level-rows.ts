import { moveLevel } from '../../../check/pack/index.ts';
import type { LevelEntry } from '../../../schema/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { plural } from '../../core/figures/index.ts';
import { folderOf, folderPackIn, idsIn } from '../../core/files/index.ts';
import { deleteLevel, duplicateLevel, editPack, orderLevels, stemOf } from '../../core/levels/index.ts';
import type { MenuEntry, TreeRow } from '../../core/tree/index.ts';

export interface LevelRow extends TreeRow {
  /** null for the row of a folder */
  readonly entry: LevelEntry | null;
  readonly title: string;
  /** The number of levels in the folder; 0 for a level. */
  readonly count: number;
}

/** Whether every word occurs in the level's name or file name. */
function matches({ id, name }: LevelEntry, search: string): boolean {
  const text = `${name ?? ''} ${id}`.toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/**
 * The levels of a folder and its subfolders, as a tree.
 * @param folded folders whose levels are hidden
 * @param search words that must all match; while there are any, nothing can be moved and every folder is open
 */
export function levelRows(levels: readonly LevelEntry[], folded: ReadonlySet<string>, search: string): LevelRow[] {
  const found = search.trim() === '' ? levels : levels.filter((entry) => matches(entry, search.trim()));
  const byFolder = new Map<string, LevelEntry[]>();
  for (const entry of found) {
    const folder = folderOf(entry.id);
    byFolder.set(folder, [...(byFolder.get(folder) ?? []), entry]);
  }
  const canMove = found.length === levels.length;
  const top = byFolder.get('') ?? [];
  const folders = [...byFolder.keys()].filter((folder) => folder !== '');
  const siblings = top.length + folders.length;
  const level = (entry: LevelEntry, depth: number, list: string, place: number, count: number): LevelRow => {
    const title = entry.name ?? stemOf(entry.id);
    const label = entry.status === 'valid' ? title : `${title}, ${entry.status}`;
    return {
      key: entry.id,
      depth,
      label,
      expanded: null,
      list: canMove ? list : null,
      place,
      siblings: count,
      entry,
      title,
      count: 0,
    };
  };
  const rows = top.map((entry, place) => level(entry, 1, '', place, siblings));
  for (const [i, folder] of folders.entries()) {
    const entries = byFolder.get(folder) ?? [];
    const expanded = !canMove || !folded.has(folder);
    const place = top.length + i;
    const count = entries.length;
    const label = `${folder}, ${plural(count, 'level')}`;
    rows.push({ key: `${folder}/`, depth: 1, label, expanded, list: null, place, siblings, entry: null, title: folder, count });
    if (expanded) rows.push(...entries.map((entry, k) => level(entry, 2, folder, k, entries.length)));
  }
  return rows;
}

// what is done with a row

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
