import { Script } from 'node:vm';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  exportOriginal,
  formatLevel,
  formatOriginal,
  importOriginal,
  KINDS,
  type LevelFile,
  LISTED_KINDS,
  readLevel,
  resolveLevel,
} from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

function read(file: LevelFile, rules = {}) {
  const reading = readLevel(formatLevel(file), { rules });
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return reading;
}

const exported = (file: LevelFile, rules = {}) => {
  const reading = read(file, rules);
  return exportOriginal(reading.level, reading.document);
};

function imported(text: string) {
  const reading = importOriginal(text, { recoil: true });
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return reading.levels.map(({ file }) => file);
}

/** What plays the same has the same of these. */
function played(file: LevelFile): unknown {
  const { name: _, description: __, runs: ___, ...level } = resolveLevel(file);
  const withoutId = (value: unknown) => (Array.isArray(value) ? value.map(({ id: _, ...rest }) => rest) : value);
  return Object.fromEntries(Object.entries(level).map(([key, value]) => [key, withoutId(value)]));
}

const unsayable = LISTED_KINDS.filter((kind) => KINDS[kind].original === null).map((kind) => KINDS[kind].list as string);

const sayable = arbitraryFile.map(
  (file): LevelFile => ({ ...file, recoil: true, ...Object.fromEntries(unsayable.map((list) => [list, undefined])) }),
);

const base: LevelFile = {
  version: 1,
  name: 'Base',
  recoil: true,
  astronaut: { x: 10, y: 20 },
  blackHole: { x: 30, y: 40 },
};

describe('a level of the original game', () => {
  test('is the same after export and import', () => {
    fc.assert(
      fc.property(sayable, fc.constantFrom('json' as const, 'module' as const), (file, shape) => {
        const { object, refused } = exported(file);
        expect(refused).toEqual([]);
        const text = formatOriginal([{ title: file.name, object }], shape);
        const [again] = imported(text);
        expect(played(again)).toEqual(played(file));
        // an imported level has the same ids again
        const second = formatOriginal([{ title: file.name, object: exported(again).object }], shape);
        expect(second).toBe(text);
        expect(imported(second)).toEqual([again]);
      }),
      { numRuns: 60 },
    );
  });

  test('has the numbers that the original has, as numbers, and the pictures of their sizes', () => {
    const file: LevelFile = {
      ...base,
      asteroids: [
        { id: 'aa', x: 1, y: 2, radius: 16 },
        { x: 3, y: 4, radius: 32, hot: true },
      ],
      novae: [{ x: 5, y: 6.25, radius: 20 }],
      repulsors: [{ x: 7, y: 8, radius: 48 }],
      aliens: [{ x: 9, y: 10 }],
      minerals: [{ x: 11, y: -0 }],
    };
    const { object, differences } = exported(file);
    expect(object).toEqual({
      player: { x: 10, y: 20, key: 'player' },
      target: { x: 30, y: 40, radius: 18, key: 'target' },
      asteroids: [
        { x: 1, y: 2, radius: 16, enemy: false, key: 'asteroid_32' },
        { x: 3, y: 4, radius: 32, enemy: true, key: 'thermoAsteroid_64' },
      ],
      novae: [{ x: 5, y: 6.25, radius: 20, key: 'nova_32' }],
      antiForceFields: [{ x: 7, y: 8, radius: 48, key: 'antiForceField_96' }],
      aliens: [{ x: 9, y: 10, key: 'alien' }],
      goodies: [{ x: 11, y: 0 }],
      maxDistance: 250,
    });
    expect(differences).toEqual([expect.stringContaining('nova 1 (20)')]);
  });

  test('says in sentences what it loses, and what the original game does otherwise', () => {
    const plain = exported(base);
    expect(plain).toMatchObject({ lost: ['a level object has no place for its name'], differences: [] });
    const { lost, differences } = exported({
      ...base,
      description: 'd',
      astronaut: { x: -1, y: 0, vx: 3 },
      aliens: [{ id: 'zz', x: 0, y: 0, radius: 24 }],
      runs: [{ name: 'r', holds: [] }],
      ...{ 'x-mine': 1 },
    });
    expect(lost).toEqual([
      'a level object has no place for its name, its description, its run, the ids of its objects, keys that begin with x-',
    ]);
    expect(differences).toEqual([
      expect.stringContaining('alien 1 (24)'),
      expect.stringMatching(/world of 1424 x 1624 px: astronaut$/),
      expect.stringContaining('at rest'),
    ]);
  });

  test('refuses by name and place everything that the original does not have, all at once', () => {
    const file: LevelFile = {
      ...base,
      recoil: false,
      rules: { pull: 40, push: 20 },
      winds: [
        { x: 0, y: 0, radius: 9 },
        { x: 1, y: 0, radius: 9 },
      ],
      wormholes: [{ x: 0, y: 0, toX: 1, toY: 1, radius: 9 }],
      conflicts: [{ what: 'the range', key: 'range', ours: 1, theirs: 2 }],
    };
    const { refused, object } = exported(file, { alienSight: 100 });
    const text = formatLevel(file).split('\n');
    expect(refused.map(({ pointer, message }) => [pointer, message.split(':')[0]])).toEqual([
      ['/recoil', 'recoil'],
      ['/conflicts', 'expected a level whose merge is finished, found 1 undecided in "conflicts"'],
      ['/rules/pull', 'the rule pull'],
      ['', 'the rule alienSight'],
      ['/winds/0', 'wind 1'],
      ['/winds/1', 'wind 2'],
      ['/wormholes/0', 'wormhole 1'],
    ]);
    expect(refused.every(({ code, hint }) => code === 'not-in-original' && /^[A-Z].*\.$/.test(hint))).toBe(true);
    for (const { pointer, line } of refused.slice(0, 3)) expect(text[(line ?? 0) - 1]).toContain(pointer.split('/')[1]);
    // what is left is a level without them
    expect(Object.keys(object)).toEqual(['player', 'target', 'asteroids', 'novae', 'goodies', 'maxDistance']);
  });
});

describe('the file', () => {
  const { object } = exported({ ...base, asteroids: [{ x: 1, y: 2, radius: 16 }] });

  test('is a CommonJS module with titles, and placeholders where a title has no level', () => {
    const text = formatOriginal(
      [
        { title: '', object: {} },
        { title: 'Level 1: "a"\u2028;evil()', object },
      ],
      'module',
    );
    const module = { exports: null as unknown };
    new Script(text).runInNewContext({ module });
    expect(JSON.parse(JSON.stringify(module.exports))).toEqual([{}, object]);
    expect(text).toContain('  // Level 1: "a" ;evil()\n');
    expect(imported(text)).toHaveLength(1);
  });

  test('has one object a line, and is the same for the same levels', () => {
    const text = formatOriginal([{ title: 'not in JSON', object }], 'json');
    expect(text).toContain('\n      { "x": 1, "y": 2, "radius": 16, "enemy": false, "key": "asteroid_32" }\n');
    expect(text).not.toContain('not in JSON');
    expect(JSON.parse(text)).toEqual([object]);
    expect(formatOriginal([], 'json')).toBe('[]\n');
  });

  test('as a module with code is refused with the way to JSON, at its place in the text', () => {
    const source = "'use strict'\n\nmodule.exports = [\n  // first\n  { player: 3 }\n]\n";
    const reading = importOriginal(new TextEncoder().encode(source), { recoil: true });
    if (reading.ok) throw new Error('was imported');
    expect(reading.text).toBe(source);
    expect(reading.problems[0]).toMatchObject({ line: 5, column: 5, hint: expect.stringContaining('JSON.stringify') });
  });
});
