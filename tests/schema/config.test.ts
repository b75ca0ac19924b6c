import { Ajv2020 } from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';
import { ACCURACIES } from '../../engine/index.ts';
import {
  ACCURACY_NAMES,
  ADJUSTABLE_CODES,
  CODES,
  type ConfigFile,
  configJsonSchema,
  configSchema,
  formatConfigJsonSchema,
  REPORTER_NAMES,
  RULE_NAMES,
  RULES,
  readConfig,
  SEVERITIES,
} from '../../schema/index.ts';
import * as fc from '../fast-check.ts';

const path = fc.string({ minLength: 1, maxLength: 12 });
const rules = fc.record(
  Object.fromEntries(RULE_NAMES.map((name) => [name, fc.double({ min: RULES[name].least, max: RULES[name].most, noNaN: true })])),
  { requiredKeys: [] },
);
const severity = fc.dictionary(fc.constantFrom(...ADJUSTABLE_CODES), fc.constantFrom(...SEVERITIES));
const reporter = fc
  .tuple(fc.constantFrom(...REPORTER_NAMES), fc.option(path, { nil: null }))
  .map(([name, file]) => (file === null ? name : `${name}=${file}`));

const config = fc.record(
  {
    $schema: fc.string(),
    levels: fc.oneof(path, fc.array(path, { minLength: 1, maxLength: 3 })),
    ignore: fc.oneof(path, fc.array(path, { maxLength: 3 })),
    accuracy: fc.constantFrom(...ACCURACY_NAMES),
    maxTime: fc.oneof(fc.integer({ min: 1, max: 3600 }), fc.constant(0.01)),
    maxWork: fc.integer({ min: 1, max: 1e9 }),
    requireSlack: fc.nat(60),
    severity,
    maxWarnings: fc.nat(1_000_000),
    reporters: fc.array(reporter, { minLength: 1, maxLength: 3 }),
    lock: path,
    cache: fc.oneof(fc.boolean(), path),
    rules,
  },
  { requiredKeys: [] },
);

const says = (text: string): readonly string[] => {
  const read = readConfig(text);
  return read.ok ? [] : read.problems.map(({ line, column, code }) => `${line}:${column} ${code}`);
};

const accepts = new Ajv2020({ strict: false }).compile(configJsonSchema());

