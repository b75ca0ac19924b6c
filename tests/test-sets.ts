import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';

/** The files of the deep set alone. Every other file that needs no browser belongs to the quick set. */
export const DEEP_ONLY = 'tests/**/*.deep.test.ts';

const IMPORTED = /^(?:import|export|\}).* from '(\.{1,2}\/[^']+\.ts)'/gm;

/** What a file imports so that the number of its cases depends on the set. */
const COUNTS = /^(?:import|\}).* from '(?:fast-check|(?:\.{1,2}\/)+(?:depth|property-settings)\.ts)'/m;

/**
 * The files of the deep set, relative to the project: those that are called so, and those of the quick set that try more cases
 * here, since they have properties or ask `depth.ts`, themselves or by what they import from `tests/`.
 * @param project - the folder of the project
 */
export function deepFiles(project: string): string[] {
  const tests = join(project, 'tests');
  const counts = (path: string, seen: Set<string>): boolean => {
    if (seen.has(path) || !path.startsWith(tests)) return false;
    seen.add(path);
    const text = readFileSync(path, 'utf8');
    if (COUNTS.test(text)) return true;
    return [...text.matchAll(IMPORTED)].some(([, other]) => counts(resolve(dirname(path), other), seen));
  };
  return readdirSync(tests, { recursive: true, encoding: 'utf8' })
    .filter((path) => path.endsWith('.test.ts') && !path.startsWith('e2e'))
    .filter((path) => path.endsWith('.deep.test.ts') || counts(join(tests, path), new Set()))
    .map((path) => `tests/${path}`);
}
