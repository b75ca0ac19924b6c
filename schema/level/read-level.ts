import { type Finding, formatValue, LEVEL_VERSION, type Level, type OwnRules, type Problem } from '../basics/index.ts';
import { readJson, type TextPlace, toProblems } from '../json/index.ts';
import { checkMeaning, checkShape } from './check-shape.ts';
import { type JsonObject, MIGRATIONS, type Migration, migrate, readVersion, type VersionReading } from './migrate.ts';
import { resolveLevel } from './resolve.ts';
import type { LevelFile } from './shape.ts';

/** A level file that was read, with its text. */
export interface LevelDocument {
  /** The text as it was read, without a byte order mark. */
  readonly text: string;
  /** The content as written: what is left out is missing, and x- keys are kept. Migrated if the file is of an older version. */
  readonly file: LevelFile;
  /** The version of the file if it is an older one, otherwise null. */
  readonly migratedFrom: number | null;
  /**
   * Finds the place of a value.
   *
   * @param pointer - a JSON pointer
   * @returns where the value begins in the text; if there is no such value, the nearest one that contains its place
   */
  locate(pointer: string): TextPlace;
}

/** The outcome of {@link readLevel}: with `ok` true the level and its document, otherwise the problems. */
export type LevelReading =
  | {
      /** The file is a valid level. */
      readonly ok: true;
      /** The level with every default filled in. */
      readonly level: Level;
      /** The file as it was written. */
      readonly document: LevelDocument;
    }
  | {
      /** The file is not a valid level. */
      readonly ok: false;
      /** What is wrong with it, in the order of the text; at least one. */
      readonly problems: Problem[];
      /** The text without a byte order mark; '' if the file is too large or not a text. */
      readonly text: string;
    };

/** Options of {@link readLevel}. */
export interface ReadLevelOptions {
  /** Whether a byte order mark at the start is a problem or skipped; `refuse` when left out. */
  readonly byteOrderMark?: 'refuse' | 'skip';
  /** The migrations that bring older versions up to date; the format's own when left out. */
  readonly migrations?: readonly Migration[];
  /** Rules that the level's folder sets; they apply where the level has none of its own. None when left out. */
  readonly rules?: OwnRules;
}

/** What is wrong with the version of a file, in words; null for one that can be read. */
function versionFinding(read: VersionReading): Finding | null {
  if (read.kind === 'present' || read.kind === 'older') return null;
  const { kind, version } = read;
  const place = { path: ['version'], part: 'value' } as const;
  if (kind === 'newer') {
    const message = `version: this file uses version ${version} of the format; this toolkit reads versions up to ${LEVEL_VERSION}`;
    return { code: 'newer-version', message, hint: 'Update the toolkit (gravity-quest-toolkit).', ...place };
  }
  const expected = `version: expected ${LEVEL_VERSION}, the version of the format, found ${formatValue(version)}`;
  const message = kind === 'unknown' ? `version: the format has no version ${version}` : expected;
  return { code: 'unsupported-version', message, hint: `Write "version": ${LEVEL_VERSION}.`, ...place };
}

/**
 * Reads a level file: encoding, JSON syntax, version, shape and meaning. Throws nothing for any content.
 *
 * @param source - the bytes of the file, or its text
 * @param options - byte order mark, migrations and rules of the folder
 * @returns the level, or every problem found, each with its place
 *
 * @example
 * ```ts
 * import { readFileSync } from 'node:fs';
 * import { readLevel } from 'gravity-quest-toolkit/schema';
 *
 * const reading = readLevel(readFileSync('levels/01-first-pull.level.json'));
 * if (reading.ok) console.log(reading.level.asteroids.length);
 * else for (const { line, column, message } of reading.problems) console.log(`${line}:${column} ${message}`);
 * ```
 */
export function readLevel(source: Uint8Array | string, options: ReadLevelOptions = {}): LevelReading {
  const json = readJson(source, options.byteOrderMark ?? 'refuse');
  if (!json.ok) return json;
  const { text, locator } = json;
  const migrations = options.migrations ?? MIGRATIONS;

  const version = readVersion(json.value, migrations);
  const unreadable = versionFinding(version);
  if (unreadable !== null) return { ok: false, problems: toProblems([unreadable], locator), text };
  const migratedFrom = version.kind === 'older' ? version.from : null;
  const value = migratedFrom === null ? json.value : migrate(json.value as JsonObject, migratedFrom, LEVEL_VERSION, migrations);

  const findings = [...json.findings, ...checkShape(value), ...checkMeaning(value)];
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, locator), text };

  const file = value as LevelFile;
  const locate = (pointer: string) => locator.placeAt(locator.offsetOf(pointer, 'value'));
  return { ok: true, level: resolveLevel(file, options.rules), document: { text, file, migratedFrom, locate } };
}

/**
 * Reads what is in a level file, for what writes the file anew or shows its content: a byte order mark, which is no part of that,
 * is skipped. Whatever judges a file calls {@link readLevel} without options of its own, so that all judge alike: with a mark, a
 * file is no valid level.
 */
export const readContent = (source: Uint8Array | string): LevelReading => readLevel(source, { byteOrderMark: 'skip' });
