import { expect, it } from 'vitest';
import { compile, simulate, WorkBudget, workByEffect } from '../../engine/index.ts';
import { mixedScene } from '../scenes/mixed-scene.ts';
import { continuousNames } from './accuracies.ts';
import { plainLevel } from './plain-level.ts';

const HOLDS = [[10, 200]] as const;
const level = plainLevel({
  range: 300,
  astronaut: { x: 0, y: 0, vx: 20, vy: 0 },
  asteroids: [{ x: 150, y: 40, radius: 16 }],
  novae: [{ x: 1900, y: 900, radius: 16 }],
  minerals: [{ x: 30, y: 0, radius: 7 }],
});

it('adds up to the work of the run', () => {
  for (let seed = 0; seed < 15; seed++) {
    const scene = mixedScene(seed);
    for (const accuracy of continuousNames) {
      const compiled = compile(scene.level, accuracy);
      const run = simulate(compiled, scene.holds, { budget: new WorkBudget(2000) });
      const costs = workByEffect(compiled, scene.holds, new WorkBudget(2000)) ?? [];
      expect(costs.map(({ name }) => name)).toEqual(compiled.effects.simulated.map(({ name }) => name));
      const sum = (of: 'guards' | 'roots') => costs.reduce((all, cost) => all + cost[of], 0);
      expect([seed, accuracy, sum('guards'), sum('roots')]).toEqual([seed, accuracy, run.work.guards, run.work.roots]);
    }
  }
});

it('tells which effects cost something, and whose events happened', () => {
  const costs = workByEffect(compile(level), HOLDS) ?? [];
  const of = (name: string) => costs.find((cost) => cost.name === name);
  expect(of('minerals')).toMatchObject({ events: 1 });
  expect(of('novae')).toMatchObject({ roots: 0, events: 0 });
  expect(of('winds')).toBeUndefined();
});

it('says nothing of the frames of arcade', () => {
  expect(workByEffect(compile(level, 'arcade'), HOLDS)).toBeNull();
});
