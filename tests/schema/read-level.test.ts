import { describe, expect, test } from 'vitest';
import { NO_OBJECTS, readLevel } from '../../schema/index.ts';
import { BASE, broken } from './base-level.ts';

function read(source: string, options = {}) {
  const reading = readLevel(source, options);
  if (!reading.ok) throw new Error(JSON.stringify(reading.problems));
  return reading;
}

describe('reading a level', () => {
  test('fills in defaults', () => {
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

  test('gives the places of values', () => {
    const { document } = read(BASE);
    expect(document.locate('')).toEqual({ line: 1, column: 1 });
    expect(document.locate('/asteroids/1')).toEqual({ line: 9, column: 5 });
    expect(document.locate('/runs/0/holds/1')).toEqual({ line: 22, column: 9 });
    // an omitted value has the place of the surrounding object
    expect(document.locate('/minerals/0/radius')).toEqual({ line: 15, column: 5 });
  });

  test('keeps x- keys anywhere without reading them, and they are no part of the level', () => {
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

  test('reads holds that overlap or are out of order', () => {
    expect(read(broken('[12, 96]', '[180, 200]')).level.runs[0].holds).toEqual([
      [180, 200],
      [130, 188],
    ]);
  });

  test('ignores a byte order mark on request', () => {
    expect(read(`\ufeff${BASE}`, { byteOrderMark: 'skip' }).document.text).toBe(BASE);
  });

  test('reads Windows line ends', () => {
    const { level, document } = read(BASE.replaceAll('\n', '\r\n'));
    expect(level).toEqual(read(BASE).level);
    expect(document.locate('/asteroids/1')).toEqual({ line: 9, column: 5 });
  });

  test('reads -0 as 0', () => {
    const { level } = read(broken('"x": 712, "y": 600', '"x": -0, "y": -0.0, "vx": -0'));
    expect(level.astronaut).toEqual({ x: 0, y: 0, vx: 0, vy: 0 });
    const [mineral] = read(broken('"x": 715, "y": 730', '"x": -0, "y": -0')).level.minerals;
    expect([mineral.x, mineral.y]).toEqual([0, 0]);
  });
});
