import { quote } from './format-value.ts';
import { OBJECT_LISTS } from './kinds.ts';
import { entryName, toWords } from './names.ts';
import { type Finding, MAX_FINDINGS } from './problem.ts';

const listOf = (value: unknown): readonly unknown[] => (Array.isArray(value) ? value : []);

const keyOf = (value: unknown, key: string): unknown =>
  typeof value === 'object' && value !== null && Object.hasOwn(value, key) ? (value as Record<string, unknown>)[key] : undefined;

function checkIds(level: unknown, into: Finding[]): void {
  const first = new Map<string, string>();
  for (const list of OBJECT_LISTS) {
    const entries = listOf(keyOf(level, list));
    for (let i = 0; i < entries.length && into.length < MAX_FINDINGS; i++) {
      const id = keyOf(entries[i], 'id');
      if (typeof id !== 'string') continue;
      const owner = first.get(id);
      if (owner === undefined) {
        first.set(id, entryName(list, i));
        continue;
      }
      const path = [list, i, 'id'];
      const message = `${toWords(path)}: the id ${quote(id)} already belongs to ${owner}`;
      into.push({ code: 'duplicate-id', message, hint: 'Remove it here: gq fmt writes a new one.', path, part: 'value' });
    }
  }
}

function checkHold(hold: unknown, run: number, index: number, level: unknown, into: Finding[]): void {
  if (!Array.isArray(hold) || hold.length !== 2) return;
  const [press, release] = hold as unknown[];
  if (typeof press !== 'number' || typeof release !== 'number' || release > press) return;
  const path = ['runs', run, 'holds', index];
  const problem = release === press ? 'never holds the gun' : 'is reversed';
  const hint = release === press ? 'Remove it, or release later.' : `Write [${release}, ${press}].`;
  const message = `${toWords(path, level)}: [${press}, ${release}] ${problem}: the release must come after the press`;
  into.push({ code: 'reversed-hold', message, hint, path, part: 'value' });
}

function checkRuns(level: unknown, into: Finding[]): void {
  const first = new Map<string, number>();
  const runs = listOf(keyOf(level, 'runs'));
  for (let r = 0; r < runs.length && into.length < MAX_FINDINGS; r++) {
    const name = keyOf(runs[r], 'name');
    const owner = typeof name === 'string' && name !== '' ? first.get(name) : undefined;
    if (typeof name === 'string' && owner === undefined) {
      first.set(name, r);
    } else if (typeof name === 'string' && owner !== undefined) {
      const path = ['runs', r, 'name'];
      const message = `${toWords(path)}: the name ${quote(name)} already belongs to run ${owner + 1}`;
      into.push({ code: 'duplicate-run-name', message, hint: 'Rename one of the two.', path, part: 'value' });
    }
    const holds = listOf(keyOf(runs[r], 'holds'));
    for (let h = 0; h < holds.length && into.length < MAX_FINDINGS; h++) checkHold(holds[h], r, h, level, into);
  }
}

/**
 * Checks what the shape alone does not say: ids and run names are unique, and every hold ends after it begins. Accepts any JSON
 * value and skips what has the wrong shape.
 */
export function checkMeaning(level: unknown): Finding[] {
  const findings: Finding[] = [];
  checkIds(level, findings);
  checkRuns(level, findings);
  return findings;
}
