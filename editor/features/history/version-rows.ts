import type { TreeRow } from '../../core/tree/index.ts';
import type { Version } from '../../core/versions/index.ts';

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

// what a version is, in words

/** Labels in which those that follow each other and are equal are one: `Nudge ×3`. */
function runsOf(labels: readonly string[]): string[] {
  const runs: { label: string; count: number }[] = [];
  for (const label of labels) {
    const last = runs.at(-1);
    if (last?.label === label) last.count++;
    else runs.push({ label, count: 1 });
  }
  return runs.map(({ label, count }) => (count === 1 ? label : `${label} ×${count}`));
}

const UNLABELLED = {
  page: 'Saved',
  other: 'Changed by another program',
  found: 'Found when the level was opened',
} as const;

/** What led to a version: `Move asteroid 3, Add hold`. */
export function stepsInWords({ labels, more, by }: Pick<Version, 'labels' | 'more' | 'by'>): string {
  const shown = runsOf(labels);
  if (shown.length === 0) return UNLABELLED[by];
  return more === 0 ? shown.join(', ') : `${more} earlier ${more === 1 ? 'step' : 'steps'}, ${shown.join(', ')}`;
}

const WHO = {
  page: 'Saved by this editor.',
  other: 'Written by another program.',
  found: 'It was there when the level was opened, so who wrote it is not known.',
} as const;

/** Who made a version, as a sentence. */
export const whoInWords = ({ by }: Pick<Version, 'by'>): string => WHO[by];

// when a version was made

const DAY = 24 * 3_600_000;

const twoDigits = (n: number): string => String(n).padStart(2, '0');

/** The time of day, of this machine: `14:32`. @param time ms since 1970 */
export const clockTime = (time: number): string => {
  const date = new Date(time);
  return `${twoDigits(date.getHours())}:${twoDigits(date.getMinutes())}`;
};

// not by the browser's locale: the page speaks English, and browsers differ in commas
const WEEKDAYS = ['Sunday', 'Monday', 'Tuesday', 'Wednesday', 'Thursday', 'Friday', 'Saturday'];
const MONTHS = [
  ...['January', 'February', 'March', 'April', 'May', 'June'],
  ...['July', 'August', 'September', 'October', 'November', 'December'],
];

/** `23 November 2026` */
const dateInWords = (date: Date): string => `${date.getDate()} ${MONTHS[date.getMonth()]} ${date.getFullYear()}`;

const midnight = (time: number): number => new Date(time).setHours(0, 0, 0, 0);

/** The day of a time: `Today`, `Yesterday`, `Monday, 23 November 2026`. @param now ms since 1970 */
export function dayInWords(time: number, now: number): string {
  // the days around a change of the clocks have 23 and 25 hours
  const days = Math.round((midnight(now) - midnight(time)) / DAY);
  if (days === 0) return 'Today';
  if (days === 1) return 'Yesterday';
  const date = new Date(time);
  return `${WEEKDAYS[date.getDay()]}, ${dateInWords(date)}`;
}

/** A day and a time: `14:32`, `yesterday 14:32`, `23 November 2026, 14:32`. */
export function momentInWords(time: number, now: number): string {
  const day = dayInWords(time, now);
  if (day === 'Today') return clockTime(time);
  if (day === 'Yesterday') return `yesterday ${clockTime(time)}`;
  return `${dateInWords(new Date(time))}, ${clockTime(time)}`;
}

const UNITS = [
  ['day', DAY],
  ['hour', 3_600_000],
  ['minute', 60_000],
] as const;

/** How long ago: `5 minutes ago`, `just now`. */
export function agoInWords(time: number, now: number): string {
  for (const [unit, ms] of UNITS) {
    const count = Math.floor((now - time) / ms);
    if (count > 0) return `${count} ${unit}${count === 1 ? '' : 's'} ago`;
  }
  return 'just now';
}
