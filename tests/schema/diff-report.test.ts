import { Ajv2020 } from 'ajv/dist/2020.js';
import { expect, it } from 'vitest';
import * as z from 'zod';
import { diffLevels } from '../../review/index.ts';
import { type DiffReport, diffReportSchema } from '../../schema/index.ts';

const schema = z.toJSONSchema(diffReportSchema, { target: 'draft-2020-12' });

it('accepts every kind of change, and nothing else', () => {
  const before = {
    version: 1,
    name: 'a',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 9, y: 0 },
    asteroids: [
      { id: 'aa', x: 1, y: 0, radius: 16 },
      { id: 'bb', x: 2, y: 0, radius: 16 },
    ],
    novae: [],
    'x-a': 1,
    'x-b': null,
  } as const;
  const after = {
    ...{ version: 1, name: 'b', astronaut: { x: 0, y: 0 }, blackHole: { x: 8, y: 0 }, rules: { pull: 40 } },
    asteroids: [{ id: 'cc', x: 5, y: 0, radius: 16 }, before.asteroids[1], { ...before.asteroids[0], x: 3 }],
    minerals: [{ x: 1, y: 1 }],
    'x-b': null,
    'x-a': 1,
  } as const;
  const changes = JSON.parse(JSON.stringify(diffLevels(before as never, after as never)));
  expect(new Set(changes.map(({ type }: { type: string }) => type))).toEqual(
    new Set(['value', 'changed', 'map', 'added', 'order', 'empty-list', 'keys']),
  );
  const report: DiffReport = {
    ...{ version: 1, before: 'a', after: 'b', rules: [{ rule: 'pull', before: null, after: 40 }], same: 0 },
    levels: [{ file: 'a.level.json', status: 'changed', words: ['a'], effects: [], before: null, after: null, changes }],
  };
  const isValid = new Ajv2020({ strict: false }).compile(schema);
  expect(isValid(report), JSON.stringify(isValid.errors)).toBe(true);
  expect(diffReportSchema.parse(report)).toEqual(report);
  expect(isValid({ ...report, more: 1 })).toBe(false);
  expect(isValid({ ...report, levels: [{ ...report.levels[0], changes: [{ type: 'nothing' }] }] })).toBe(false);
});
