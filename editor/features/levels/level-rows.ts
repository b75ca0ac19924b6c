import type { LevelEntry } from '../../../schema/index.ts';
import { plural } from '../../core/figures/index.ts';
import { folderOf } from '../../core/files/index.ts';
import { stemOf } from '../../core/levels/index.ts';
import type { TreeRow } from '../../core/tree/index.ts';

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
