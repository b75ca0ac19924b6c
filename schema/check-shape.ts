import * as z from 'zod';
import { closestName } from './closest-name.ts';
import { formatValue, quote } from './format-value.ts';
import { KINDS, LISTED_KINDS, OBJECT_KINDS, OBJECT_LISTS, SINGLE_KINDS } from './kinds.ts';
import { LEVEL_VERSION, levelSchema, OBJECT_SCHEMAS } from './level.ts';
import { LIMITS } from './limits.ts';
import { toWords } from './names.ts';
import { type Finding, MAX_FINDINGS, type Path, toPointer } from './problem.ts';
import { rulesSchema } from './rules.ts';

const { shape } = levelSchema;
const runSchema = shape.runs.unwrap().element;
const conflictSchema = shape.conflicts.unwrap().element;

/** Names from the original game, which people who know it may write. */
const NAMES_OF_THE_ORIGINAL: Readonly<Record<string, string>> = {
  maxDistance: 'range',
  ...Object.fromEntries(
    OBJECT_KINDS.flatMap((kind) => {
      const { list, original } = KINDS[kind];
      if (original === null) return [];
      const fields = Object.entries(original.fields ?? {}).map(([name, there]) => [there, name]);
      return [[original.key, list ?? kind], ...fields];
    }),
  ),
};

const EXPECTED: Readonly<Record<string, string>> = {
  number: 'a number',
  int: 'a whole number',
  string: 'a text in double quotes',
  boolean: 'true or false',
  array: 'a list in [ ]',
  tuple: 'a pair [press, release]',
  object: 'an object in { }',
};

type Parts = { readonly [list: string]: z.core.$ZodType };

interface Compiled {
  readonly root: z.core.$ZodType;
  readonly elements: Parts;
  readonly run: z.core.$ZodType;
  readonly hold: z.core.$ZodType;
  readonly conflict: z.core.$ZodType;
}

let compiled: Compiled | null = null;

/**
 * The schemas of a level's parts. zod compiles them on first use: that takes a few ms once, and makes them five times faster.
 */
function parts(): Compiled {
  compiled ??= {
    root: z.compile(levelSchema),
    elements: Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, z.compile(OBJECT_SCHEMAS[kind])])),
    run: z.compile(runSchema),
    hold: z.compile(runSchema.shape.holds.element),
    conflict: z.compile(conflictSchema),
  };
  return compiled;
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function valueAt(value: unknown, path: Path): unknown {
  let current = value;
  for (const step of path) {
    if (typeof current !== 'object' || current === null || !Object.hasOwn(current, step)) return undefined;
    current = (current as Record<string | number, unknown>)[step];
  }
  return current;
}

/** The keys that the object at a path may have. */
function keysAt(path: Path): string[] {
  let schema: z.core.$ZodType = levelSchema;
  const unwrap = () => {
    if (schema instanceof z.ZodOptional) schema = schema.unwrap();
  };
  for (const step of path) {
    if (schema instanceof z.ZodArray) schema = schema.element;
    else if (schema instanceof z.ZodObject) schema = schema.shape[step];
    unwrap();
  }
  return schema instanceof z.ZodObject ? Object.keys(schema.shape) : [];
}

const found = (path: Path, code: Finding['code'], message: string, hint: string): Finding => ({
  code,
  message,
  hint,
  path,
  part: 'value',
});

/** A finding about a value, which its message names first. @param level what the path leads into */
const named = (finding: Finding, level: unknown): Finding =>
  finding.path.length === 0 ? finding : { ...finding, message: `${toWords(finding.path, level)}: ${finding.message}` };

function unknownKey(path: Path, key: string, level: unknown): { finding: Finding; meant: string | null } {
  const known = keysAt(path);
  const original = Object.hasOwn(NAMES_OF_THE_ORIGINAL, key) ? NAMES_OF_THE_ORIGINAL[key] : '';
  const isOriginal = known.includes(original);
  const meant = isOriginal ? original : closestName(key, known);
  const where = path.length === 0 ? '' : ` in ${toWords(path, level)}`;
  const guess = meant === null ? '' : `: did you mean "${meant}"?`;
  let hint = `Known keys are ${known.join(', ')}. Keys of your own begin with x-.`;
  if (isOriginal) hint = `Write "${meant}"; gq import reads files of the original game.`;
  else if (meant !== null) hint = `Write "${meant}", or begin a key of your own with x-.`;
  const message = `unknown key ${quote(key)}${where}${guess}`;
  return { finding: { code: 'unknown-key', message, hint, path: [...path, key], part: 'key' }, meant };
}

