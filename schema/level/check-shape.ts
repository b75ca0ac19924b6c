import { type Finding, MAX_FINDINGS, OBJECT_LISTS, type Path, quote, toWords } from '../basics/index.ts';
import { isObject } from '../json/index.ts';
import { type Contradiction, contradictionsIn, type Fault, findFaults, fits } from './faults.ts';
import { LEVEL_SHAPE, type Shape } from './shape.ts';
import { found, named, tellFaults, wrongType } from './shape-findings.ts';

const { keys } = LEVEL_SHAPE;
const RUN = keys.runs.each;

/** The lists of a level, by the order in which they are checked. */
const LISTS = ['conflicts', ...OBJECT_LISTS] as const;

/** The lists of a run. */
const LISTS_OF_RUN = ['holds', 'notes'] as const;

/** Checks one part of a level. @param part has empty lists in place of those that are checked entry by entry */
function checkPart(part: unknown, shape: Shape, path: Path, level: unknown, into: Finding[]): void {
  const faults: Fault[] = [];
  findFaults(part, shape, path, (fault) => {
    // only keys can be so many, and those that are unknown come first
    if (faults.length <= MAX_FINDINGS) faults.push(fault);
  });
  if (faults.length > 0) tellFaults(faults, level, into);
}

/** Checks a list as a whole. @returns whether its entries are to be checked, too */
function checkLength(list: readonly unknown[], { most = 0 }: Shape, path: Path, level: unknown, into: Finding[]): boolean {
  if (list.length <= most) return true;
  const message = `expected at most ${most} entries, found ${list.length}`;
  into.push(named(found(path, 'too-many', message, 'Remove entries, or split the level.'), level));
  return false;
}

function checkEntries(list: unknown, shape: Shape, path: Path, level: unknown, into: Finding[]): void {
  if (!Array.isArray(list) || !checkLength(list, shape, path, level, into)) return;
  for (let i = 0; i < list.length && into.length < MAX_FINDINGS; i++) {
    checkPart(list[i], shape.each ?? {}, [...path, i], level, into);
  }
}

/** An object with empty lists in place of some of its lists; another value as it is. */
function hollow(value: unknown, lists: readonly string[]): unknown {
  if (!isObject(value)) return value;
  const emptied = lists.filter((key) => Object.hasOwn(value, key) && Array.isArray(value[key])).map((key) => [key, []]);
  return { ...value, ...Object.fromEntries(emptied) };
}

function checkRuns(runs: readonly unknown[], level: unknown, into: Finding[]): void {
  for (let r = 0; r < runs.length && into.length < MAX_FINDINGS; r++) {
    const run = runs[r];
    checkPart(hollow(run, LISTS_OF_RUN), RUN, ['runs', r], level, into);
    if (!isObject(run)) continue;
    for (const key of LISTS_OF_RUN) checkEntries(run[key], RUN.keys[key], ['runs', r, key], level, into);
  }
}

/**
 * Checks the shape of a level: keys, types, limits. It checks part by part, so that a file with millions of wrong entries costs
 * no more than one with `MAX_FINDINGS`.
 *
 * @param value - any JSON value
 */
export function checkShape(value: unknown): Finding[] {
  if (fits(value, LEVEL_SHAPE)) return [];
  const findings: Finding[] = [];
  if (!isObject(value)) return [wrongType([], 'object', value)];
  checkPart(hollow(value, [...LISTS, 'runs']), LEVEL_SHAPE, [], value, findings);
  for (const list of LISTS) checkEntries(value[list], (keys as { readonly [key: string]: Shape })[list], [list], value, findings);
  if (Array.isArray(value.runs) && checkLength(value.runs, keys.runs, ['runs'], value, findings))
    checkRuns(value.runs, value, findings);
  return findings;
}

/** What is wrong with a level beyond its shape, in words. Accepts any JSON value. */
export function checkMeaning(level: unknown): Finding[] {
  const findings: Finding[] = [];
  for (const contradiction of contradictionsIn(level)) {
    if (findings.length === MAX_FINDINGS) break;
    findings.push(toFinding(contradiction, level));
  }
  return findings;
}

function toFinding(found: Contradiction, level: unknown): Finding {
  const { path } = found;
  if (found.what === 'reversed') {
    const { press, release } = found;
    const problem = release === press ? 'never holds the gun' : 'is reversed';
    const hint = release === press ? 'Remove it, or release later.' : `Write [${release}, ${press}].`;
    const message = `${toWords(path, level)}: [${press}, ${release}] ${problem}: the release must come after the press`;
    return { code: 'reversed-hold', message, hint, path, part: 'value' };
  }
  const { name, first } = found;
  const isRun = path[0] === 'runs';
  const message = `${toWords(path)}: the ${isRun ? 'name' : 'id'} ${quote(name)} already belongs to ${toWords(first)}`;
  const hint = isRun ? 'Rename one of the two.' : 'Remove it here: gq fmt writes a new one.';
  return { code: isRun ? 'duplicate-run-name' : 'duplicate-id', message, hint, path, part: 'value' };
}
