import { checkMeaning } from './check-meaning.ts';
import { checkShape } from './check-shape.ts';
import { withoutExtensions } from './extensions.ts';
import { formatValue } from './format-value.ts';
import { LEVEL_VERSION, type Level, type LevelFile } from './level.ts';
import { type JsonObject, MIGRATIONS, type Migration, migrate } from './migrate.ts';
import type { Finding, Problem } from './problem.ts';
import { readJson, toProblems } from './read-json.ts';
import { resolveLevel } from './resolve.ts';
import type { OwnRules } from './rules.ts';
import type { TextPlace } from './text-place.ts';

/** A level file that was read. */
export interface LevelDocument {
  /** As it was read, without a byte order mark. */
  readonly text: string;
  /** As written: what is left out is missing, x- keys are kept. Migrated when it was of an older version. */
  readonly file: LevelFile;
  /** The version in the text when it was an older one, else null. */
  readonly migratedFrom: number | null;
  /** Where the value of a JSON pointer stands; where the text has no such value, the nearest one around it. */
  locate(pointer: string): TextPlace;
}

export type LevelReading =
  | { readonly ok: true; readonly level: Level; readonly document: LevelDocument }
  | { readonly ok: false; readonly problems: Problem[]; readonly text: string };

export interface ReadLevelOptions {
  /** What to do about a byte order mark; 'refuse' when left out. */
  readonly byteOrderMark?: 'refuse' | 'skip';
  /** How older versions become the current one; the format's own chain when left out. */
  readonly migrations?: readonly Migration[];
  /** Rules that the folder sets, which hold where the level has none of its own; none when left out. */
  readonly rules?: OwnRules;
}

/** The version a file says, when it is older and the chain reaches from it; a finding when it can't be read; null for the current one. */
function olderVersion(value: unknown, migrations: readonly Migration[]): { from: number } | Finding | null {
  if (typeof value !== 'object' || value === null || Array.isArray(value) || !Object.hasOwn(value, 'version')) return null;
  const { version } = value as JsonObject;
  if (version === LEVEL_VERSION) return null;
  const place = { path: ['version'], part: 'value' } as const;
  if (typeof version !== 'number' || !Number.isInteger(version) || version < 0) {
    const message = `version: expected the version of the format, ${LEVEL_VERSION}, found ${formatValue(version)}`;
    return { code: 'unsupported-version', message, hint: `Write "version": ${LEVEL_VERSION}.`, ...place };
  }
  if (version > LEVEL_VERSION) {
    const message = `version: this file has version ${version} of the format, this toolkit reads up to ${LEVEL_VERSION}`;
    return { code: 'newer-version', message, hint: 'Update the toolkit (gravity-quest-toolkit).', ...place };
  }
  for (let v = version; v < LEVEL_VERSION; v++) {
    if (migrations.some((migration) => migration.from === v)) continue;
    const message = `version: there is no version ${v} of the format`;
    return { code: 'unsupported-version', message, hint: `Write "version": ${LEVEL_VERSION}.`, ...place };
  }
  return { from: version };
}

/**
 * Reads a level file: encoding, syntax, version, shape, meaning. Never throws for any input.
 * @param source the bytes of the file, or its text
 */
export function readLevel(source: Uint8Array | string, options: ReadLevelOptions = {}): LevelReading {
  const json = readJson(source, options.byteOrderMark ?? 'refuse');
  if (!json.ok) return json;
  const { text, locator } = json;
  const migrations = options.migrations ?? MIGRATIONS;

  const older = olderVersion(json.value, migrations);
  if (older !== null && 'code' in older) return { ok: false, problems: toProblems([older], locator), text };
  const migratedFrom = older?.from ?? null;
  const value = migratedFrom === null ? json.value : migrate(json.value as JsonObject, migratedFrom, LEVEL_VERSION, migrations);

  const checked = json.hasExtensions ? withoutExtensions(value) : value;
  const findings = [...json.findings, ...checkShape(checked), ...checkMeaning(checked)];
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, locator), text };

  const file = value as LevelFile;
  const locate = (pointer: string) => locator.placeAt(locator.offsetOf(pointer, 'value'));
  return { ok: true, level: resolveLevel(file, options.rules), document: { text, file, migratedFrom, locate } };
}