function missingKey(path: Path, level: unknown): Finding {
  const object = path.slice(0, -1);
  const key = String(path[path.length - 1]);
  if (object.length === 0 && key === 'version') {
    const hint = `Add "version": ${LEVEL_VERSION} as the first key.`;
    return { code: 'missing-version', message: 'the key "version" is missing', hint, path: object, part: 'value' };
  }
  const where = object.length === 0 ? '' : ` in ${toWords(object, level)}`;
  return {
    code: 'missing-key',
    message: `the key "${key}" is missing${where}`,
    hint: `Add "${key}".`,
    path: object,
    part: 'value',
  };
}

function wrongType(path: Path, expected: string, value: unknown): Finding {
  const single = path.length === 1 ? SINGLE_KINDS.find((kind) => kind === path[0]) : undefined;
  if (Array.isArray(value) && single !== undefined) {
    const hint = `Keep one of them, without the list around it: "${single}": { "x": 0, "y": 0 }.`;
    return found(path, 'one-per-level', `a level has exactly one ${KINDS[single].one}, found ${formatValue(value)}`, hint);
  }
  if (path.length === 0) {
    const hint = 'A level is one object in { }; gq import reads the list of levels of the original game.';
    return found(path, 'wrong-type', `expected a level (an object in { }), found ${formatValue(value)}`, hint);
  }
  if (expected === 'int' && typeof value === 'number') {
    return found(path, 'not-whole', `expected a whole number, found ${value}`, `Write ${Math.round(value)}.`);
  }
  const words = EXPECTED[expected] ?? expected;
  let hint = `Write ${words}.`;
  const isNumber = expected === 'number' || expected === 'int';
  if (isNumber && typeof value === 'string' && /^-?\d+(\.\d+)?$/.test(value)) hint = 'Remove the quotes.';
  else if (expected === 'boolean' && (value === 'true' || value === 'false')) hint = 'Remove the quotes.';
  return found(path, 'wrong-type', `expected ${words}, found ${formatValue(value)}`, hint);
}

function outOfLimits(path: Path, issue: z.core.$ZodIssueTooBig | z.core.$ZodIssueTooSmall, value: unknown): Finding {
  const isBig = issue.code === 'too_big';
  const limit = Number(isBig ? issue.maximum : issue.minimum);
  if (typeof value === 'string') {
    if (!isBig) return found(path, 'empty-text', 'expected a name, found an empty text', 'Write a name.');
    const message = `expected at most ${limit} characters, found ${value.length}`;
    return found(path, 'text-too-long', message, 'Shorten it.');
  }
  if (Array.isArray(value)) return wrongType(path, 'tuple', value);
  const words = isBig ? `at most ${limit}` : `at least ${limit}`;
  return found(path, 'out-of-limits', `expected a number of ${words}, found ${String(value)}`, `Write a number of ${words}.`);
}

function toFinding(issue: z.core.$ZodIssue, path: Path, value: unknown): Finding {
  if (issue.code === 'invalid_type') return wrongType(path, issue.expected, value);
  if (issue.code === 'too_big' || issue.code === 'too_small') return outOfLimits(path, issue, value);
  if (issue.code === 'invalid_format') {
    const message = `expected 2 to 16 of the characters a-z and 0-9, found ${formatValue(value)}`;
    return found(path, 'bad-id', message, 'Correct it, or remove it: gq fmt writes a new one.');
  }
  const message = `expected ${LEVEL_VERSION}, found ${formatValue(value)}`;
  return found(path, 'unsupported-version', message, `Write "version": ${LEVEL_VERSION}.`);
}

/**
 * Checks one part of a level and puts what zod finds into words.
 * @param level the whole level, for the names of its runs
 */
