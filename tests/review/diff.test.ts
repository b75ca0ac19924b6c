import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compareHolds } from '../../check/runs/index.ts';
import { applyDiff, type Change, changesInWords, diffLevels, levelInLines } from '../../review/index.ts';
import { formatLevel, KINDS, type LevelFile, LISTED_KINDS, OBJECT_LISTS } from '../../schema/index.ts';
import { arbitraryFile as fileWithIds } from '../editor/arbitrary-file.ts';
import { arbitraryFile as anyFile } from '../schema/arbitrary-file.ts';

const RUNS = { numRuns: 150 };

type Json = Record<string, unknown>;

/** A file and another one made from it by random edits: moves, other fields, x- keys, removals, additions, another order. */
const edited = fc.oneof(anyFile, fileWithIds).chain((before) =>
  fc.tuple(fc.constant(before), fc.array(fc.nat(1000), { minLength: 60, maxLength: 60 }), anyFile).map(([file, dice, other]) => {
    let next = 0;
    const roll = (sides: number): number => dice[next++ % dice.length] % sides;
    const after = structuredClone(file) as unknown as Json;
    for (const list of [...OBJECT_LISTS, 'runs']) {
      const entries = (after[list] ?? []) as Json[];
      const kept = entries.filter(() => roll(6) > 0);
      for (const entry of kept) {
        if (list === 'runs') {
          if (roll(3) === 0) entry.holds = [...(entry.holds as unknown[]), [216_000 - 2, 216_000 - 1]];
          if (roll(4) === 0) entry.notes = [{ text: 'new', tick: roll(900) }, ...((entry.notes ?? []) as unknown[])];
          const [turns, goes] = [roll(4) === 0, roll(5) === 0];
          if (turns) (entry.notes as unknown[] | undefined)?.reverse();
          else if (goes) delete entry.notes;
          continue;
        }
        if (roll(3) === 0) entry.x = Math.max(-1e9, (entry.x as number) - 1 - roll(50) / 7);
        if (roll(4) === 0) entry['x-new'] = roll(3);
        if (roll(5) === 0) delete entry['x-own'];
        if (roll(6) === 0) delete entry.id;
      }
      if (roll(4) === 0) kept.reverse();
      if (roll(3) === 0 && list !== 'runs') {
        const more = ((other as unknown as Json)[list] ?? []) as Json[];
        kept.splice(roll(kept.length + 1), 0, ...more.map(({ id: _, ...entry }) => entry));
      }
      if (kept.length > 0 || roll(2) === 0) after[list] = kept;
      else delete after[list];
    }
    if (roll(3) === 0) after.name = 'Another name';
    if (roll(4) === 0) after.range = 321.5;
    if (roll(4) === 0) after.rules = roll(2) === 0 ? {} : { pull: 45 };
    if (roll(4) === 0) (after.astronaut as Json).vx = 3;
    if (roll(5) === 0) after['x-first'] = { a: [1, null] };
    return { before, after: after as unknown as LevelFile };
  }),
);

/** The same changes from the other side. */
function mirrored(changes: readonly Change[]): unknown[] {
  return changes.map((change) => {
    switch (change.type) {
      case 'added':
        return { ...change, type: 'removed' };
      case 'removed':
        return { ...change, type: 'added' };
      case 'order':
        return { ...change, pairs: change.pairs.map(([b, a]) => [a, b]).sort((p, q) => p[1] - q[1]) };
      default: {
        const turned: Json = { ...change };
        delete turned.before;
        delete turned.after;
        if ('before' in change) turned.after = change.before;
        if ('after' in change) turned.before = change.after;
        if ('fields' in change) turned.fields = change.fields.map((field) => mirrored([{ type: 'value', ...field }])[0]);
        if ('fields' in change) for (const field of turned.fields as Json[]) delete field.type;
        if ('keys' in change && change.keys !== null) turned.keys = { before: change.keys.after, after: change.keys.before };
        if ('empty' in change) turned.empty = { before: change.empty.after, after: change.empty.before };
        return turned;
      }
    }
  });
}

