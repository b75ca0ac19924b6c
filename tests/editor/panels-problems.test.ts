import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createEditedLevel } from '../../editor/core/document/index.ts';
import { createProver } from '../../editor/core/proof/index.ts';
import { Explanation, explanationOf } from '../../editor/features/problems/explanations.tsx';
import { quickFixOf, runAt } from '../../editor/features/problems/feature.tsx';
import { keepSame, keysOf } from '../../editor/features/problems/index.ts';
import { DEFAULT_TERMS, WARNING_CODES } from '../../engine/index.ts';
import { CODES, type Hold, type LevelFile, type Problem } from '../../schema/index.ts';

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

const prove = (file: LevelFile) => createProver(() => 0).prove({ file, run: 'untidy', terms: DEFAULT_TERMS });

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
    expect(after.full?.hash).toBe(before.full?.hash);
    expect(document.file().runs?.[0]).toEqual({ name: 'fine', holds: [[5, 20]] });
  });

  it('is not offered if the user has to decide', () => {
    const document = createEditedLevel({ ...fileWith([[10, 20]]), blackHole: { x: 9000, y: 0 } });
    const { problems } = prove(document.file());
    expect(problems.length).toBeGreaterThan(0);
    for (const problem of problems) expect(quickFixOf(document.file(), problem)).toBeNull();
  });
});

it('every code has an explanation', () => {
  const codes = [...CODES, ...WARNING_CODES].map(({ code }) => code);
  for (const code of [
    ...codes,
    'proved-impossible',
    'mineral-never-collectable',
    'no-run',
    'run-does-not-complete',
    'verdict-hangs-on-accuracy',
    'work-limit',
    'file-unreadable',
    'file-deleted',
  ]) {
    expect(explanationOf(code)?.title, code).toBeTruthy();
  }
  expect(explanationOf('no-such-code')).toBeNull();
  expect(JSON.stringify(Explanation({ code: 'no-such-code' }))).toMatch(/Not explained here.*no-such-code/);
});

describe('shown problems', () => {
  const problem: fc.Arbitrary<Problem> = fc.record({
    code: fc.constantFrom('a', 'b'),
    severity: fc.constantFrom('error', 'warning'),
    message: fc.constantFrom('m', 'n'),
    hint: fc.constantFrom('h', 'i'),
    pointer: fc.constantFrom('/x', '/y'),
    line: fc.constantFrom(null, 1),
    column: fc.constant(null),
  });
  const problems = fc.array(problem, { maxLength: 6 });

  it('are those that were found, and stay the same objects without changes', () => {
    fc.assert(
      fc.property(problems, problems, (before, now) => {
        const kept = keepSame(before, now);
        expect(kept).toEqual(now);
        // equal problems may replace each other
        for (const one of kept) expect(before.includes(one) || now.includes(one)).toBe(true);
        const known = before.filter(
          (old, i) =>
            before.findIndex(
              (other) => other.pointer === old.pointer && other.code === old.code && other.message === old.message,
            ) === i,
        );
        const copies = known.map((old) => ({ ...old }));
        expect(keepSame(known, copies)).toBe(known);
      }),
    );
  });

  it('have unique keys, which do not change if new ones come before them', () => {
    fc.assert(
      fc.property(problems, problem, (list, other) => {
        const keys = keysOf(list);
        expect(new Set(keys).size).toBe(list.length);
        if (list.every(({ code, pointer }) => code !== other.code || pointer !== other.pointer)) {
          expect(keysOf([other, ...list]).slice(1)).toEqual(keys);
        }
      }),
    );
  });
});
