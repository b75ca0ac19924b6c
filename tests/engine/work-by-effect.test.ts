import { expect, it, vi } from 'vitest';
import { ContinuousSimulation, methodWith } from '../../engine/continuous/index.ts';
import { compile, simulate, WorkBudget, WorkLimitReached, workByEffect } from '../../engine/index.ts';
import { joinHolds, playScript } from '../../engine/script.ts';
import { lookedFor, timeByEffect } from '../../engine/work-precision/cost.ts';
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
  expect(timeByEffect(compile(level, 'arcade'), HOLDS, () => 0, { budget: 1, most: 1, sample: 1 })).toBeNull();
});

it('changes nothing by looking for the same again, so what that takes is the cost of an effect', () => {
  let played = 0;
  for (let seed = 0; seed < 40; seed++) {
    const scene = mixedScene(seed);
    for (const accuracy of continuousNames) {
      const play = (times: number) => {
        const method = methodWith((effect) => lookedFor(effect, times));
        const simulation = new ContinuousSimulation(method, compile(scene.level, accuracy), null, new WorkBudget(20_000));
        playScript(simulation, joinHolds(scene.holds), 600);
        return [...simulation.snapshot()];
      };
      try {
        expect(play(3)).toEqual(play(1));
        played++;
      } catch (error) {
        if (!(error instanceof WorkLimitReached)) throw error;
      }
    }
  }
  expect(played).toBeGreaterThan(60);
});

it('times each effect: by a clock that counts square roots', () => {
  let roots = 0;
  const { sqrt } = Math;
  const spy = vi.spyOn(Math, 'sqrt').mockImplementation((x) => {
    roots++;
    return sqrt(x);
  });
  const timed = (novae: readonly object[]) => {
    const scene = compile(plainLevel({ ...level, novae } as Parameters<typeof plainLevel>[0]));
    const measured = timeByEffect(scene, HOLDS, () => roots / 1000, { budget: 20, most: 1000, sample: 1 });
    expect(measured?.effects.map(({ name }) => name)).toEqual(scene.effects.simulated.map(({ name }) => name));
    return measured ?? { whole: { minimum: 0 }, effects: [] };
  };
  const far = timed([{ x: 1900, y: 900, radius: 16 }]);
  const { whole, effects } = timed([-100, -40, 20, 80].map((x) => ({ x, y: -70, radius: 16 })));
  spy.mockRestore();
  const of = (name: string, among = effects) => among.find((effect) => effect.name === name)?.time ?? Number.NaN;
  expect(of('speed-limit')).toBe(0);
  expect(of('minerals')).toBeGreaterThan(0);
  expect(of('novae', far.effects)).toBe(0);
  expect(of('novae')).toBeGreaterThan(0);
  expect(effects.reduce((sum, { time }) => sum + (time ?? Number.NaN), 0)).toBeLessThan(whole.minimum);
});