/** In an order that does not depend on the direction. */
const sorted = (changes: readonly unknown[]): string[] =>
  changes
    .map((change) => {
      const { fields, ...rest } = change as { fields?: { key: string }[] };
      const inOrder =
        fields === undefined ? {} : { fields: fields.map((field) => JSON.stringify(Object.entries(field).sort())).sort() };
      return JSON.stringify(Object.entries({ ...rest, ...inOrder }).sort(([p], [q]) => (p < q ? -1 : 1)));
    })
    .sort();

describe('the diff of two levels', () => {
  // one property, since making the levels takes longer than comparing them
  it('is empty if and only if their canonical texts are equal, and turns the first level into the second, also as JSON', () => {
    fc.assert(
      fc.property(edited, ({ before, after }) => {
        expect(diffLevels(before, structuredClone(before))).toEqual([]);
        const changes = diffLevels(before, after);
        expect(changes.length === 0).toBe(formatLevel(before) === formatLevel(after));
        expect(formatLevel(applyDiff(before, JSON.parse(JSON.stringify(changes))))).toBe(formatLevel(after));
      }),
      RUNS,
    );
  });

  it('of unrelated levels turns one into the other', () => {
    fc.assert(
      fc.property(anyFile, anyFile, (before, after) => {
        expect(formatLevel(applyDiff(before, diffLevels(before, after)))).toBe(formatLevel(after));
      }),
      { numRuns: 40 },
    );
  });

  it('is the mirror image of the diff in the other direction', () => {
    fc.assert(
      fc.property(edited, ({ before, after }) => {
        expect(sorted(mirrored(diffLevels(before, after)))).toEqual(sorted(diffLevels(after, before)));
      }),
      RUNS,
    );
  });
});

const BASE: LevelFile = {
  version: 1,
  name: 'Base',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: ['aa', 'bb', 'cc'].map((id, i) => ({ id, x: 100 * i, y: 0, radius: 16 })),
  minerals: [],
  runs: [
    {
      name: 'solution',
      holds: [
        [12, 96],
        [130, 188],
      ],
    },
    { name: 'other', holds: [] },
  ],
};

const words = (changes: Partial<LevelFile>, base: LevelFile = BASE): string[] => {
  const after = JSON.parse(JSON.stringify({ ...base, ...changes }));
  return changesInWords(diffLevels(base, after), after);
};
const [aa, bb, cc] = BASE.asteroids ?? [];
const run = (holds: [number, number][], name = 'solution') => ({
  runs: [
    { name, holds },
    { name: 'other', holds: [] },
  ],
});

