import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { ACCURACIES, DEFAULT_MAX_TICKS } from '../../engine/index.ts';
import { quantile, referenceOf } from '../../engine/work-precision/index.ts';
import { compareWith } from '../judges/compare-with.ts';
import { pack } from '../levels/shipped-pack.ts';

// docs/accuracy.json, which docs/accuracy.md is held to, holds what the code gives: errors and outcomes are the same on every
// machine, and of costs only their order is said.
const measured = JSON.parse(readFileSync(new URL('../../docs/accuracy.json', import.meta.url), 'utf8'));
const runs = pack.flatMap(({ level }) =>
  level.runs.map(({ holds }) => ({ level, holds, reference: referenceOf(level, holds, DEFAULT_MAX_TICKS) })),
);

it('the reference of docs/accuracy.json is as exactly known as it says, for the runs that it says', () => {
  const { reference } = measured;
  expect(measured.runs).toBe(runs.length);
  expect(reference.method).toBe(runs[0].reference.method);
  expect(reference.doubts).toEqual([]);
  const known = runs.map((run) => run.reference.knownTo ?? Number.POSITIVE_INFINITY);
  expect(Math.max(...known)).toBeCloseTo(reference.knownTo.worst, 30);
  expect(Math.max(...known)).toBeLessThan(1e-24);
});

it.each(Object.values(ACCURACIES))('docs/accuracy.json has the errors and outcomes of $name', (accuracy) => {
  const deviations = runs.map(({ level, holds, reference }) => compareWith(reference, level, holds, accuracy, DEFAULT_MAX_TICKS));
  const errors = deviations.map(({ error }) => error);
  const said = measured.methods.find(({ name }: { readonly name: string }) => name === accuracy.name);
  for (const [figure, p] of [
    ['median', 0.5],
    ['p90', 0.9],
    ['worst', 1],
  ] as const) {
    expect(quantile(errors, p) / said.error[figure], figure).toBeCloseTo(1, 6);
  }
  expect(deviations.filter(({ sameVerdict }) => !sameVerdict)).toHaveLength(said.otherOutcomes);
});

it('of docs/accuracy.json, arcade is the cheapest, and precise cheaper than what is less exact and finds every contact', () => {
  const cost = (name: string): number => measured.methods.find((one: { readonly name: string }) => one.name === name).cost;
  expect(cost('arcade')).toBeLessThan(cost('precise'));
  expect(cost('precise')).toBeLessThan(cost('fast'));
  expect(cost('fast')).toBeLessThan(cost('standard'));
});
