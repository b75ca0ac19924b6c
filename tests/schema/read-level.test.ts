import { describe, expect, test } from 'vitest';
import { NO_OBJECTS, readLevel } from '../../schema/index.ts';
import { BASE, broken } from './base-level.ts';

function read(source: string, options = {}) {
  const reading = readLevel(source, options);
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return reading;
}

describe('reading a level', () => {
  test('fills in what is left out', () => {
    const { level } = read(
      '{"version":1,"name":"a","astronaut":{"x":1,"y":2},"blackHole":{"x":3,"y":4},"aliens":[{"x":5,"y":6}]}',
    );
    expect(level).toEqual({
      ...NO_OBJECTS,
      name: 'a',
      description: '',
      astronaut: { x: 1, y: 2, vx: 0, vy: 0 },
      blackHole: { x: 3, y: 4, radius: 18 },
      range: 250,
      recoil: false,
      asteroids: [],
      novae: [],
      repulsors: [],
      aliens: [{ id: null, x: 5, y: 6, radius: 25 }],
      minerals: [],
      runs: [],
    });
  });

  test('tells where things stand', () => {
    const { document } = read(BASE);
    expect(document.locate('')).toEqual({ line: 1, column: 1 });
    expect(document.locate('/asteroids/1')).toEqual({ line: 9, column: 5 });
    expect(document.locate('/runs/0/holds/1')).toEqual({ line: 22, column: 9 });
    // what the level leaves out is nowhere: the object that could have it is the place
    expect(document.locate('/minerals/0/radius')).toEqual({ line: 15, column: 5 });
  });

  test('keys of one’s own are kept anywhere, not looked into, and no part of the level', () => {
    const own = '"x-a": { "y": [1], "x-b": null }, ';
    let source = BASE;
    for (const part of ['"version"', '"x": 712', '"x": 708, "y": 826', '"id": "k3x9qa"', '"name": "first"']) {
      source = source.replace(part, () => own + part);
    }
    const { level, document } = read(source);
    expect(level).toEqual(read(BASE).level);
    const { file } = document;
    const value = { y: [1], 'x-b': null };
    for (const owner of [file, file.astronaut, file.blackHole, file.asteroids?.[0], file.runs?.[0]]) {
      expect(owner).toHaveProperty('x-a', value);
    }
  });

  test('holds that overlap or stand out of order are read', () => {
    expect(read(broken('[12, 96]', '[180, 200]')).level.runs[0].holds).toEqual([
      [180, 200],
      [130, 188],
    ]);
  });

  test('a byte order mark is passed over when asked', () => {
    expect(read(`\ufeff${BASE}`, { byteOrderMark: 'skip' }).document.text).toBe(BASE);
  });

  test('Windows line ends are read', () => {
    const { level, document } = read(BASE.replaceAll('\n', '\r\n'));
    expect(level).toEqual(read(BASE).level);
    expect(document.locate('/asteroids/1')).toEqual({ line: 9, column: 5 });
  });

  test('-0 is 0', () => {
    const { level } = read(broken('"x": 712, "y": 600', '"x": -0, "y": -0.0, "vx": -0'));
    expect(level.astronaut).toEqual({ x: 0, y: 0, vx: 0, vy: 0 });
    const [mineral] = read(broken('"x": 715, "y": 730', '"x": -0, "y": -0')).level.minerals;
    expect([mineral.x, mineral.y]).toEqual([0, 0]);
  });
});
