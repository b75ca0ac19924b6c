import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { codeFrame, formatLevel, importOriginal, type Level, readLevel } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { arbitraryFile } from './arbitrary-file.ts';
import { BASE } from './base-level.ts';
import { apply, edit } from './edits.ts';

function expectFinite(level: Level): void {
  const numbers = [level.range, ...Object.values(level.astronaut), ...Object.values(level.blackHole)];
  for (const list of [level.asteroids, level.novae, level.repulsors, level.aliens, level.minerals]) {
    for (const { x, y, radius } of list) {
      numbers.push(x, y, radius);
      expect(radius).toBeGreaterThan(0);
    }
  }
  for (const [press, release] of level.runs.flatMap(({ holds }) => holds)) {
    numbers.push(press, release);
    expect(release).toBeGreaterThan(press);
  }
  for (const number of numbers) expect(Number.isFinite(number) && !Object.is(number, -0)).toBe(true);
}

function expectPlaces(problems: readonly { line: number | null; column: number | null; message: string }[], text: string): void {
  expect(problems.length).toBeGreaterThan(0);
  expect(problems.length).toBeLessThanOrEqual(21);
  const lines = text.split('\n');
  for (const { line, column, message } of problems) {
    expect(message).not.toMatch(/undefined|\[object/);
    if (line === null || column === null) continue;
    expect(line).toBeGreaterThanOrEqual(1);
    expect(line).toBeLessThanOrEqual(lines.length);
    expect(column).toBeGreaterThanOrEqual(1);
    expect(column).toBeLessThanOrEqual(lines[line - 1].length + 1);
    expect(codeFrame(text, line, column)).toContain('^');
  }
}

describe('a mutated level', () => {
  test('is read with finite numbers, or refused with places within the text', () => {
    const seen = { read: 0, refused: 0 };
    const text = fc.oneof(fc.constant(BASE), arbitraryFile.map(formatLevel));
    fc.assert(
      fc.property(text, fc.array(edit, { minLength: 1, maxLength: 3 }), fc.boolean(), (original, edits, asBytes) => {
        const source = edits.reduce(apply, original);
        const reading = readLevel(asBytes ? new TextEncoder().encode(source) : source);
        if (reading.ok) {
          seen.read++;
          expectFinite(reading.level);
          const again = readLevel(formatLevel(reading.document.file));
          expect(again).toMatchObject({ ok: true, level: reading.level });
        } else {
          seen.refused++;
          expectPlaces(reading.problems, reading.text);
        }
      }),
      { numRuns: 600 },
    );
    // otherwise one half of the property would be trivial
    expectDeep(seen.read).toBeGreaterThan(20);
    expectDeep(seen.refused).toBeGreaterThan(200);
  });

  test('is treated in the same way with mutated bytes', () => {
    const bytes = new TextEncoder().encode(BASE);
    fc.assert(
      fc.property(fc.array(fc.tuple(fc.nat(bytes.length - 1), fc.nat(255)), { minLength: 1, maxLength: 4 }), (changes) => {
        const source = bytes.slice();
        for (const [at, byte] of changes) source[at] = byte;
        const reading = readLevel(source);
        if (reading.ok) expectFinite(reading.level);
        else expectPlaces(reading.problems, reading.text);
      }),
      { numRuns: 400 },
    );
  });

  test('any JSON is either read or refused', () => {
    fc.assert(
      fc.property(fc.json({ maxDepth: 5 }), (source) => {
        for (const reading of [readLevel(source), importOriginal(source, { recoil: true })]) {
          if (!reading.ok) expectPlaces(reading.problems, reading.text);
        }
      }),
      { numRuns: 200 },
    );
  });
});
