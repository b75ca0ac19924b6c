import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { isHunt } from './property-settings.ts';

/** The files of the deep set alone. Every other file that needs no browser belongs to the quick set. */
export const DEEP_ONLY = 'tests/**/*.deep.test.ts';

const IMPORTED = /^(?:import|export|\}).* from '(\.{1,2}\/[^']+\.ts)'/gm;

/** What a file imports whose properties have more runs in the deep set. */
const HAS_RUNS = /^(?:import|\}).* from '(?:fast-check|(?:\.{1,2}\/)+property-settings\.ts)'/m;

const FROM_DEPTH = /import \{([^}]*)\} from '(?:\.{1,2}\/)+depth\.ts'/;

/** What a file takes from depth.ts so that the deep set has more cases of it: only a hunt has more where it asks for one. */
const HAS_CASES = isHunt(process.env)
  ? /\b(?:isDeep|itDeep|describeDeep|someOf|expectDeep|isHunt)\b/
  : /\b(?:isDeep|itDeep|describeDeep|someOf|expectDeep)\b/;

/**
 * The files of the deep set, relative to the project: those that are called so, and those of the quick set that try more cases
 * here, since they have properties or ask `depth.ts`, themselves or by what they import from `tests/`.
 * @param project - the folder of the project
 */
export function deepFiles(project: string): string[] {
  const tests = join(project, 'tests');
  const counts = (path: string, seen: Set<string>): boolean => {
    if (seen.has(path) || !path.startsWith(tests) || path === join(tests, 'depth.ts')) return false;
    seen.add(path);
    const text = readFileSync(path, 'utf8');
    if (HAS_RUNS.test(text) || HAS_CASES.test(FROM_DEPTH.exec(text)?.[1] ?? '')) return true;
    return [...text.matchAll(IMPORTED)].some(([, other]) => counts(resolve(dirname(path), other), seen));
  };
  return readdirSync(tests, { recursive: true, encoding: 'utf8' })
    .filter((path) => path.endsWith('.test.ts') && !path.startsWith('e2e'))
    .filter((path) => path.endsWith('.deep.test.ts') || counts(join(tests, path), new Set()))
    .map((path) => `tests/${path}`);
}
