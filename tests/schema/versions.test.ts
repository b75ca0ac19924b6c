import { describe, expect, test } from 'vitest';
import { type JsonObject, type Migration, readLevel } from '../../schema/index.ts';
import { BASE, broken } from './base-level.ts';

/** A made-up version 0, which called the black hole "hole". */
const renamed: Migration = {
  from: 0,
  what: '"hole" is called "blackHole"',
  apply: ({ hole, ...rest }: JsonObject) => ({ ...rest, blackHole: hole }),
};

const OLD = broken('"version": 1', '"version": 0').replace('"blackHole"', '"hole"');

describe('versions of the format', () => {
  test('an older one is migrated, and the document names the version', () => {
    const reading = readLevel(OLD, { migrations: [renamed] });
    const current = readLevel(BASE);
    if (!reading.ok || !current.ok) throw new Error('was refused');
    expect(reading.level).toEqual(current.level);
    expect(reading.document.file).toEqual(current.document.file);
    expect(reading.document.migratedFrom).toBe(0);
    expect(reading.document.text).toBe(OLD);
    expect(current.document.migratedFrom).toBeNull();
  });

  test('x- keys survive the migration', () => {
    const reading = readLevel(OLD.replace('"range"', '"x-a": [1], "range"'), { migrations: [renamed] });
    expect(reading).toMatchObject({ ok: true, document: { file: { 'x-a': [1] } } });
  });

  test('problems of a migrated file have places in the original text, at the nearest existing value', () => {
    const reading = readLevel(OLD.replace('"radius": 18', '"radius": 0'), { migrations: [renamed] });
    expect(reading).toMatchObject({
      ok: false,
      problems: [{ code: 'out-of-limits', pointer: '/blackHole/radius', line: 1, column: 1 }],
    });
    const elsewhere = readLevel(OLD.replace('712', '"712"'), { migrations: [renamed] });
    expect(elsewhere).toMatchObject({
      ok: false,
      problems: [{ code: 'wrong-type', pointer: '/astronaut/x', line: 4, column: 23 }],
    });
  });

  test('an older one without a chain of migrations is refused with one problem', () => {
    const reading = readLevel(OLD);
    expect(reading).toMatchObject({ ok: false, problems: [{ code: 'unsupported-version' }] });
    if (!reading.ok) expect(reading.problems).toHaveLength(1);
  });

  test.each(['-1', '0.5', '"0"', 'null', '{}', '1e300'])('version %s is refused with one problem', (version) => {
    const reading = readLevel(broken('"version": 1', `"version": ${version}`), { migrations: [renamed] });
    if (reading.ok) throw new Error('was read');
    expect(reading.problems).toHaveLength(1);
    expect(reading.problems[0]).toMatchObject({ pointer: '/version', line: 2, column: 14 });
  });
});