describe('the words of a diff', () => {
  it.each<[string, Partial<LevelFile>, string[]]>([
    [
      'a move',
      { asteroids: [aa, { ...bb, x: 112, y: -3, radius: 20 }, cc] },
      ['asteroid 2 moved 12 px right and 3 px up, radius 16 -> 20 px'],
    ],
    ['a radius alone', { asteroids: [aa, { ...bb, radius: 16.5 }, cc] }, ['asteroid 2: radius 16 -> 16.5 px']],
    ['a tiny move', { asteroids: [aa, { ...bb, x: 100.001 }, cc] }, ['asteroid 2 moved less than 0.01 px']],
    ['a tiny radius', { asteroids: [aa, { ...bb, radius: 16.001 }, cc] }, ['asteroid 2: radius 16 -> 16.001 px']],
    ['a flag', { asteroids: [aa, { ...bb, hot: true }, cc] }, ['asteroid 2 became hot']],
    [
      'a default that is written',
      { asteroids: [aa, { ...bb, hot: false }, cc] },
      ['asteroid 2: hot: false, the default, is now written'],
    ],
    [
      'a removal, which gives the next one another number',
      { asteroids: [aa, { ...cc, y: 5 }] },
      ['asteroid 2 removed at (100, 0)', 'asteroid 2 (was 3) moved 5 px down'],
    ],
    [
      'several additions',
      {
        minerals: [
          { x: 1, y: 2 },
          { x: 3, y: 4 },
        ],
      },
      ['2 minerals added (1 and 2)'],
    ],
    ['an addition', { novae: [{ x: 120, y: 40, radius: 16 }] }, ['nova 1 added at (120, 40)']],
    ['a move of all', { asteroids: [aa, bb, cc].map((a) => ({ ...a, y: -64 })) }, ['asteroids 1 to 3 moved 64 px up']],
    ['another order', { asteroids: [cc, aa, bb] }, ['asteroids in another order']],
    ['a lost id', { asteroids: [aa, { ...bb, id: undefined }, cc] }, ['asteroid 2: id "bb" removed (matched by same content)']],
    [
      'a lost id and a move',
      { asteroids: [aa, { ...bb, id: undefined, y: 7 }, cc] },
      ['asteroid 2 moved 7 px down, id "bb" removed (matched by nearest place)'],
    ],
    ['her velocity', { astronaut: { x: 0, y: 0, vx: 40 } }, ['astronaut: speed x 0 -> 40 px/s']],
    ['a name', { name: 'New' }, ['renamed "Base" -> "New"']],
    ['the range', { range: 300 }, ['range 250 -> 300 px']],
    ['the default range, written', { range: 250 }, ['range 250 px, the default, is now written']],
    ['a rule', { rules: { pull: 45 } }, ['rule pull 45 px/s2 added']],
    ['recoil', { recoil: true }, ['recoil turned on']],
    ['a description', { description: 'Pull.' }, ['description added']],
    ['an x- key', { 'x-author': 'Ann' } as never, ['x-author "Ann" added']],
    ['a reason', { allow: { 'low-slack': 'a puzzle' } } as never, ['allow: low-slack "a puzzle" added']],
    ['conflicts of a merge', { conflicts: [{}, {}] } as never, ['2 unresolved conflicts of a merge']],
    ['an empty list', { minerals: undefined }, ['minerals: an empty list is no longer written']],
    [
      'a press',
      run([
        [12, 96],
        [134, 188],
      ]),
      ['run "solution": press 2 is 4 ticks later'],
    ],
    [
      'all edges',
      run([
        [11, 95],
        [129, 187],
      ]),
      ['run "solution": every press and release is 1 tick earlier'],
    ],
    ['a hold that is gone', run([[130, 190]]), ['run "solution": release 1 is 2 ticks later, hold 1 removed (12-96)']],
    [
      'a new name of a run',
      run(
        [
          [12, 96],
          [130, 188],
        ],
        'first',
      ),
      ['run "solution" renamed to "first"'],
    ],
    ['another first run', { runs: [...(BASE.runs ?? [])].reverse() }, ['run "other" is now the first']],
  ])('%s', (_, changes, expected) => {
    expect(words(changes)).toEqual(expected);
  });

  it('say that fields have several places only where they moved apart', () => {
    const kind = LISTED_KINDS.find((one) => KINDS[one].places.length > 1)!;
    const { list, one, places } = KINDS[kind];
    const object: Json = { id: 'ww', radius: 20 };
    for (const pair of places) for (const key of pair) object[key] = 10;
    const move = (keys: readonly string[]): Json => ({ ...object, ...Object.fromEntries(keys.map((key) => [key, 30])) });
    const say = (after: Json) => words({ [list!]: [after] } as never, { ...BASE, [list!]: [object] } as never);
    expect(say(move(places.map(([x]) => x)))).toEqual([`${one} 1 moved 20 px right`]);
    expect(say(move([places[1][1]]))).toEqual([`${one} 1 moved its second place 20 px down`]);
  });

  it('name only what changed, and contain neither NaN nor -0 nor a move by nothing', () => {
    fc.assert(
      fc.property(edited, ({ before, after }) => {
        const changes = diffLevels(before, after);
        const lines = changesInWords(changes, after);
        expect(lines.length > 0).toBe(changes.length > 0);
        for (const kind of LISTED_KINDS) {
          const { list, variant, one } = KINDS[kind];
          const named = new RegExp(`^(?:${variant?.one ?? one}|${one}) (\\d+)(?: \\(was (\\d+)\\))?(?: |:)(.*)$`);
          for (const line of lines) {
            const [, number, was, rest] = named.exec(line) ?? [];
            if (number === undefined) continue;
            const type = rest.startsWith('added') ? 'added' : rest.startsWith('removed') ? 'removed' : 'changed';
            const isNamed = (change: Change): boolean =>
              change.type === type &&
              change.of === list &&
              (change.type === 'changed' ? change.after : change.index) === +number - 1;
            const found = changes.find(isNamed);
            expect(found, line).toBeDefined();
            if (found?.type === 'changed') expect(found.before).toBe(Number(was ?? number) - 1);
          }
        }
        const unquoted = lines.map((line) => line.replace(/"(?:[^"\\]|\\.)*"/g, '""')).join('\n');
        expect(unquoted).not.toMatch(/NaN|Infinity|undefined|(?<![\d.e])-0(?![.\d])|moved 0 px| 0 px (?:right|left|up|down)/);
        // two equal numbers are no change
        for (const [, b, a] of unquoted.matchAll(/(\S+) -> (\S+)/g)) if (/^[-\d.]/.test(b)) expect(b).not.toBe(a);
      }),
      RUNS,
    );
  });

  it('cannot control a terminal, and are cut', () => {
    const lines = words({ name: `\u001b[31mred\u202e${'x'.repeat(90)}`, 'x-\u001b[2J': 1 } as never);
    for (const line of lines) expect(line).not.toMatch(/[\p{Cc}\p{Cf}]/u);
    expect(lines[0].length).toBeLessThan(120);
  });
});

