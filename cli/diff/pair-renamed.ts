import { OBJECT_LISTS } from '../../schema/index.ts';
import { readContent } from '../../schema/level/index.ts';
import type { FileVersion, Pair } from './comparison.ts';

/** The least share of objects that a file and its new name have in common. */
const LEAST_SHARE = 0.5;

/** The ids of the objects in a level file; empty for one that is not valid. */
function idsOf({ bytes }: FileVersion): string[] {
  const read = readContent(bytes);
  if (!read.ok) return [];
  const { file } = read.document;
  return OBJECT_LISTS.flatMap((list) => (file[list] ?? []).flatMap(({ id }) => (id === undefined ? [] : [id])));
}

/**
 * Finds files that were removed under one name and added under another: they have the same content, or at least half of their
 * objects in common.
 */
export function pairRenamed(pairs: readonly Pair[]): Pair[] {
  const removed = pairs.flatMap(({ before, after }) => (before !== null && after === null ? [before] : []));
  const added = pairs.flatMap(({ before, after }) => (before === null && after !== null ? [after] : []));
  if (removed.length === 0 || added.length === 0) return [...pairs];

  const byId = new Map<string, FileVersion[]>();
  const sizes = new Map<FileVersion, number>();
  for (const file of removed) {
    const ids = idsOf(file);
    sizes.set(file, ids.length);
    for (const id of ids) byId.set(id, [...(byId.get(id) ?? []), file]);
  }
  const found: { from: FileVersion; to: FileVersion; share: number }[] = [];
  for (const to of added) {
    const same = removed.find((from) => Buffer.compare(from.bytes, to.bytes) === 0);
    if (same !== undefined) found.push({ from: same, to, share: 2 });
    const ids = idsOf(to);
    const common = new Map<FileVersion, number>();
    for (const id of ids) for (const from of byId.get(id) ?? []) common.set(from, (common.get(from) ?? 0) + 1);
    for (const [from, count] of common) {
      const share = count / Math.max(ids.length, sizes.get(from) ?? 0);
      if (share >= LEAST_SHARE) found.push({ from, to, share });
    }
  }
  const used = new Set<FileVersion>();
  const renamed: Pair[] = [];
  for (const { from, to } of found.sort((p, q) => q.share - p.share)) {
    if (used.has(from) || used.has(to)) continue;
    used.add(from);
    used.add(to);
    renamed.push({ before: from, after: to });
  }
  const isUsed = ({ before, after }: Pair): boolean =>
    (before !== null && used.has(before)) || (after !== null && used.has(after));
  return [...pairs.filter((pair) => !isUsed(pair)), ...renamed];
}
