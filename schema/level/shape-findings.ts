import {
  ALLOWABLE_CODES,
  adjustmentOf,
  allCodes,
  closestName,
  type Finding,
  formatValue,
  KINDS,
  LEVEL_VERSION,
  MAX_FINDINGS,
  OBJECT_KINDS,
  type Path,
  quote,
  SINGLE_KINDS,
  toPointer,
  toWords,
} from '../basics/index.ts';
import type { Fault } from './faults.ts';

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

export const found = (path: Path, code: Finding['code'], message: string, hint: string): Finding => ({
  code,
  message,
  hint,
  path,
  part: 'value',
});

/** A finding about a value, which its message names first. @param level what the path leads into */
export const named = (finding: Finding, level: unknown): Finding =>
  finding.path.length === 0 ? finding : { ...finding, message: `${toWords(finding.path, level)}: ${finding.message}` };

/** @param known the keys that there are */
export function unknownKey(
  path: Path,
  key: string,
  level: unknown,
  known: readonly string[],
): { finding: Finding; meant: string | null } {
  if (path[0] === 'allow') {
    const meant = adjustmentOf(key) === null ? closestName(key, allCodes()) : null;
    return { finding: codeFinding([...path, key], meant, ALLOWABLE_CODES), meant };
  }
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

/**
 * A code that there is not, or whose problems can't be changed here: `meant` is the code that was meant, if any.
 * @param path the last step is the code
 * @param possible the codes that can stand here
 */
export function codeFinding(path: Path, meant: string | null, possible: readonly string[]): Finding {
  const code = String(path[path.length - 1]);
  const isAllow = path[0] === 'allow';
  if (adjustmentOf(code) === null) {
    const guess = meant === null ? '' : `: did you mean "${meant}"?`;
    const canBe = isAllow ? 'allowed' : 'changed';
    let hint = `gq explain lists all codes. Those that can be ${canBe} here are ${possible.join(', ')}.`;
    if (meant !== null && possible.includes(meant)) hint = `Write "${meant}"; gq explain lists all codes.`;
    else if (meant !== null) hint = `Remove it: ${meant} can't be ${canBe}.`;
    const message = `${path[0]}: no problem has the code ${quote(code)}${guess}`;
    return { code: 'unknown-code', message, hint, path, part: 'key' };
  }
  const isAboutLevels = adjustmentOf(code)?.severity !== 'fixed';
  const why = isAboutLevels ? 'it is not about the level alone' : 'it is always an error';
  const todo = isAboutLevels ? 'Set its severity in gq.config.json instead.' : ALWAYS_AN_ERROR;
  const message = `${path[0]}: ${code} can't be ${isAllow ? 'allowed in a level' : 'given another severity'}: ${why}`;
  return { code: 'fixed-severity', message, hint: todo, path, part: 'key' };
}

const ALWAYS_AN_ERROR =
  'Remove it here. A level with this problem is not known to be completable: fix it, or leave its file out with "ignore" in gq.config.json.';

/** The name that was meant: a close one, or the only one that begins so, as in `warn`. */
function meantBy(value: string, known: readonly string[]): string | null {
  const longer = value.length < 3 ? [] : known.filter((name) => name.startsWith(value.toLowerCase()));
  return longer.length === 1 ? longer[0] : closestName(value, known);
}

/** A text that is none of those that are known. */
export function unknownValue(path: Path, known: readonly string[], value: unknown): Finding {
  const words = `${known
    .slice(0, -1)
    .map((one) => `"${one}"`)
    .join(', ')} or "${known[known.length - 1]}"`;
  const meant = typeof value === 'string' ? meantBy(value, known) : null;
  const guess = meant === null ? '' : `: did you mean "${meant}"?`;
  const message = `${toWords(path)}: expected ${words}, found ${formatValue(value)}${guess}`;
  return found(path, 'unknown-value', message, meant === null ? `Write ${words}.` : `Write "${meant}".`);
}

/** @param name begins the message, where nothing else names the value */
export function wrongType(path: Path, expected: string, value: unknown, name = ''): Finding {
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
  return found(path, 'wrong-type', `${name}expected ${words}, found ${formatValue(value)}`, hint);
}

/** What is expected where a text is empty; a name elsewhere. */
const TEXTS: Readonly<Record<string, string>> = {
  allow: 'a reason',
  levels: 'a path',
  ignore: 'a pattern',
  lock: 'the path of a file',
  cache: 'the path of a directory',
};

function emptyText(path: Path, value: string): Finding {
  const words = TEXTS[path[0]] ?? 'a name';
  const what = value === '' ? 'an empty text' : 'only blanks';
  return found(path, 'empty-text', `expected ${words}, found ${what}`, `Write ${words}.`);
}

/** A list in a configuration that is too long or too short. */
function wrongLength(path: Path, isBig: boolean, limit: number, count: number): Finding {
  if (!isBig)
    return found(path, 'empty-list', 'expected at least one entry, found an empty list', 'Add an entry, or remove the key.');
  return found(path, 'too-many', `expected at most ${limit} entries, found ${count}`, 'Remove entries.');
}

function outOfLimits({ what, path, value, shape }: Fault): Finding {
  const isBig = what === 'too-big';
  let limit = Number(isBig ? shape.most : shape.least);
  if (typeof value === 'string') {
    if (!isBig || (path[0] === 'allow' && !/\S/.test(value))) return emptyText(path, value);
    const message = `expected at most ${limit} characters, found ${value.length}`;
    return found(path, 'text-too-long', message, 'Shorten it.');
  }
  if (Array.isArray(value)) {
    return path.length === 1 ? wrongLength(path, isBig, limit, value.length) : wrongType(path, 'tuple', value);
  }
  // a number that is whole only because it is so large
  if (shape.type === 'integer' && !Number.isSafeInteger(value)) limit = Math.sign(Number(value)) * Number.MAX_SAFE_INTEGER;
  const words = isBig ? `at most ${limit}` : `at least ${limit}`;
  return found(path, 'out-of-limits', `expected a number of ${words}, found ${String(value)}`, `Write a number of ${words}.`);
}

/** What a value must be, as a key of the table of types. */
function typeOf({ shape: { type, least }, value }: Fault): string {
  if (type === 'integer') return typeof value === 'number' ? 'int' : 'number';
  return type === 'array' && least !== undefined ? 'tuple' : String(type);
}

function toFinding(fault: Fault): Finding {
  const { what, path, value } = fault;
  if (what === 'wrong-type') return wrongType(path, typeOf(fault), value);
  if (what === 'too-big' || what === 'too-small') return outOfLimits(fault);
  if (what === 'wrong-form' && path[0] === 'allow') return emptyText(path, String(value));
  if (what === 'wrong-form') {
    const message = `expected 2 to 16 of the characters a-z and 0-9, found ${formatValue(value)}`;
    return found(path, 'bad-id', message, 'Correct it, or remove it: gq fmt writes a new one.');
  }
  const message = `expected ${LEVEL_VERSION}, found ${formatValue(value)}`;
  return found(path, 'unsupported-version', message, `Write "version": ${LEVEL_VERSION}.`);
}

/**
 * Puts into words what is wrong with the shape of one part of a level or a configuration.
 *
 * @param level - the whole of it, for the names of runs
 */
export function tellFaults(faults: readonly Fault[], level: unknown, into: Finding[]): void {
  const meant = new Set<string>();
  const [unknown, others] = [true, false].map((is) => faults.filter(({ what }) => (what === 'unknown-key') === is));
  for (const { path, shape } of unknown) {
    if (into.length >= MAX_FINDINGS) return;
    const object = path.slice(0, -1);
    const unknownOne = unknownKey(object, String(path[path.length - 1]), level, Object.keys(shape.keys ?? {}));
    into.push(unknownOne.finding);
    if (unknownOne.meant !== null) meant.add(toPointer([...object, unknownOne.meant]));
  }
  for (const fault of others) {
    if (into.length >= MAX_FINDINGS) return;
    const { what, path } = fault;
    if (what !== 'missing-key') into.push(named(toFinding(fault), level));
    // a misspelt key is one problem, not two
    else if (!meant.has(toPointer(path))) into.push(missingKey(path, level));
  }
}
