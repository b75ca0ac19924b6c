import { describe, expect, it } from 'vitest';
import { mergeLevels, resolveConflicts, withConflicts } from '../../review/index.ts';
import { conflictProblems, formatLevel, type LevelFile, readLevel, resolveLevel } from '../../schema/index.ts';

const BASE: LevelFile = {
  version: 1,
  name: 'base',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [{ id: 'aa', x: 1, y: 2, radius: 16 }],
  runs: [{ name: 'a/b', holds: [[1, 5]] }],
};
const change = (changes: Partial<LevelFile>): LevelFile => ({ ...BASE, ...changes });
const rock = (changes: object): LevelFile => change({ asteroids: [{ ...(BASE.asteroids?.[0] as object), ...changes } as never] });

function read(file: LevelFile) {
  const reading = readLevel(formatLevel(file));
  if (!reading.ok) throw new Error(reading.problems[0].message);
  return reading;
}

describe('conflicts in a file', () => {
  const marked = withConflicts(mergeLevels(BASE, rock({ radius: 20 }), rock({ radius: 24 })));

  it('stand at the top, with both values, and the level is ours', () => {
    expect(formatLevel(marked)).toBe(`{
  "version": 1,
  "conflicts": [
    {
      "what": "asteroid aa, radius",
      "key": "asteroids/aa/radius",
      "base": 16,
      "ours": 20,
      "theirs": 24
    }
  ],
  "name": "base",
  "astronaut": { "x": 0, "y": 0 },
  "blackHole": { "x": 300, "y": 0 },
  "asteroids": [
    { "id": "aa", "x": 1, "y": 2, "radius": 20 }
  ],
  "runs": [
    {
      "name": "a/b",
      "holds": [
        [1, 5]
      ]
    }
  ]
}
`);
    expect(read(marked).level).toEqual(resolveLevel(rock({ radius: 20 })));
  });

  it('are problems with the places of their entries', () => {
    expect(conflictProblems(marked, read(marked).document.locate)).toMatchObject([
      {
        code: 'merge-conflict',
        severity: 'error',
        message: '"asteroid aa, radius" is undecided after a merge: ours is 20, theirs 24',
        pointer: '/conflicts/0',
        line: 4,
        column: 5,
      },
    ]);
    expect(conflictProblems(BASE, read(BASE).document.locate)).toEqual([]);
    const many = { ...BASE, conflicts: Array.from({ length: 30 }, (_, i) => ({ what: `w${i}`, key: `x-${i}`, theirs: null })) };
    const problems = conflictProblems(many, read(many).document.locate);
    expect(problems).toHaveLength(21);
    expect(problems[20]).toMatchObject({ code: 'more-problems', message: 'and 10 more conflicts' });
    expect(problems[0].message).toContain('ours is nothing, theirs null');
  });

  it('have a strict shape', () => {
    const problemsOf = (conflicts: unknown) => {
      const reading = readLevel(JSON.stringify({ ...BASE, conflicts }));
      return reading.ok ? [] : reading.problems.map(({ code, message }) => `${code} ${message}`);
    };
    expect(problemsOf([])).toEqual([]);
    expect(problemsOf([{ what: 'x', key: 'name', ours: { 'x-a': [1] } }])).toEqual([]);
    expect(problemsOf({})).toEqual(['wrong-type conflicts: expected a list in [ ], found an object']);
    expect(problemsOf([{ what: 'x', key: 'name', mine: 1 }, 3])).toEqual([
      'unknown-key unknown key "mine" in conflict 1',
      'wrong-type conflict 2: expected an object in { }, found the number 3',
    ]);
    expect(problemsOf([{ what: 'x' }])).toEqual(['missing-key the key "key" is missing in conflict 1']);
  });

  it('that point nowhere, or hold nonsense, are removed and change nothing', () => {
    const keys = [
      'asteroids/zz/radius',
      'asteroids/zz/radius/x',
      'order/asteroids',
      'order',
      'runs/none/holds',
      'rules',
      'rules/pull',
      '/',
      '~',
      'nothing/at/all',
    ];
    for (const key of keys) {
      const file = { ...BASE, conflicts: [{ what: '', key, theirs: 'nonsense' }] };
      const resolved = resolveConflicts(file, new Map([[key, 'theirs']]));
      expect(resolved.conflicts).toBeUndefined();
      expect(resolved.asteroids).toEqual(BASE.asteroids);
      expect(resolved.runs).toEqual(BASE.runs);
    }
  });

  it('without a choice stay', () => {
    const two = withConflicts(mergeLevels(BASE, { ...rock({ radius: 20 }), name: 'm' }, { ...rock({ radius: 24 }), name: 't' }));
    const one = resolveConflicts(two, new Map([['name', 'theirs']]));
    expect(one.name).toBe('t');
    expect(one.conflicts?.map(({ key }) => key)).toEqual(['asteroids/aa/radius']);
    expect(resolveConflicts(one, new Map([['asteroids/aa/radius', 'theirs']]))).toEqual({ ...rock({ radius: 24 }), name: 't' });
  });
});

