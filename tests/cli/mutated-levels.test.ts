import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, expect, it } from 'vitest';
import { checkLevel, checkTogether, type GivenFile } from '../../cli/check/check-level.ts';
import { checkJson } from '../../cli/reporters/json.ts';
import { checkPretty } from '../../cli/reporters/pretty.ts';
import { ACCURACIES, DEFAULT_TERMS } from '../../engine/index.ts';
import { checkReportSchema } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { fallThrough, makeFiles } from './gq.ts';
import { CONTEXT, resultsOf } from './reporters/context.ts';

const SETTINGS = { terms: DEFAULT_TERMS, inFull: true, proveMinerals: true, search: null, requireSlack: null } as const;

const base = fallThrough({
  recoil: true,
  range: 250,
  novae: [{ x: 0, y: 90, radius: 16 }],
  repulsors: [{ x: 60, y: 0, radius: 32 }],
  aliens: [
    { x: 0, y: -140, radius: 25 },
    { x: 40, y: -140 },
  ],
  minerals: [{ x: 50, y: 0 }],
  runs: [
    { name: 'hold', holds: [[0, 600]] },
    {
      name: 'taps',
      holds: [
        [5, 9],
        [20, 40],
      ],
    },
  ],
});

const { directory, remove } = makeFiles({});
afterAll(remove);
const file = join(directory, 'mutated.level.json');

const withoutTimes = (reports: unknown): string => JSON.stringify(reports).replace(/(\\?"ms\\?":)[\d.e-]+/g, '$1');

const weird = fc.oneof(
  fc.constantFrom('1e999', '-0', 'NaN', '1e308', '5e-324', '-1', '0', '""', 'null', '[]', '{}', '[0,1]', '1000000000', '0.1'),
  fc.double({ noNaN: true, noDefaultInfinity: true, min: -300, max: 300 }).map(String),
  fc.json({ maxDepth: 2 }),
);

type Mutation = { kind: 'number' | 'cut' | 'insert' | 'key'; at: number; with: string; length: number };
const mutation: fc.Arbitrary<Mutation> = fc.record({
  // most mutations keep the syntax valid, so that they test more than the JSON reader
  kind: fc.constantFrom('number', 'number', 'number', 'number', 'cut', 'insert', 'key'),
  at: fc.nat(1_000_000),
  with: weird,
  length: fc.nat(8),
});

function mutate(text: string, { kind, at, with: value, length }: Mutation): string {
  const pick = (pattern: RegExp) => {
    const all = [...text.matchAll(pattern)];
    return all[at % all.length];
  };
  const place = at % (text.length + 1);
  if (kind === 'cut') return text.slice(0, place) + text.slice(place + length);
  if (kind === 'insert') return text.slice(0, place) + value + text.slice(place);
  const match = kind === 'number' ? pick(/-?\d+(\.\d+)?/g) : pick(/"\w+"/g);
  if (match === undefined) return text;
  return text.slice(0, match.index) + value + text.slice(match.index + match[0].length);
}

it.each([ACCURACIES.arcade, ACCURACIES.precise])(
  'any mutated level file gets a verdict with finite numbers: $name',
  (accuracy) => {
    const seen = new Set<string>();
    fc.assert(
      fc.property(fc.array(mutation, { minLength: 1, maxLength: 3 }), (mutations) => {
        writeFileSync(file, mutations.reduce(mutate, base));
        const checked = checkLevel(file, { ...SETTINGS, terms: { ...SETTINGS.terms, accuracy } });
        expect(checked.verdict).not.toBe('crashed');
        seen.add(checked.verdict);
        // a number that is not finite becomes null in JSON, which the schema refuses
        const report = checkReportSchema.parse(JSON.parse(checkJson(resultsOf([checked]), CONTEXT)));
        expect(report.levels[0].problems.length > 0 || checked.verdict === 'completable').toBe(true);
        expect(checkPretty(resultsOf([checked]), CONTEXT)).toContain(checked.verdict);
      }),
      { numRuns: 200 },
    );
    // some mutations get past the reader
    expectDeep([...seen].sort()).toEqual(['broken', 'completable', 'impossible', 'invalid']);
  },
);

it('files that are checked together get the reports that each of them gets alone', () => {
  const files = fc.array(fc.array(mutation, { maxLength: 2 }), { minLength: 1, maxLength: 40 });
  fc.assert(
    fc.property(files, (all) => {
      const given = all.map((mutations, i) => ({
        file: `${i}.level.json`,
        content: Buffer.from(mutations.reduce(mutate, base)),
      }));
      // one that is not there, and one that is too large to wait for others between its steps
      const others = [
        { file: join(directory, 'none.level.json') },
        { file: 'large', content: Buffer.from(base + ' '.repeat(70_000)) },
      ];
      const together = checkTogether([...given, ...others], SETTINGS, 'key');
      const alone = [...given, ...others].map(
        ({ file: name, content }: GivenFile) => checkTogether([{ file: name, content }], SETTINGS, 'key')[0],
      );
      expect(withoutTimes(together)).toBe(withoutTimes(alone));
    }),
    { numRuns: 40 },
  );
});

it('any bytes get a verdict', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 200 }), (bytes) => {
      writeFileSync(file, bytes);
      expect(checkLevel(file, SETTINGS).verdict).toBe('invalid');
    }),
    { numRuns: 200 },
  );
});
