import { entryChange, isAgreed } from '../../check/lock/index.ts';
import { plural } from '../../check/words/index.ts';
import type { LockEntry } from '../../schema/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { visibleLine } from '../io/index.ts';
import { entryOf, hasResult } from './entry.ts';
import { lockedFile, lockKey, type OpenedLock, writeLock } from './lock-file.ts';

/**
 * Agrees anew: writes the results of levels into a lock, and keeps the other entries.
 * @param isGone whether the level file of an entry existed under the checked paths and is gone
 * @returns what has changed, for people
 */
export async function updateLock(
  levels: readonly CheckedLevel[],
  { file, lock }: OpenedLock,
  isGone: (levelFile: string) => boolean,
): Promise<string> {
  const before = new Map(Object.entries(lock.levels));
  const after = new Map<string, LockEntry>(before);
  const lines: string[] = [];
  const counts = { added: 0, changed: 0, unchanged: 0, removed: 0 };
  for (const level of levels) {
    const key = lockKey(file, level.file);
    const old = before.get(key);
    if (!hasResult(level)) {
      lines.push(`  kept ${key}: it could not be checked`);
      continue;
    }
    const entry = entryOf(level);
    after.set(key, entry);
    if (old === undefined) {
      counts.added++;
      lines.push(`  added ${key}: ${entryInWords(entry)}`);
    } else if (isAgreed(entry, old)) {
      counts.unchanged++;
    } else {
      counts.changed++;
      lines.push(`  changed ${key}: ${entryChange(entry, old)}`);
    }
  }
  const checked = new Set(levels.map((level) => lockKey(file, level.file)));
  for (const key of before.keys()) {
    if (checked.has(key) || !isGone(lockedFile(file, key))) continue;
    after.delete(key);
    counts.removed++;
    lines.push(`  removed ${key}: the level is gone`);
  }
  const isWritten = await writeLock(file, { ...lock, levels: Object.fromEntries(after) });
  const said = Object.entries(counts).flatMap(([what, count]) => (count > 0 ? [`${count} ${what}`] : []));
  const other = after.size - counts.added - counts.changed - counts.unchanged;
  if (other > 0) said.push(`${plural(other, 'other entry', 'other entries')} kept`);
  const head = `${file}: ${isWritten ? 'agreed anew' : 'nothing to write'}${said.length === 0 ? '' : `: ${said.join(', ')}`}`;
  return [head, ...lines].map((line) => `${visibleLine(line)}\n`).join('');
}

function entryInWords({ verdict, outcome, tick }: LockEntry): string {
  return outcome === undefined ? verdict : `${verdict}, ${outcome} at tick ${tick}`;
}