describe('merging files that have conflicts', () => {
  const marked = withConflicts(mergeLevels(BASE, rock({ radius: 20 }), rock({ radius: 24 })));

  it('keeps them until one side has decided', () => {
    expect(mergeLevels(marked, marked, { ...marked, name: 't' })).toEqual({ file: { ...marked, name: 't' }, conflicts: [] });
    const decided = rock({ radius: 24 });
    expect(mergeLevels(marked, decided, { ...marked, name: 't' })).toEqual({ file: { ...decided, name: 't' }, conflicts: [] });
    expect(mergeLevels(BASE, marked, BASE)).toEqual({ file: marked, conflicts: [] });
    expect(mergeLevels(BASE, BASE, marked)).toEqual({ file: marked, conflicts: [] });
    expect(mergeLevels(marked, marked, { ...rock({ radius: 30 }), conflicts: [] }).file.conflicts).toBeUndefined();
  });

  it('does not know the value of a base that is undecided, as in a criss-cross merge', () => {
    const crossed = mergeLevels(marked, rock({ radius: 20 }), rock({ radius: 24 }));
    expect(crossed.conflicts).toMatchObject([{ key: 'asteroids/aa/radius', mine: 20, theirs: 24 }]);
    expect(mergeLevels(marked, rock({ radius: 24 }), rock({ radius: 24 })).conflicts).toEqual([]);
    expect(mergeLevels(marked, change({ asteroids: [] }), rock({ radius: 20 })).conflicts).toMatchObject([
      { key: 'asteroids/aa' },
    ]);
  });
});

describe('what merging does with', () => {
  const asteroids = (ids: readonly string[]) => ids.map((id, i) => ({ id, x: i, y: 0, radius: 16 }));

  it('an object whose kind one side changed: the edits of the other go with it', () => {
    const nova = change({ asteroids: [], novae: [{ id: 'aa', x: 1, y: 2, radius: 16 }] });
    const { file, conflicts } = mergeLevels(BASE, nova, rock({ x: 50 }));
    expect(conflicts).toEqual([]);
    expect(file).toEqual({ ...nova, novae: [{ id: 'aa', x: 50, y: 2, radius: 16 }] });
    // a nova can't be hot
    const hot = mergeLevels(BASE, nova, rock({ hot: true }));
    expect(hot.conflicts).toMatchObject([{ key: 'asteroids/aa', mine: { kind: 'nova', x: 1 }, theirs: { x: 1, hot: true } }]);
    expect(resolveConflicts(withConflicts(hot), new Map([['asteroids/aa', 'theirs']]))).toMatchObject({
      asteroids: [{ id: 'aa', hot: true }],
      novae: [],
    });
  });

  it('two objects that both sides added under one id: a conflict of the whole, and nothing is mixed', () => {
    const mine = change({ asteroids: [...(BASE.asteroids ?? []), { id: 'new', x: 1, y: 1, radius: 5 }] });
    const theirs = change({ minerals: [{ id: 'new', x: 9, y: 9 }] });
    const { file, conflicts } = mergeLevels(BASE, mine, theirs);
    expect(file).toEqual(mine);
    expect(conflicts).toMatchObject([{ key: 'asteroids/new', mine: { radius: 5 }, theirs: { kind: 'mineral', x: 9 } }]);
  });

  it('a run and an object called order: their keys differ from those of the order', () => {
    const base = change({ asteroids: asteroids(['order', 'bb', 'cc']) });
    const mine = change({ asteroids: asteroids(['bb', 'cc']).reverse() });
    const theirs = change({ asteroids: [...asteroids(['order', 'cc']), ...asteroids(['bb'])].map((a) => ({ ...a, x: 77 })) });
    const keys = mergeLevels(base, mine, theirs).conflicts.map(({ key }) => key);
    expect(new Set(keys).size).toBe(keys.length);
    expect(keys).toContain('asteroids/order');
  });

  it('more objects than a level can have: one list stands, the other is in the conflict', () => {
    const ids = (letter: string) => asteroids(Array.from({ length: 11_000 }, (_, i) => `${letter}${i}`));
    const { file, conflicts } = mergeLevels(BASE, change({ asteroids: ids('a') }), change({ asteroids: ids('b') }));
    expect(conflicts.map(({ key }) => key)).toContain('asteroids');
    expect(file.asteroids).toHaveLength(11_000);
  });

  it('two versions without a base', () => {
    const { file, conflicts } = mergeLevels(
      null,
      rock({ radius: 20 }),
      change({ name: 'theirs', minerals: [{ id: 'mm', x: 1, y: 1 }] }),
    );
    expect(conflicts.map(({ key }) => key)).toEqual(['name', 'asteroids/aa']);
    expect(file).toEqual({ ...rock({ radius: 20 }), minerals: [{ id: 'mm', x: 1, y: 1 }] });
  });
});