describe('a level in lines', () => {
  it('differs wherever the level does, but for the order of objects and keys, and for empty lists', () => {
    const isOrder = ({ type }: Change): boolean => type === 'order' || type === 'keys' || type === 'empty-list';
    fc.assert(
      fc.property(edited, ({ before, after }) => {
        const changes = diffLevels(before, after).filter((change) => !isOrder(change));
        const isEmptyMap = (change: Change): boolean => change.type === 'map' && change.fields.length === 0;
        const isSame = levelInLines(before) === levelInLines(after);
        if (changes.some((change) => !isEmptyMap(change) && !('keys' in change && change.keys !== null)))
          expect(isSame).toBe(false);
        if (diffLevels(before, after).length === 0) expect(isSame).toBe(true);
        expect(levelInLines({ ...after, asteroids: [...(after.asteroids ?? [])].reverse() })).toBe(levelInLines(after));
      }),
      RUNS,
    );
  });

  it('has a line for each object and hold', () => {
    expect(levelInLines(BASE)).toBe(`level "Base"
version 1
astronaut at (0, 0)
black hole at (300, 0)
asteroid aa at (0, 0), radius 16 px
asteroid bb at (100, 0), radius 16 px
asteroid cc at (200, 0), radius 16 px
run "solution"
  hold 12-96
  hold 130-188
run "other"
`);
  });
});

describe('matching objects without ids', () => {
  const rock = (x: number, y: number, id?: string) => ({ x, y, radius: 16, ...(id !== undefined && { id }) });
  const moves = (before: object[], after: object[]) =>
    diffLevels({ ...BASE, asteroids: before as never }, { ...BASE, asteroids: after as never });

  it('takes equal content first, whatever the order, and then the nearest place', () => {
    expect(moves([rock(0, 0), rock(50, 0), rock(90, 0)], [rock(90, 0), rock(0, 0), rock(55, 0)])).toMatchObject([
      { type: 'changed', before: 1, after: 2, matchedBy: 'place' },
      {
        type: 'order',
        pairs: [
          [2, 0],
          [0, 1],
          [1, 2],
        ],
      },
    ]);
  });

  it('never takes one object for another if both have ids', () => {
    expect(moves([rock(0, 0, 'aa')], [rock(1, 0, 'bb')])).toMatchObject([{ type: 'removed' }, { type: 'added' }]);
    expect(moves([rock(0, 0, 'aa')], [rock(1, 0)])).toMatchObject([{ type: 'changed', matchedBy: 'place' }]);
  });

  it('pairs the nearest two of all, also where distances are equal', () => {
    fc.assert(
      fc.property(
        fc.array(fc.tuple(fc.nat(6), fc.nat(6)), { minLength: 1, maxLength: 8 }),
        fc.array(fc.tuple(fc.nat(6), fc.nat(6)), { minLength: 1, maxLength: 8 }),
        (before, after) => {
          const [b, a] = [before, after].map((points, side) => points.map(([x, y]) => ({ ...rock(x, y), radius: 16 + side })));
          const changes = moves(b, a).filter((change) => change.type === 'changed');
          expect(changes).toHaveLength(Math.min(b.length, a.length));
          const distance = (p: { x: number; y: number }, q: { x: number; y: number }) => Math.hypot(p.x - q.x, p.y - q.y);
          const least = Math.min(...b.flatMap((p) => a.map((q) => distance(p, q))));
          expect(Math.min(...changes.map((c) => distance(b[c.before], a[c.after])))).toBe(least);
        },
      ),
    );
  });
});