describe('a configuration', () => {
  it('names the accuracies of the engine', () => {
    expect([...ACCURACY_NAMES].sort()).toEqual(Object.keys(ACCURACIES).sort());
  });

  it('is read as it was written; reader, zod schema and JSON Schema accept it', () => {
    fc.assert(
      fc.property(config, (written) => {
        const text = JSON.stringify({ ...written, 'x-own': { any: [1] } }, null, 2);
        expect(readConfig(text)).toEqual({ ok: true, config: JSON.parse(JSON.stringify(written)) });
        expect(configSchema.safeParse(written).success).toBe(true);
        expect(accepts(JSON.parse(text))).toBe(true);
      }),
    );
  });

  it('has one problem where a value is of another type, and all three refuse it', () => {
    const wrong = fc.constantFrom(null, -1, 1.5, {}, [[]], '', [3]);
    const keys = Object.keys(configSchema.shape).filter((key) => key !== '$schema' && key !== 'severity' && key !== 'rules');
    fc.assert(
      fc.property(fc.constantFrom(...keys), wrong, (key, value) => {
        const file = { [key]: value };
        const isFine = configSchema.safeParse(file).success;
        const found = says(JSON.stringify(file));
        expect(found.length === 0, JSON.stringify(file)).toBe(isFine);
        expect(accepts(file), JSON.stringify(file)).toBe(isFine);
        expect(found.length).toBeLessThanOrEqual(1);
      }),
    );
  });

  it('never crashes on mutated bytes, and then says where', () => {
    const whole: ConfigFile = {
      levels: ['levels'],
      ignore: ['drafts'],
      accuracy: 'fast',
      severity: { overlapping: 'off' },
      rules: { pull: 40 },
    };
    const bytes = new TextEncoder().encode(JSON.stringify(whole, null, 2));
    fc.assert(
      fc.property(fc.nat(bytes.length - 1), fc.nat(255), fc.nat(3), (at, byte, cut) => {
        const mutated = Uint8Array.from([...bytes.slice(0, at), byte, ...bytes.slice(at + cut)]);
        const read = readConfig(mutated);
        if (read.ok) return;
        expect(read.problems.length).toBeGreaterThan(0);
        for (const { code, line, hint, message } of read.problems) {
          expect(CODES.map((known) => known.code)).toContain(code);
          expect([message.length > 0, hint.length > 0]).toEqual([true, true]);
          // bytes of another kind of file have no lines
          if (code !== 'not-a-level') expect(line).not.toBeNull();
        }
      }),
    );
  });

  it.each<[string, string, string, string]>([
    ['{ "levls": "a" }', '1:3 unknown-key', 'did you mean "levels"?', 'Write "levels"'],
    ['{ "levels": 3 }', '1:13 wrong-type', 'expected a path in double quotes, or a list of them', 'Write'],
    ['{ "levels": [] }', '1:13 empty-list', 'found an empty list', 'Add an entry'],
    ['{ "ignore": [""] }', '1:14 empty-text', 'expected a pattern', 'Write a pattern'],
    ['{ "accuracy": "presice" }', '1:15 unknown-value', 'did you mean "precise"?', 'Write "precise"'],
    ['{ "maxTime": 0 }', '1:14 out-of-limits', 'at least 0.01', 'at least 0.01'],
    ['{ "maxTime": "60" }', '1:14 wrong-type', 'expected a number', 'Remove the quotes'],
    ['{ "maxWork": 1.5 }', '1:14 not-whole', 'expected a whole number', 'Write 2'],
    ['{ "maxtime": 60 }', '1:3 unknown-key', 'did you mean "maxTime"?', 'Write "maxTime"'],
    ['{ "requireSlack": 61 }', '1:19 out-of-limits', 'at most 60', 'at most 60'],
    ['{ "maxWarnings": "3" }', '1:18 wrong-type', 'expected a number', 'Remove the quotes'],
    ['{ "severity": [] }', '1:15 wrong-type', 'expected an object', 'Write'],
    ['{ "severity": { "overlaping": "off" } }', '1:17 unknown-code', 'did you mean "overlapping"?', 'Write "overlapping"'],
    ['{ "severity": { "no-run": "off" } }', '1:17 fixed-severity', 'always an error', '"ignore"'],
    ['{ "severity": { "unknown-key": "warning" } }', '1:17 fixed-severity', 'always an error', 'Remove it'],
    ['{ "severity": { "overlapping": "warn" } }', '1:32 unknown-value', 'did you mean "warning"?', 'Write "warning"'],
    ['{ "severity": { "overlapping": 1 } }', '1:32 unknown-value', 'found the number 1', 'Write "error"'],
    ['{ "reporters": ["junitt"] }', '1:17 unknown-value', 'did you mean "junit"?', 'Write "junit"'],
    ['{ "reporters": ["junit="] }', '1:17 unknown-value', 'expected NAME=FILE', 'after the ='],
    ['{ "rules": { "pul": 3 } }', '1:14 unknown-key', 'did you mean "pull"?', 'Write "pull"'],
    ['{ "cache": 3 }', '1:12 wrong-type', 'expected true, false, or a directory', 'Write'],
  ])('%s is refused at %s', (text, place, message, hint) => {
    const read = readConfig(text);
    if (read.ok) throw new Error('was read');
    expect(says(text)).toEqual([place]);
    expect(read.problems[0].message).toContain(message);
    expect(read.problems[0].hint).toContain(hint);
    expect(accepts(JSON.parse(text))).toBe(false);
  });

  it('gives its rules where only other keys are wrong', () => {
    expect(readConfig('{ "levls": 1, "rules": { "pull": 50 } }')).toMatchObject({ ok: false, rules: { pull: 50 } });
    expect(readConfig('{ "levls": 1, "rules": { "pull": "50" } }')).toMatchObject({ ok: false, rules: null });
    expect(readConfig('[]')).toMatchObject({ ok: false, rules: null });
  });

  it('may begin with a byte order mark, as some programs write it', () => {
    expect(readConfig(new TextEncoder().encode('\ufeff{ "accuracy": "fast" }'))).toEqual({
      ok: true,
      config: { accuracy: 'fast' },
    });
  });
});

describe('the JSON Schema of a configuration', () => {
  it('is the committed file (updated by vitest -u)', async () => {
    await expect(formatConfigJsonSchema()).toMatchFileSnapshot('../../schema/config.schema.json');
  });

  it('completes the codes whose severity can be set, and their severities', () => {
    const { properties } = configJsonSchema() as { properties: { severity: { properties: Record<string, { enum: string[] }> } } };
    const codes = properties.severity.properties;
    expect(Object.keys(codes)).toEqual([...ADJUSTABLE_CODES]);
    for (const code of Object.values(codes)) expect(code.enum).toEqual(['error', 'warning', 'off']);
  });
});
