import * as z from 'zod';
import {
  closestName,
  type Finding,
  formatValue,
  MAX_FINDINGS,
  type Path,
  type Problem,
  quote,
  RULE_NAMES,
  toPointer,
} from '../basics/index.ts';
import { readJson, toProblems } from '../json/index.ts';
import { LOCK_VERSION, type Lock, lockEntrySchema, lockSchema } from './lock.ts';

/** The outcome of {@link readLock}: with `ok` true the lock, otherwise the problems. */
export type LockReading =
  | {
      /** The file is a valid lock. */
      readonly ok: true;
      /** What was agreed on. */
      readonly lock: Lock;
      /**
       * Finds the entry of a level.
       *
       * @param path - the path of the level as the lock has it
       * @returns the line of the entry, from 1
       */
      lineOf(path: string): number;
    }
  | {
      /** The file is not a valid lock. */
      readonly ok: false;
      /** What is wrong with it, in the order of the text; at least one. */
      readonly problems: Problem[];
      /** The text without a byte order mark; '' if the file is too large or not a text. */
      readonly text: string;
    };

/**
 * Reads a lock file: encoding, JSON syntax, version and shape. Throws nothing for any content.
 *
 * @param source - the bytes of the file, or its text
 * @returns the lock, or every problem found, each with its place
 */
export function readLock(source: Uint8Array | string): LockReading {
  const json = readJson(source, 'skip', 'lock');
  if (!json.ok) return json;
  const findings = [...json.findings, ...checkLock(json.value)];
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, json.locator), text: json.text };
  const { locator } = json;
  const lineOf = (path: string): number => locator.placeAt(locator.offsetOf(toPointer(['levels', path]), 'key')).line;
  return { ok: true, lock: json.value as Lock, lineOf };
}

const EXPECTED: Readonly<Record<string, string>> = {
  number: 'a number',
  int: 'a whole number',
  string: 'a text in double quotes',
  object: 'an object in { }',
  record: 'an object in { }',
};

/** What a path of a lock leads to: `levels/a.level.json: rules: pull`. */
const inWords = (path: Path): string =>
  path
    .filter((step, i) => i > 0 || step !== 'levels' || path.length === 1)
    .map((step) => (String(step).length > 40 ? quote(String(step)) : String(step)))
    .join(': ');

const named = (path: Path, message: string): string => (path.length === 0 ? message : `${inWords(path)}: ${message}`);

function keysAt(path: Path): readonly string[] {
  if (path.length === 0) return Object.keys(lockSchema.shape);
  return path.length === 2 ? Object.keys(lockEntrySchema.shape) : RULE_NAMES;
}

function unknownKey(path: Path, key: string): Finding {
  const known = keysAt(path);
  const meant = closestName(key, known);
  const message = named(path, `unknown key ${quote(key)}${meant === null ? '' : `: did you mean "${meant}"?`}`);
  const hint = meant === null ? `Known keys are ${known.join(', ')}.` : `Write "${meant}".`;
  return { code: 'unknown-key', message, hint, path: [...path, key], part: 'key' };
}

function valueAt(value: unknown, path: Path): unknown {
  return path.reduce<unknown>(
    (at, step) =>
      typeof at === 'object' && at !== null && Object.hasOwn(at, step) ? (at as Record<string, unknown>)[step] : undefined,
    value,
  );
}

function wrongValue(issue: z.core.$ZodIssue, path: Path, value: unknown): Finding {
  const about = (code: Finding['code'], message: string, hint: string): Finding => ({
    code,
    message: named(path, message),
    hint,
    path,
    part: 'value',
  });
  if (value === undefined) {
    const key = String(path.at(-1));
    const object = path.slice(0, -1);
    const missing = { message: named(object, `the key "${key}" is missing`), path: object, part: 'value' } as const;
    if (key === 'version')
      return { code: 'missing-version', hint: `Add "version": ${LOCK_VERSION} as the first key.`, ...missing };
    return { code: 'missing-key', hint: `Add "${key}", or agree anew with gq check --update-lock.`, ...missing };
  }
  if (path.length === 1 && path[0] === 'version') {
    if (typeof value === 'number' && value > LOCK_VERSION) {
      const message = `this lock has version ${value} of the format; this toolkit reads version ${LOCK_VERSION}`;
      return about('newer-version', message, 'Update the toolkit (gravity-quest-toolkit).');
    }
    return about(
      'unsupported-version',
      `expected ${LOCK_VERSION}, found ${formatValue(value)}`,
      `Write "version": ${LOCK_VERSION}.`,
    );
  }
  switch (issue.code) {
    case 'invalid_type':
      if (issue.expected === 'int' && typeof value === 'number')
        return about('not-whole', `expected a whole number, found ${value}`, `Write ${Math.round(value)}.`);
      return about(
        'wrong-type',
        `expected ${EXPECTED[issue.expected] ?? issue.expected}, found ${formatValue(value)}`,
        `Write ${EXPECTED[issue.expected] ?? issue.expected}.`,
      );
    case 'invalid_value': {
      const values = issue.values.map((one) => JSON.stringify(one)).join(', ');
      const meant = typeof value === 'string' ? closestName(value, issue.values.map(String)) : null;
      return about(
        'wrong-type',
        `expected one of ${values}, found ${formatValue(value)}`,
        `Write ${meant === null ? 'one of these' : `"${meant}"`}.`,
      );
    }
    case 'too_big':
    case 'too_small': {
      const most = issue.code === 'too_big';
      const limit = `at ${most ? 'most' : 'least'} ${most ? issue.maximum : issue.minimum}`;
      if (typeof value !== 'string')
        return about('out-of-limits', `expected a number of ${limit}, found ${value}`, `Write a number of ${limit}.`);
      return about(
        most ? 'text-too-long' : 'empty-text',
        `expected a text of ${limit} characters, found ${value.length}`,
        'Correct it.',
      );
    }
    default:
      return about('wrong-type', issue.message, 'Correct it, or agree anew with gq check --update-lock.');
  }
}

function checkLock(value: unknown): Finding[] {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    const message = `expected a lock (an object in { }), found ${formatValue(value)}`;
    const hint = `Write { "version": ${LOCK_VERSION}, "levels": {} }, or agree with gq check --update-lock.`;
    return [{ code: 'wrong-type', message, hint, path: [], part: 'value' }];
  }
  const parsed = z.safeParse(lockSchema, value);
  if (parsed.success) return [];
  const findings: Finding[] = [];
  const seen = new Set<string>();
  for (const issue of parsed.error.issues) {
    const path = issue.path as Path;
    if (issue.code === 'unrecognized_keys') findings.push(...issue.keys.map((key) => unknownKey(path, key)));
    else if (!seen.has(toPointer(path))) findings.push(wrongValue(issue, path, valueAt(value, path)));
    seen.add(toPointer(path));
    if (findings.length >= MAX_FINDINGS) return findings.slice(0, MAX_FINDINGS);
  }
  return findings;
}
