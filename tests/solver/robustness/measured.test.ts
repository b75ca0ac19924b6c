import { describe, expect, it } from 'vitest';
import { compile, type Scene, simulate } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { certify, findSlack, measureRobustness, successProbability } from '../../../solver/index.ts';
import { createTrials, judgeAll } from '../../../solver/measure/robustness/index.ts';
import { playFrom } from '../../../solver/measure/robustness/trials.ts';
import { plainLevel } from '../../engine/plain-level.ts';
import { fallThrough } from '../search/solvable-levels.ts';
import { ANY, succeeds } from './scenes.ts';

/** The shortest hold from the start that succeeds: with a little less she fails. */
function tightRun(scene: Scene): readonly Hold[] {
  const release = [...Array(600).keys()].find((ticks) => ticks > 0 && simulate(scene, [[0, ticks]]).outcome === 'completed');
  if (release === undefined) throw new Error('expected a hold that completes the level');
  return [[0, release]];
}

describe('the robustness of a run', () => {
  const scene = compile(fallThrough(), 'arcade');
  const run = tightRun(scene);

  it('consists of what is measured separately', () => {
    const asked = { samples: 150, seed: 3, maxRuns: 3000 };
    const { p30, p40, p60, p80, certifiedTicks, decided, slack } = measureRobustness(scene, run, ANY, asked);
    for (const [sigma, found] of [
      [30, p30],
      [40, p40],
      [60, p60],
      [80, p80],
    ] as const) {
      expect(found).toEqual(successProbability(scene, run, ANY, sigma, asked));
      expect(found.sigma).toBe(sigma);
    }
    const { ticks, exhausted } = certify(scene, run, ANY, { maxRuns: 3000 });
    expect({ certifiedTicks, decided }).toEqual({ certifiedTicks: ticks, decided: !exhausted });
    expect(slack).toEqual(findSlack(scene, run, ANY));
  });

  it('takes 1000 attempts of seed 0 by default', () => {
    const plain = successProbability(scene, run, ANY, 60);
    expect(plain.samples).toBe(1000);
    expect(plain).toEqual(successProbability(scene, run, ANY, 60, { samples: 1000, seed: 0 }));
    expect(plain).not.toEqual(successProbability(scene, run, ANY, 60, { samples: 1000, seed: 1 }));
    expect(measureRobustness(scene, run, ANY, { maxRuns: 100 }).p60).toEqual(plain);
  });
});

describe('minerals that are touched in one frame', () => {
  // All at one place, and one that she never reaches.
  const twins = [60, 60, 60].map((x) => ({ x, y: 0, radius: 7 }));
  const level = plainLevel({
    range: 250,
    asteroids: [{ x: 100, y: 0, radius: 16 }],
    blackHole: { x: 230, y: 10 },
    minerals: [...twins, { x: 60, y: 900, radius: 7 }],
  });

  it.each(['arcade', 'precise'] as const)('each count, at %s', (accuracy) => {
    const scene = compile(level, accuracy);
    const holds = tightRun(scene);
    for (const minerals of ['any', 'all', 0, 1, 2, 3, 4] as const) {
      const goal = { minerals };
      const truth = succeeds({ scene, holds, goal }, holds);
      expect(truth, String(minerals)).toBe(minerals === 'any' || (minerals !== 'all' && minerals <= 3));
      const trials = createTrials(scene, goal);
      expect(playFrom(trials, trials.simulation.snapshot(), holds)).toBe(truth);
      expect([...judgeAll(trials, [holds, holds, []])]).toEqual([truth ? 1 : 0, truth ? 1 : 0, 0]);
    }
  });
});
