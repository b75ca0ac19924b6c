import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { movedLevel } from '../../bench/harness/index.ts';
import { compile, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';

// The benchmarks `check` and `tune` take it for granted that a level moved as a whole is another one with the same verdict.

const SHIPPED = join(import.meta.dirname, '../../levels');
const files = readdirSync(SHIPPED).filter((name) => name.endsWith('.level.json'));

describe('a shipped level moved as a whole', () => {
  it.each(files)('%s ends as before', (name) => {
    const file = JSON.parse(readFileSync(join(SHIPPED, name), 'utf8')) as LevelFile;
    const there = resolveLevel(movedLevel(file, 300, -200));
    for (const { holds } of resolveLevel(file).runs) {
      const before = simulate(compile(resolveLevel(file), 'precise'), holds);
      const after = simulate(compile(there, 'precise'), holds);
      expect(after.outcome).toBe(before.outcome);
      expect(after.time).toBeCloseTo(before.time, 6);
    }
  });
});