function checkPart(schema: z.core.$ZodType, part: unknown, base: Path, level: unknown, into: Finding[]): void {
  const parsed = z.safeParse(schema, part);
  if (parsed.success) return;
  const meant = new Set<string>();
  const seen = new Set<string>();
  for (const issue of parsed.error.issues) {
    if (issue.code !== 'unrecognized_keys') continue;
    const path = [...base, ...(issue.path as Path)];
    for (const key of issue.keys) {
      if (into.length >= MAX_FINDINGS) return;
      const unknown = unknownKey(path, key, level);
      into.push(unknown.finding);
      if (unknown.meant !== null) meant.add(toPointer([...path, unknown.meant]));
    }
  }
  for (const issue of parsed.error.issues) {
    if (issue.code === 'unrecognized_keys') continue;
    if (into.length >= MAX_FINDINGS) return;
    const inner = issue.path as Path;
    const path = [...base, ...inner];
    const pointer = toPointer(path);
    // one problem per value is enough: the first is the most basic one
    if (seen.has(pointer)) continue;
    seen.add(pointer);
    const value = valueAt(part, inner);
    if (value !== undefined) into.push(named(toFinding(issue, path, value), level));
    // a misspelt key is one problem, not two
    else if (!meant.has(pointer)) into.push(missingKey(path, level));
  }
}

function checkLength(list: readonly unknown[], most: number, path: Path, level: unknown, into: Finding[]): boolean {
  if (list.length <= most) return true;
  const message = `expected at most ${most} entries, found ${list.length}`;
  into.push(named(found(path, 'too-many', message, 'Remove entries, or split the level.'), level));
  return false;
}

function checkRuns(runs: readonly unknown[], level: unknown, into: Finding[]): void {
  for (let r = 0; r < runs.length && into.length < MAX_FINDINGS; r++) {
    const run = runs[r];
    const holds = isObject(run) && Array.isArray(run.holds) ? run.holds : null;
    checkPart(parts().run, holds === null ? run : { ...(run as object), holds: [] }, ['runs', r], level, into);
    if (holds === null || !checkLength(holds, LIMITS.holds, ['runs', r, 'holds'], level, into)) continue;
    for (let h = 0; h < holds.length && into.length < MAX_FINDINGS; h++) {
      checkPart(parts().hold, holds[h], ['runs', r, 'holds', h], level, into);
    }
  }
}

/**
 * Checks a JSON value without x- keys against `levelSchema`: keys, types, limits. It checks part by part, so that a file with
 * millions of wrong entries costs no more than one with `MAX_FINDINGS`.
 */
export function checkShape(value: unknown): Finding[] {
  const findings: Finding[] = [];
  if (!isObject(value)) return [wrongType([], 'object', value)];
  const hollow = { ...value };
  for (const list of [...OBJECT_LISTS, 'runs', 'conflicts']) if (Array.isArray(hollow[list])) hollow[list] = [];
  checkPart(parts().root, hollow, [], value, findings);
  const checkEach = (list: string, schema: z.core.$ZodType, most: number) => {
    const entries = value[list];
    if (!Array.isArray(entries) || !checkLength(entries, most, [list], value, findings)) return;
    for (let i = 0; i < entries.length && findings.length < MAX_FINDINGS; i++) {
      checkPart(schema, entries[i], [list, i], value, findings);
    }
  };
  checkEach('conflicts', parts().conflict, LIMITS.conflicts);
  for (const list of OBJECT_LISTS) checkEach(list, parts().elements[list], LIMITS.objects);
  if (Array.isArray(value.runs) && checkLength(value.runs, LIMITS.runs, ['runs'], value, findings))
    checkRuns(value.runs, value, findings);
  return findings;
}

/**
 * Checks the key `rules` of a folder's configuration, a JSON value without x- keys, like that of a level. Other keys are
 * ignored.
 */
export function checkFolderRules(value: unknown): Finding[] {
  const findings: Finding[] = [];
  if (!isObject(value)) {
    const message = `expected the configuration of a folder (an object in { }), found ${formatValue(value)}`;
    return [found([], 'wrong-type', message, 'Write { "rules": { } }.')];
  }
  if (value.rules !== undefined) checkPart(rulesSchema, value.rules, ['rules'], value, findings);
  return findings;
}
