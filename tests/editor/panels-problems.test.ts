import { describe, expect, it } from 'vitest';
import { createEditedLevel } from '../../editor/document/index.ts';
import { explanationOf } from '../../editor/panels/problems/explanations.ts';
import { quickFixOf, runAt } from '../../editor/panels/problems/quick-fix.ts';
import { createProver } from '../../editor/proof/index.ts';
import { WARNING_CODES } from '../../engine/index.ts';
import { CODES, type Hold, type LevelFile } from '../../schema/index.ts';

const fileWith = (holds: readonly Hold[]): LevelFile => ({
  version: 1,
  name: 'level',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 40 },
  asteroids: [{ x: 200, y: 0, radius: 16 }],
  runs: [
    { name: 'fine', holds: [[5, 20]] },
    { name: 'untidy', holds: holds.map(([press, release]): [number, number] => [press, release]) },
  ],
});

const prove = (file: LevelFile) => createProver(() => 0).prove({ file, run: 'untidy', accuracy: 'precise' });

describe('a quick fix', () => {
  it.each([
    [
      'holds-overlap',
      [
        [10, 60],
        [40, 90],
        [90, 100],
      ],
    ],
    [
      'holds-unsorted',
      [
        [110, 160],
        [40, 90],
      ],
    ],
  ] as const)('of %s takes the problem away, and nothing plays differently', (code, holds) => {
    const document = createEditedLevel(fileWith(holds));
    const before = prove(document.file());
    const problem = before.problems.find((other) => other.code === code);
    if (problem === undefined) throw new Error(`expected the level to have ${code}`);
    expect(runAt(document.file(), problem.pointer)).toBe('untidy');
    const fix = quickFixOf(document.file(), problem);
    if (fix === null) throw new Error('expected a fix');
    expect(document.change(fix.title, fix.recipe).ok).toBe(true);
    const after = prove(document.file());
    expect(after.problems.map((other) => other.code)).not.toContain(code);
    expect(after.full.hash).toBe(before.full.hash);
    expect(document.file().runs?.[0]).toEqual({ name: 'fine', holds: [[5, 20]] });
  });

  it('is offered for nothing that somebody has to decide', () => {
    const document = createEditedLevel({ ...fileWith([[10, 20]]), blackHole: { x: 9000, y: 0 } });
    const { problems } = prove(document.file());
    expect(problems.length).toBeGreaterThan(0);
    for (const problem of problems) expect(quickFixOf(document.file(), problem)).toBeNull();
  });
});

it('every code that can be told has an explanation', () => {
  const codes = [...CODES, ...WARNING_CODES].map(({ code }) => code);
  for (const code of [
    ...codes,
    'proved-impossible',
    'mineral-never-collectable',
    'no-run',
    'run-does-not-complete',
    'verdict-hangs-on-accuracy',
  ]) {
    expect(explanationOf(code)?.title, code).toBeTruthy();
  }
  expect(explanationOf('no-such-code')).toBeNull();
});
