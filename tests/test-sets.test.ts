import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { deepFiles } from './test-sets.ts';

const PROJECT = join(import.meta.dirname, '..');

/** What a file takes from depth.ts only to say in which set a test is. */
const DECLARES = /^(?:it|describe)(?:Deep|Quick)(?: as it)?$/;

const files = deepFiles(PROJECT)
  .filter((path) => !path.endsWith('.deep.test.ts'))
  .map((path) => ({ path, text: readFileSync(join(PROJECT, path), 'utf8') }));

const namesFrom = (text: string, module: RegExp): string[] => {
  const [, names = ''] = new RegExp(`import \\{([^}]*)\\} from '${module.source}'`).exec(text) ?? [];
  return names.split(',').map((name) => name.trim());
};
const fromDepth = (text: string): string[] => namesFrom(text, /(?:\.{1,2}\/)+depth\.ts/).filter((name) => name !== '');

describe('a file of both sets', () => {
  it('without a property leaves to the quick set what is not deep', () => {
    const alike = files.filter(({ text }) => {
      const names = fromDepth(text);
      return names.length > 0 && names.every((name) => DECLARES.test(name)) && !/fast-check/.test(text);
    });
    expect(alike.length).toBeGreaterThan(10);
    expect(alike.filter(({ text }) => namesFrom(text, /vitest/).includes('it')).map(({ path }) => path)).toEqual([]);
  });

  it('has no test that is in neither', () => {
    const lost = files.filter(({ text }) => {
      const isQuick = fromDepth(text).includes('itQuick as it') ? /(?<![\w.])(?:it|itQuick)[.(]/ : /\bitQuick[.(]/;
      const groups = text.split(/^(?=describe|it)/m);
      return groups.some(
        (group) =>
          (group.startsWith('describeDeep') && isQuick.test(group)) ||
          (group.startsWith('describeQuick') && /\bitDeep\b/.test(group)),
      );
    });
    expect(lost.map(({ path }) => path)).toEqual([]);
  });
});
