import { describe, expect, test } from 'vitest';
import { CODES, importOriginal, readConfig, readLevel } from '../../schema/index.ts';
import { BASE } from './base-level.ts';
import { BAD_LEVELS } from './fixtures/bad-levels.ts';

const small = (list: string) => `{"version":1,"name":"a","astronaut":{"x":1,"y":2},"blackHole":{"x":1,"y":3},${list}}`;

describe('a file that is not a level', () => {
  test('the base of these cases is a valid level', () => {
    expect(readLevel(BASE).ok).toBe(true);
  });

  test.each(BAD_LEVELS)('$name', ({ source, problems }) => {
    const reading = readLevel(source);
    if (reading.ok) throw new Error('was read');
    const said = reading.problems.map((p) => [
      `${p.line === null ? '-' : `${p.line}:${p.column}`} ${p.code} ${p.pointer}`,
      p.message,
    ]);
    expect(said).toEqual(problems);
    for (const { hint, severity } of reading.problems) {
      expect(hint).toMatch(/^[A-Z].*\.$/);
      expect(severity).toBe('error');
    }
  });

  test('problems after the first 20 are only counted', () => {
    const reading = readLevel(small(`"novae":[${Array(33).fill('7').join()}]`));
    if (reading.ok) throw new Error('was read');
    expect(reading.problems).toHaveLength(21);
    expect(reading.problems[19].pointer).toBe('/novae/19');
    expect(reading.problems[20]).toMatchObject({ code: 'more-problems', message: 'and 13 more', line: null, column: null });
  });

  test('counting stops after 1000 problems', () => {
    const reading = readLevel(small(`"novae":[${Array(1100).fill('7').join()}]`));
    if (reading.ok) throw new Error('was read');
    expect(reading.problems[20].message).toBe('and at least 980 more');
  });

  test('a list is read to its last entry', () => {
    const reading = readLevel(small(`"novae":[${'{"x":1,"y":2,"radius":3},'.repeat(19_999)}{"x":1,"y":2,"radius":0}]`));
    if (reading.ok) throw new Error('was read');
    expect(reading.problems.map((p) => p.pointer)).toEqual(['/novae/19999/radius']);
  });

  test('a key of a megabyte is not repeated in the report', () => {
    const reading = readLevel(small(`"${'k'.repeat(1e6)}":1`));
    if (reading.ok) throw new Error('was read');
    expect(reading.problems).toHaveLength(1);
    expect(reading.problems[0]).toMatchObject({ code: 'unknown-key', pointer: '', line: 1, column: 77 });
    expect(JSON.stringify(reading.problems).length).toBeLessThan(1000);
  });

  test('every code has a case here, and every case has a code', () => {
    const given = new Set(BAD_LEVELS.flatMap(({ problems }) => problems.map(([place]) => place.split(' ')[1])));
    const nothing = importOriginal('[{}]', { recoil: true });
    if (nothing.ok) throw new Error('was imported');
    given.add(nothing.problems[0].code);
    given.add('more-problems');
    // their own tests have cases of these
    for (const code of ['not-in-original', 'unknown-class', 'wrong-shape', 'unpaired-mouth', 'unsupported-map']) given.add(code);
    // a file with conflicts can be read: tests/review has its cases
    given.add('merge-conflict');
    const config = readConfig('{ "accuracy": "exact", "levels": [] }');
    if (config.ok) throw new Error('was read');
    for (const { code } of config.problems) given.add(code);
    expect([...given].sort()).toEqual(CODES.map(({ code }) => code).sort());
  });

  test('no explanation is empty', () => {
    for (const { title, why, fix } of CODES) {
      expect(title).toMatch(/[^.]$/);
      expect(why).toMatch(/\.$/);
      expect(fix).toMatch(/\.$/);
    }
  });
});
