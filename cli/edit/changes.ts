import type { EditEvent, LevelEntry, ListResponse } from '../../schema/index.ts';

/**
 * The events between two states of a folder. If a file is gone and a new file has its content, the file was renamed.
 * @param by the client that made the changes; null: another program
 */
export function changesBetween(before: ListResponse, after: ListResponse, by: string | null): EditEvent[] {
  const old = new Map(before.levels.map((entry) => [entry.id, entry]));
  const now = new Map(after.levels.map((entry) => [entry.id, entry]));
  const gone = before.levels.filter(({ id }) => !now.has(id));
  const byContent = new Map<string, LevelEntry[]>();
  // reversed, because `pop` takes the last one: the first must come first
  for (const entry of gone.toReversed()) {
    if (entry.etag === null) continue;
    const same = byContent.get(entry.etag);
    if (same === undefined) byContent.set(entry.etag, [entry]);
    else same.push(entry);
  }
  const events: EditEvent[] = [];
  const isAccountedFor = new Set<LevelEntry>();
  for (const entry of after.levels) {
    if (entry.etag === null || old.has(entry.id)) continue;
    const from = byContent.get(entry.etag)?.pop();
    if (from === undefined) continue;
    isAccountedFor.add(from).add(entry);
    events.push({ type: 'renamed', from: from.id, entry, by });
  }
  for (const entry of gone) if (!isAccountedFor.has(entry)) events.push({ type: 'removed', id: entry.id, by });
  for (const entry of after.levels) {
    const other = old.get(entry.id);
    const isNews = other === undefined ? !isAccountedFor.has(entry) : !isSame(other, entry);
    if (isNews) events.push({ type: 'changed', entry, by });
  }
  if (!isSame([before.folders, before.troubles], [after.folders, after.troubles])) events.push({ type: 'list', list: after });
  return events;
}

/** Compares identity first: an entry that was not read again is the same object. */
const isSame = (a: unknown, b: unknown): boolean => a === b || JSON.stringify(a) === JSON.stringify(b);
