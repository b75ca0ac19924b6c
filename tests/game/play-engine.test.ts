import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { ENGINE_ID, PINNED_RESULTS } from '../../game/play/engine-id.ts';
import { nextEngineId, pinnedResults, withIdentity } from '../browsers/engine-identity.ts';
import { committedTable } from '../browsers/hash-table.ts';

it('the identity of the engine belongs to the pinned results (npm run hashes writes both)', () => {
  expect(PINNED_RESULTS).toBe(pinnedResults(committedTable()));
  expect(ENGINE_ID).toMatch(/^[0-9a-f]{16}$/);
});

it('is another one when a result changes or goes, and stays when results are added', () => {
  const before = { a: { fast: '1', precise: '2' }, b: { fast: '3' } };
  const id = pinnedResults(before);
  expect(nextEngineId(id, before, before)).toBe(id);
  expect(nextEngineId(id, before, { ...before, c: { fast: '9' } })).toBe(id);
  expect(nextEngineId(id, before, { a: { ...before.a, arcade: '7' }, b: before.b })).toBe(id);
  for (const after of [{ a: before.a }, { ...before, b: { fast: '4' } }, { a: { fast: '1' }, b: before.b }]) {
    expect(nextEngineId(id, before, after as typeof before)).toBe(pinnedResults(after as typeof before));
    expect(pinnedResults(after as typeof before)).not.toBe(id);
  }
  const withLevel = { ...before, '01-one.level.json: solution': { fast: '5' } };
  expect(nextEngineId(id, withLevel, { ...before, '01-one.level.json: solution': { fast: '6' } })).toBe(id);
  expect(nextEngineId(id, withLevel, before)).toBe(id);
  expect(nextEngineId(id, {}, before)).toBe(id);
  expect(nextEngineId('0', {}, before)).toBe(id);
});

it('is written into its file', () => {
  const source = readFileSync(new URL('../../game/play/engine-id.ts', import.meta.url), 'utf8');
  expect(withIdentity(source, ENGINE_ID, PINNED_RESULTS)).toBe(source);
  const written = withIdentity(source, '0123456789abcdef', 'fedcba9876543210');
  expect(written).toContain("ENGINE_ID = '0123456789abcdef'");
  expect(written).toContain("PINNED_RESULTS = 'fedcba9876543210'");
});
