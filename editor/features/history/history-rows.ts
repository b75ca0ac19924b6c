import type { TreeRow } from '../../core/tree/index.ts';
import type { Version } from '../../core/versions/index.ts';
import { stepsInWords } from './version-rows.ts';
import { dayInWords } from './when.ts';

/** A row of the history: a day, or a version of that day. */
export interface HistoryRow extends TreeRow {
  /** null for a day */
  readonly version: Version | null;
  /** For a day, what it is called and how many versions it has. */
  readonly day: string;
  readonly count: number;
}

/** The key of the row of a version. */
export const keyOf = ({ number }: Pick<Version, 'number'>): string => `version ${number}`;

/**
 * The rows of a history, the newest first, grouped by day.
 * @param now ms since 1970
 * @param folded names of days whose versions are not shown
 */
export function historyRows(versions: readonly Version[], now: number, folded: ReadonlySet<string>): HistoryRow[] {
  const days = new Map<string, Version[]>();
  for (const version of [...versions].sort((p, q) => q.time - p.time || q.number - p.number)) {
    const day = dayInWords(version.time, now);
    const others = days.get(day);
    if (others === undefined) days.set(day, [version]);
    else others.push(version);
  }
  return [...days].flatMap(([day, ofDay], place) => {
    const head: HistoryRow = {
      ...{ key: `day ${day}`, depth: 1, label: day, expanded: !folded.has(day), list: null, place, siblings: days.size },
      ...{ version: null, day, count: ofDay.length },
    };
    if (folded.has(day)) return [head];
    const rows = ofDay.map(
      (version, i): HistoryRow => ({
        ...{
          key: keyOf(version),
          depth: 2,
          label: version.name ?? (version.changes || stepsInWords(version)),
          expanded: null,
          list: null,
        },
        ...{ place: i, siblings: ofDay.length, version, day, count: 1 },
      }),
    );
    return [head, ...rows];
  });
}
