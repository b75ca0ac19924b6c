import fc from 'fast-check';
import { expect, it } from 'vitest';
import {
  addHold,
  addRun,
  createEditedLevel,
  deleteHolds,
  deleteRun,
  duplicateRun,
  freeRunName,
  holdsOf,
  moveHold,
  type Recipe,
  renameRun,
  reorderRun,
  replaceHolds,
  splitHold,
  stretchHold,
} from '../../editor/core/document/index.ts';
import { joinHolds } from '../../engine/index.ts';
import { type Hold, type LevelFile, LIMITS } from '../../schema/index.ts';

const levelWith = (runs: LevelFile['runs']): LevelFile => ({
  version: 1,
  name: 'holds',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  ...(runs === undefined ? {} : { runs }),
});

const fileAfter = (file: LevelFile, recipe: Recipe): LevelFile => {
  const level = createEditedLevel(file);
  const result = level.change('act', recipe);
  if (!result.ok) throw new Error(result.refusal.message);
  return level.file();
};
const holdsAfter = (holds: readonly Hold[], recipe: Recipe): readonly Hold[] =>
  holdsOf(fileAfter(levelWith([{ name: 'run', holds: holds.map(([press, release]) => [press, release]) }]), recipe), 'run');

/** Holds with at least one tick between them; every other time they end at the last tick. */
const someHolds: fc.Arbitrary<Hold[]> = fc
  .record({
    parts: fc.array(fc.tuple(fc.integer({ min: 1, max: 6 }), fc.integer({ min: 1, max: 6 })), { minLength: 1, maxLength: 4 }),
    touchesZero: fc.boolean(),
    room: fc.option(fc.nat(5)),
  })
  .map(({ parts, touchesZero, room }) => {
    let at = touchesZero ? -parts[0][0] : 0;
    const holds = parts.map(([gap, length]): Hold => {
      const press = at + gap;
      at = press + length;
      return [press, at];
    });
    const later = room === null ? 0 : LIMITS.tick - room - at;
    return holds.map(([press, release]): Hold => [press + later, release + later]);
  });
const picked = fc.tuple(someHolds, fc.nat(3)).map(([holds, n]) => ({ holds, index: n % holds.length }));
const ticks = fc.oneof(fc.integer({ min: -25, max: 25 }), fc.constantFrom(-1000, 1000));

const isPlayable = (holds: readonly Hold[]): boolean =>
  holds.every(([press, release], i) => press < release && press >= (i === 0 ? 0 : holds[i - 1][1] + 1) && release <= LIMITS.tick);

/** Steps from 0 towards `wanted`, tick by tick, while the holds are playable. @returns the last playable holds */
function walk(wanted: number, holdsAt: (way: number) => readonly Hold[]): readonly Hold[] {
  let way = 0;
  while (way !== wanted && isPlayable(holdsAt(way + Math.sign(wanted)))) way += Math.sign(wanted);
  return holdsAt(way);
}

const ripples = [false, true];

it('a hold moves up to its neighbours, or with ripple up to the first and last tick', () => {
  fc.assert(
    fc.property(picked, ticks, fc.constantFrom(...ripples), ({ holds, index }, by, ripple) => {
      const moves = (i: number) => (ripple ? i >= index : i === index);
      const expected = walk(by, (way) => holds.map(([a, b], i): Hold => (moves(i) ? [a + way, b + way] : [a, b])));
      expect(holdsAfter(holds, moveHold('run', index, by, { ripple }))).toEqual(expected);
    }),
    { numRuns: 500 },
  );
});

it('an edge of a hold moves up to its neighbours and its other edge; with ripple, later holds move along', () => {
  fc.assert(
    fc.property(
      picked,
      ticks,
      fc.constantFrom<'press' | 'release'>('press', 'release'),
      fc.constantFrom(...ripples),
      ({ holds, index }, by, edge, ripple) => {
        const expected = walk(by, (way) =>
          holds.map(([a, b], i): Hold => {
            if (i < index || (i > index && !ripple)) return [a, b];
            if (i > index || (edge === 'press' && ripple)) return [a + way, b + way];
            return edge === 'press' ? [a + way, b] : [a, b + way];
          }),
        );
        const from = holds[index][edge === 'press' ? 0 : 1];
        expect(holdsAfter(holds, stretchHold('run', index, edge, from + by, { ripple }))).toEqual(expected);
      },
    ),
    { numRuns: 800 },
  );
});

it('a run that does not exist has no holds, and operations on it do nothing', () => {
  for (const file of [levelWith(undefined), levelWith([]), levelWith([{ name: 'other', holds: [[1, 2]] }])]) {
    expect(holdsOf(file, 'run')).toEqual([]);
    for (const recipe of [moveHold('run', 0, 1), addHold('run', 1, 2), renameRun('run', 'x'), replaceHolds('run', [])])
      expect(fileAfter(file, recipe)).toEqual(file);
  }
});

