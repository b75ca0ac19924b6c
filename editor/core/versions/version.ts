export const VERSION_MAKERS = ['page', 'other', 'found'] as const;

/**
 * Who made a version: this editor; another program, while the level was open; or nobody knows, as the file was different when
 * the level was opened.
 */
export type VersionBy = (typeof VERSION_MAKERS)[number];

/** One version of a level that was on disk, or was named, without its text. */
export interface Version {
  /** Counts up within a history; numbers of versions that were thinned out are missing. */
  readonly number: number;
  /** When it was recorded, ms since 1970. */
  readonly time: number;
  readonly by: VersionBy;
  /** The labels of the last steps that led to it, oldest first. */
  readonly labels: readonly string[];
  /** How many earlier steps led to it besides those. */
  readonly more: number;
  /** What it changed in the version before it, in words; empty if that is not known, or that one was thinned out. */
  readonly changes: string;
  /** What a person called it; null: nothing. A version with a name is never thinned out. */
  readonly name: string | null;
  /** Of its text: see `checkOf`. */
  readonly check: string;
  /** The version whose whole text its own is made of; its own number if its text is stored whole. */
  readonly base: number;
  /** Characters that are stored for it. */
  readonly size: number;
}

/** A version that is noted, but not recorded yet. */
export interface Noted extends Pick<Version, 'time' | 'by' | 'labels'> {
  readonly text: string;
}

/** A version with its text, as it goes into a file. */
export interface PastVersion extends Pick<Version, 'time' | 'by' | 'labels' | 'more' | 'changes' | 'name'> {
  readonly text: string;
}

/** The order of versions in time. */
export const inTime = (versions: readonly Version[]): Version[] =>
  versions.filter(isVersion).sort((p, q) => p.time - q.time || p.number - q.number);

/** The most labels that a version keeps. */
const MOST_LABELS = 12;

/** The labels of steps, and how many earlier ones are left out. */
export function shortened(labels: readonly string[], more = 0): Pick<Version, 'labels' | 'more'> {
  const left = Math.max(0, labels.length - MOST_LABELS);
  return { labels: labels.slice(left), more: more + left };
}

/** A fingerprint of a text, 64 bits: tells a damaged text from a whole one. It protects against accidents only. */
export function checkOf(text: string): string {
  let [a, b] = [0x811c9dc5, 0x1b873593];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    a = Math.imul(a ^ code, 0x01000193);
    b = Math.imul(b ^ code, 0x85ebca6b);
    b = (b << 13) | (b >>> 19);
  }
  const hex = (n: number) => (n >>> 0).toString(16).padStart(8, '0');
  return `${hex(a)}${hex(b ^ text.length)}`;
}

/** Whether a stored row is a version, and not damaged. */
const isVersion = (row: Version): boolean =>
  [row.number, row.time, row.more, row.base, row.size].every(Number.isFinite) &&
  VERSION_MAKERS.includes(row.by) &&
  typeof row.changes === 'string' &&
  (row.name === null || typeof row.name === 'string') &&
  typeof row.check === 'string' &&
  Array.isArray(row.labels) &&
  row.labels.every((label) => typeof label === 'string');
