import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { formatLevel, importOriginal, readLevel } from '../../schema/index.ts';

function imported(value: unknown, recoil = true) {
  const reading = importOriginal(JSON.stringify(value), { recoil });
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return reading;
}

function problems(source: string) {
  const reading = importOriginal(source, { recoil: true });
  if (reading.ok) throw new Error('was imported');
  return reading.problems.map((p) => `${p.line}:${p.column} ${p.code} ${p.pointer} | ${p.message}`);
}

const player = { x: 1, y: 2, key: 'player' };
const target = { x: 3, y: 4, radius: 18, key: 'target' };

const number = fc.double({ min: -1e6, max: 1e6, noNaN: true });
const size = fc.oneof(fc.integer({ min: 1, max: 999 }), fc.integer({ min: 1, max: 999 }).map(String));
const circle = fc.record({ x: number, y: number, radius: size });
const loose = fc.record({ x: number, y: number, radius: size }, { requiredKeys: ['x', 'y'] });
const list = <T>(entry: fc.Arbitrary<T>) => fc.array(entry, { minLength: 1, maxLength: 6 });
const original = fc.record(
  {
    player: fc.record({ x: number, y: number, vx: fc.integer({ min: -9, max: 9 }) }, { requiredKeys: ['x', 'y'] }),
    target: circle,
    asteroids: list(
      fc.record({ x: number, y: number, radius: size, enemy: fc.boolean() }, { requiredKeys: ['x', 'y', 'radius'] }),
    ),
    novae: list(circle),
    antiForceFields: list(circle),
    aliens: list(loose),
    goodies: list(loose),
    maxDistance: fc.integer({ min: 1, max: 9999 }),
  },
  { requiredKeys: ['player', 'target'] },
);

describe('importing levels of the original game', () => {
  test('keeps every object with its numbers, at its place in the list', () => {
    fc.assert(
      fc.property(original, (level) => {
        const text = formatLevel(imported(level).levels[0].file);
        const reading = readLevel(text);
        if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
        const read = reading.level;
        const plain = (list: typeof read.novae) => list.map(({ x, y, radius }) => ({ x, y, radius }));
        const expected = (list: { x: number; y: number; radius?: number | string }[] | undefined, radius?: number) =>
          (list ?? []).map((o) => ({ x: o.x + 0, y: o.y + 0, radius: Number(o.radius ?? radius) }));
        expect(plain(read.asteroids)).toEqual(expected(level.asteroids));
        expect(read.asteroids.map(({ hot }) => hot)).toEqual((level.asteroids ?? []).map(({ enemy }) => enemy ?? false));
        expect(plain(read.novae)).toEqual(expected(level.novae));
        expect(plain(read.repulsors)).toEqual(expected(level.antiForceFields));
        expect(plain(read.aliens)).toEqual(expected(level.aliens, 25));
        expect(plain(read.minerals)).toEqual(expected(level.goodies, 7));
        expect(read.astronaut).toEqual({ x: level.player.x + 0, y: level.player.y + 0, vx: (level.player.vx ?? 0) + 0, vy: 0 });
        expect([read.blackHole]).toEqual(expected([level.target]));
        expect(read.range).toBe(level.maxDistance ?? 250);
        expect(read.recoil).toBe(true);
        for (const object of [...read.asteroids, ...read.minerals]) expect(object.id).not.toBeNull();
      }),
    );
  });

  test('names levels by their place in the list, and reports skipped empty objects', () => {
    const { levels, notes } = imported([{}, { player, target }, {}, { player, target }], false);
    expect(levels.map(({ slug, file }) => [slug, file.name, file.recoil])).toEqual([
      ['level-01', 'Level 1', undefined],
      ['level-03', 'Level 3', undefined],
    ]);
    expect(notes).toEqual([
      'skipped entry 1, entry 3: empty (a placeholder of the menu)',
      'ignored keys that have no meaning here: key (4 times)',
    ]);
  });

  test('reads a single object as level 1', () => {
    const { levels, notes } = imported({ player: { x: 1, y: 2 }, target: { x: 3, y: 4 } });
    expect(levels.map(({ slug, file }) => [slug, file.name])).toEqual([['level-01', 'Level 1']]);
    expect(levels[0].file.blackHole.radius).toBeUndefined();
    expect(notes).toEqual([]);
  });

  test('ignores a byte order mark', () => {
    expect(importOriginal(`\ufeff${JSON.stringify([{ player, target }])}`, { recoil: true }).ok).toBe(true);
  });

  test.each([
    ['nothing but placeholders', '[{}, {}]', '1:1 nothing-to-import  | there is no level in this file'],
    ['an empty list', '[]', '1:1 nothing-to-import  | there is no level in this file'],
    ['a number', '7', '1:1 wrong-type  | expected a level object of the original game or a list of them, found the number 7'],
    ['a number in the list', '[{}, 7]', '1:6 wrong-type /1 | entry 2: expected an object in { }, found the number 7'],
    ['not JSON', '[{},]', '1:4 trailing-comma  | expected a value after the comma, found "]"'],
    [
      'a key twice',
      '[{"player":{"x":1,"x":1,"y":2},"target":{"x":1,"y":2}}]',
      '1:19 duplicate-key /0/player/x | this object has the key "x" more than once',
    ],
    ['no target', '[{"player":{"x":1,"y":2}}]', '1:2 missing-key /0 | the key "target" is missing in entry 1'],
    ['no y', '{"player":{"x":1},"target":{"x":1,"y":2}}', '1:11 missing-key /player | the key "y" is missing in player'],
    [
      'a list of players',
      '{"player":[],"target":{"x":1,"y":2}}',
      '1:11 wrong-type /player | player: expected an object in { }, found an empty list',
    ],
  ])('%s', (_, source, problem) => {
    expect(problems(source)).toEqual([problem]);
  });

  test.each([
    ['"asteroids":[{"x":1,"y":2}]', 'missing-key /asteroids/0 | the key "radius" is missing in asteroid 1'],
    [
      '"novae":[{"x":1,"y":2,"radius":"0"}]',
      'out-of-limits /novae/0/radius | nova 1, radius: expected a number from 0.001 to 1000000, found 0',
    ],
    [
      '"novae":[{"x":1,"y":2,"radius":"1e2"}]',
      'wrong-type /novae/0/radius | nova 1, radius: expected a number or a text of digits, found the text "1e2"',
    ],
    ['"novae":[{"x":"1","y":2,"radius":1}]', 'wrong-type /novae/0/x | nova 1, x: expected a number, found the text "1"'],
    [
      '"goodies":[{"x":1e300,"y":2}]',
      'out-of-limits /goodies/0/x | goodies, entry 1, x: expected a number from -1000000000 to 1000000000, found 1e+300',
    ],
    [
      '"asteroids":[{"x":1,"y":2,"radius":1,"enemy":1}]',
      'wrong-type /asteroids/0/enemy | asteroid 1, enemy: expected true or false, found the number 1',
    ],
    ['"aliens":{}', 'wrong-type /aliens | aliens: expected a list in [ ], found an object'],
    ['"aliens":[null]', 'wrong-type /aliens/0 | alien 1: expected an object in { }, found null'],
    ['"maxDistance":-1', 'out-of-limits /maxDistance | maxDistance: expected a number from 0.001 to 1000000, found -1'],
  ])('a level with %s', (rest, problem) => {
    const said = problems(`{"player":{"x":1,"y":2},"target":{"x":3,"y":4,"radius":5},${rest}}`);
    expect(said.map((line) => line.replace(/^1:\d+ /, ''))).toEqual([problem]);
  });
});
