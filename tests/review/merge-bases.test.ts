import { expect, it } from 'vitest';
import { mergeLevels } from '../../review/index.ts';
import type { LevelFile } from '../../schema/index.ts';

const named = (name: string): LevelFile => ({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });

it('a version that was sent but not confirmed is a base, too: a value from any base is no change of theirs', () => {
  const merged = mergeLevels(named('first'), named('third'), named('second'), new Map(), [named('second')]);
  expect(merged).toEqual({ file: named('third'), conflicts: [] });
  expect(mergeLevels(named('first'), named('third'), named('first'), new Map(), [named('second')]).file.name).toBe('third');
});

it('mine is unchanged only if it equals all bases', () => {
  const gone = mergeLevels(named('first'), named('first'), named('theirs'), new Map(), [named('second')]);
  expect(gone.conflicts.map(({ key }) => key)).toEqual(['name']);
  expect(gone.file.name).toBe('first');
  const same = mergeLevels(named('first'), named('first'), named('theirs'), new Map(), [named('first')]);
  expect(same).toEqual({ file: named('theirs'), conflicts: [] });
});