describe('notes of runs', () => {
  const noted = (...notes: [tick: number, text: string][]): LevelFile => ({
    ...BASE,
    runs: [{ name: 'solution', holds: [], notes: notes.map(([tick, text]) => ({ tick, text })) }],
  });
  const words = (before: LevelFile, after: LevelFile) => changesInWords(diffLevels(before, after), after);

  it('are added, moved, reworded and removed in words', () => {
    const before = noted([5, 'waits'], [60, 'swing'], [90, 'turns']);
    expect(words(before, noted([5, 'waits'], [70, 'swing'], [90, 'turns left'], [200, 'far']))).toEqual([
      'run "solution": note "swing" moved from tick 60 to 70, note at tick 90 now says "turns left", note "far" added at tick 200',
    ]);
    expect(words(before, noted([5, 'waits']))).toEqual([
      'run "solution": note "swing" removed from tick 60, note "turns" removed from tick 90',
    ]);
    const many = noted(...Array.from({ length: 9 }, (_, i): [number, string] => [1000 + i, `${i}`]));
    expect(words(noted(), many)).toEqual(['run "solution": 9 notes changed']);
    expect(words({ ...noted(), runs: [{ name: 'solution', holds: [] }] }, noted())).toEqual([
      'run "solution": an empty list of notes is now written',
    ]);
  });

  it('are the same in another order of the file, and have a line each', () => {
    const file = noted([60, 'b\u001b'], [60, 'a'], [5, 'c']);
    expect(diffLevels(file, noted([5, 'c'], [60, 'b\u001b'], [60, 'a']))).toEqual([]);
    expect(diffLevels(file, noted([5, 'c'], [60, 'a'], [60, 'b\u001b']))).toHaveLength(1);
    expect(levelInLines(file)).toContain('run "solution"\n  note 5 "c"\n  note 60 "b\\u001b"\n  note 60 "a"\n');
  });
});

describe('comparing holds', () => {
  const hold = fc
    .tuple(fc.nat(300), fc.integer({ min: 1, max: 40 }))
    .map(([press, more]): [number, number] => [press, press + more]);
  const holds = fc.array(hold, { maxLength: 8 }).map((list) => list.sort((p, q) => p[0] - q[0]));

  it('accounts for every hold of both sides once', () => {
    fc.assert(
      fc.property(holds, holds, (before, after) => {
        const { moved, removed, added } = compareHolds(before, after);
        expect(before.length - removed.length).toBe(after.length - added.length);
        expect(moved.every((edge) => edge.before !== edge.after && !added.includes(edge.hold))).toBe(true);
        for (const { edge, hold: index, after: tick } of moved) expect(after[index][edge === 'press' ? 0 : 1]).toBe(tick);
        const kept = before.filter((_, i) => !removed.includes(i));
        const result = after.flatMap(([press, release], i) => {
          if (added.includes(i)) return [];
          const at = (edge: 'press' | 'release', now: number) =>
            moved.find((one) => one.hold === i && one.edge === edge)?.before ?? now;
          return [[at('press', press), at('release', release)]];
        });
        expect(result).toEqual(kept);
      }),
    );
  });
});