it('ticks are rounded, missing holds are skipped, and ripple is off by default', () => {
  const holds: Hold[] = [
    [10, 20],
    [30, 40],
  ];
  expect(holdsAfter(holds, moveHold('run', 0, 1.4))).toEqual([[11, 21], holds[1]]);
  expect(holdsAfter(holds, moveHold('run', 0, 1.6))).toEqual([[12, 22], holds[1]]);
  expect(holdsAfter(holds, stretchHold('run', 0, 'release', 21.6))).toEqual([[10, 22], holds[1]]);
  expect(holdsAfter(holds, addHold('run', 49.6, 52.4))).toEqual([...holds, [50, 52]]);
  // without ripple by default
  expect(holdsAfter(holds, deleteHolds('run', [0]))).toEqual([holds[1]]);
  expect(holdsAfter(holds, moveHold('run', 0, 3))).toEqual([[13, 23], holds[1]]);
  expect(holdsAfter(holds, stretchHold('run', 0, 'press', 13))).toEqual([[13, 20], holds[1]]);
  expect(holdsAfter(holds, splitHold('run', 0, 14.6))).toEqual([[10, 15], [16, 20], holds[1]]);
  for (const recipe of [
    moveHold('run', 2, 5),
    moveHold('other', 0, 5),
    stretchHold('run', 2, 'press', 5),
    splitHold('run', 2, 35),
    deleteHolds('run', [2]),
    renameRun('other', 'x'),
    deleteRun('other'),
    duplicateRun('other', 'x'),
    reorderRun('other', 0),
    replaceHolds('other', []),
  ])
    expect(holdsAfter(holds, recipe)).toEqual(holds);
});

it('a hold can be split at every tick that leaves something on both sides', () => {
  fc.assert(
    fc.property(picked, fc.integer({ min: -2, max: 9 }), ({ holds, index }, n) => {
      const [press, release] = holds[index];
      const at = press + n;
      const parts: Hold[] = [
        [press, at],
        [at + 1, release],
      ];
      const splits = parts.every(([a, b]) => a < b);
      expect(holdsAfter(holds, splitHold('run', index, at))).toEqual(splits ? holds.toSpliced(index, 1, ...parts) : holds);
    }),
  );
});

it('an added hold joins those that it touches, whichever end is given first', () => {
  fc.assert(
    fc.property(someHolds, fc.nat(40), fc.nat(40), (holds, a, b) => {
      const near = holds[0][0];
      const [press, release] = [near + a - 20, near + b - 20].map((tick) => Math.min(LIMITS.tick, Math.max(0, tick)));
      const expected = joinHolds([...holds, [Math.min(press, release), Math.max(press, release)]]);
      expect(holdsAfter(holds, addHold('run', press, release))).toEqual(expected);
    }),
  );
});

it('removing holds does not move the others; with ripple, the gaps keep their lengths', () => {
  fc.assert(
    fc.property(someHolds, fc.subarray([0, 1, 2, 3]), fc.constantFrom(...ripples), (holds, gone, ripple) => {
      const earlier = (i: number) =>
        ripple ? holds.slice(0, i).reduce((sum, [a, b], n) => sum + (gone.includes(n) ? b - a : 0), 0) : 0;
      const left = holds.flatMap(([a, b], i): Hold[] => (gone.includes(i) ? [] : [[a - earlier(i), b - earlier(i)]]));
      expect(holdsAfter(holds, deleteHolds('run', gone, { ripple }))).toEqual(joinHolds(left));
    }),
  );
});

const runs = fc.uniqueArray(fc.constantFrom('a', 'b', 'c', 'd'), { minLength: 1 });
const runFile = (name: string) => ({ name, holds: [[1, 2 + name.charCodeAt(0)]] as [number, number][], 'x-of': name });

it('runs can be added at either end, duplicated, renamed and removed', () => {
  fc.assert(
    fc.property(runs, fc.nat(3), (names, n) => {
      const file = levelWith(names.map(runFile));
      const one = names[n % names.length];
      const index = names.indexOf(one);
      const all = names.map(runFile);
      const added = { name: 'new', holds: [[3, 4]] as [number, number][] };
      expect(fileAfter(file, addRun('new', [[3, 4]])).runs).toEqual([...all, added]);
      expect(fileAfter(file, addRun('new', [[3, 4]], 'first')).runs).toEqual([added, ...all]);
      expect(fileAfter(file, duplicateRun(one, 'copy')).runs).toEqual(
        all.toSpliced(index + 1, 0, { ...runFile(one), name: 'copy' }),
      );
      expect(fileAfter(file, renameRun(one, 'new')).runs).toEqual(all.with(index, { ...runFile(one), name: 'new' }));
      expect(fileAfter(file, replaceHolds(one, [[3, 4]])).runs).toEqual(all.with(index, { ...runFile(one), holds: [[3, 4]] }));
      const left = all.toSpliced(index, 1);
      // an empty list is omitted
      expect(fileAfter(file, deleteRun(one)).runs).toEqual(left.length === 0 ? undefined : left);
    }),
  );
  expect(fileAfter(levelWith(undefined), addRun('new', [])).runs).toEqual([{ name: 'new', holds: [] }]);
});

it('a run moves to a place in the list, or to the end if there is no such place', () => {
  fc.assert(
    fc.property(runs, fc.nat(3), fc.integer({ min: -3, max: 6 }), (names, n, to) => {
      const one = names[n % names.length];
      const others = names.filter((name) => name !== one);
      const place = to < 0 ? 0 : to;
      const expected = [...others.slice(0, place), one, ...others.slice(place)];
      expect(fileAfter(levelWith(names.map(runFile)), reorderRun(one, to)).runs).toEqual(expected.map(runFile));
    }),
  );
});

it('a free name is the wanted one, or has the smallest free number from 2 on; a long name is cut', () => {
  const file = (...names: string[]) => levelWith(names.map((name) => ({ name, holds: [] })));
  expect(freeRunName(levelWith(undefined), 'run')).toBe('run');
  expect(freeRunName(file('other'), 'run')).toBe('run');
  expect(freeRunName(file('run'), 'run')).toBe('run 2');
  expect(freeRunName(file('run', 'run 2', 'run 4'), 'run')).toBe('run 3');
  const long = 'n'.repeat(100);
  expect(freeRunName(file(), long)).toBe('n'.repeat(70));
  expect(freeRunName(file('n'.repeat(70)), long)).toBe(`${'n'.repeat(70)} 2`);
});
