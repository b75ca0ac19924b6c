import { Ajv2020 } from 'ajv/dist/2020.js';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { formatLock, formatLockJsonSchema, type Lock, type LockEntry, lockJsonSchema, readLock } from '../../schema/index.ts';
import { arbitraryRules } from '../engine/arbitrary-rules.ts';

const count = fc.integer({ min: 0, max: 5000 });
const entry: fc.Arbitrary<LockEntry> = fc.record(
  {
    verdict: fc.constantFrom('completable', 'broken', 'unproven', 'impossible', 'invalid'),
    accuracy: fc.constantFrom('precise', 'arcade', 'rk4 120 Hz, frame'),
    outcome: fc.constantFrom('completed', 'collided', 'lost', 'timeout'),
    tick: count,
    minerals: count,
    mineralCount: count,
    certifiedTicks: count,
    rules: arbitraryRules,
    hash: fc.constantFrom('8512d5b25c672eeb', '0'),
  },
  { requiredKeys: ['verdict', 'accuracy'] },
);
// names that JSON, pointers and objects treat in a special way
const path = fc.oneof(
  fc.constantFrom('levels/a.level.json', 'a/b~c/d"e\\.json', '10', '2', 'Å — ü.level.json', 'toString', '../x\n.json'),
  fc.string({ minLength: 1, unit: 'grapheme' }).filter((text) => text !== '__proto__'),
);
const lock: fc.Arbitrary<Lock> = fc.record({
  version: fc.constant(1 as const),
  levels: fc.dictionary(path, entry, { noNullPrototype: true }),
});

const problemsOf = (text: string) => {
  const read = readLock(text);
  if (read.ok) throw new Error('expected problems');
  return read.problems.map(({ code, line, column, message }) => `${line}:${column} ${code} ${message}`);
};

describe('a lock file', () => {
  test('is read as it was written, in one canonical layout with a line for each level', () => {
    const validate = new Ajv2020({ strict: false }).compile(lockJsonSchema());
    fc.assert(
      fc.property(lock, (value) => {
        const text = formatLock(value);
        const read = readLock(text);
        if (!read.ok) throw new Error(JSON.stringify(read.problems));
        expect(read.lock).toEqual(value);
        expect(formatLock(read.lock)).toBe(text);
        expect(validate(JSON.parse(text)), JSON.stringify(validate.errors)).toBe(true);
        const lines = text.split('\n');
        const names = Object.keys(value.levels);
        expect(lines.filter((line) => line.startsWith('    "'))).toHaveLength(names.length);
        for (const name of names) expect(lines[read.lineOf(name) - 1].startsWith(`    ${JSON.stringify(name)}: {`)).toBe(true);
      }),
    );
  });

  test('changes in one line when one level changes', () => {
    const other: LockEntry = { verdict: 'broken', accuracy: 'fast', tick: 5001 };
    fc.assert(
      fc.property(lock, fc.nat(), (value, at) => {
        const names = Object.keys(value.levels);
        if (names.length === 0) return;
        const changed = { ...value, levels: { ...value.levels, [names[at % names.length]]: other } };
        const [before, after] = [value, changed].map((one) => formatLock(one).split('\n'));
        expect(after).toHaveLength(before.length);
        expect(after.filter((line, i) => line !== before[i])).toHaveLength(1);
      }),
    );
  });

  test('has a JSON Schema, which is the committed file (updated by vitest -u)', async () => {
    await expect(formatLockJsonSchema()).toMatchFileSnapshot('../../schema/lock.schema.json');
  });

  test.each([
    ['', /^1:1 empty-file/],
    ['[]', /^1:1 wrong-type expected a lock \(an object in \{ \}\), found an empty list$/],
    ['{"levels": {}}', /^1:1 missing-version the key "version" is missing$/],
    ['{"version": 1}', /^1:1 missing-key the key "levels" is missing$/],
    [
      '{"version": 9, "levels": {}}',
      /^1:13 newer-version version: this lock has version 9 of the format; this toolkit reads version 1$/,
    ],
    ['{"version": "1", "levels": {}}', /^1:13 unsupported-version version: expected 1, found the text "1"$/],
    ['{"version": 1, "levels": {},\n "level": 2}', /^2:2 unknown-key unknown key "level": did you mean "levels"\?$/],
    ['{"version": 1, "levels": {"a": 3}}', /^1:32 wrong-type a: expected an object in \{ \}, found the number 3$/],
    [
      '{"version": 1, "levels": {"a": {\n"verdict": "completeable", "accuracy": "precise"}}}',
      /^2:12 wrong-type .*expected one of "completable", .*, found the text "completeable"$/,
    ],
    ['{"version": 1, "levels": {"a": {"verdict": "broken"}}}', /^1:32 missing-key .*the key "accuracy" is missing$/],
    ['{"version": 1, "levels": {"a": {"verdict": "broken", "accuracy": "fast", "tik": 2}}}', /unknown-key .*did you mean "tick"/],
    ['{"version": 1, "levels": {"a": {"verdict": "broken", "accuracy": "fast", "tick": 2.5}}}', /not-whole .*found 2.5$/],
    [
      '{"version": 1, "levels": {"a": {"verdict": "broken", "accuracy": "fast", "tick": -1}}}',
      /out-of-limits .*at least 0, found -1$/,
    ],
    ['{"version": 1, "levels": {"a": {"verdict": "broken", "accuracy": "", "tick": 1}}}', /empty-text/],
    ['{"version": 1, "levels": {"a": {"verdict": "broken", "accuracy": "fast", "rules": {"pul": 1}}}}', /did you mean "pull"/],
    ['{\n"version": 1,\n<<<<<<< ours\n"levels": {}', /^3:1 /],
    [
      '{"version": 1, "levels": {\n"a": {"verdict": "broken", "accuracy": "fast"},\n"a": {"verdict": "broken", "accuracy": "fast"}}}',
      /^3:1 /,
    ],
  ])('is refused with the place: %j', (text, expected) => {
    const problems = problemsOf(text);
    expect(problems).toHaveLength(1);
    expect(problems[0]).toMatch(expected);
  });

  test('never throws, and refuses what the JSON Schema refuses', () => {
    const validate = new Ajv2020({ strict: false }).compile(lockJsonSchema());
    fc.assert(
      fc.property(lock, fc.jsonValue(), fc.nat(), (value, junk, at) => {
        const text = formatLock(value);
        const numbers = [...text.matchAll(/"[a-zA-Z]+": (\d[\d.e+-]*)/g)];
        const found = numbers[at % numbers.length];
        const end = found.index + found[0].length;
        const mutated = text.slice(0, end - found[1].length) + JSON.stringify(junk) + text.slice(end);
        expect(readLock(mutated).ok).toBe(validate(JSON.parse(mutated)));
      }),
    );
  });
});
