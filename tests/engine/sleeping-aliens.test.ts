import fc from 'fast-check';
import { expect, it } from 'vitest';
import { seeded } from '../../bench/scenes/seeded.ts';
import { randomScene } from '../../bench/soak/random-scene.ts';
import {
  type AccuracyName,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  simulate,
  unlimited,
  type WorkBudget,
} from '../../engine/index.ts';
import type { Circle, Level } from '../../schema/index.ts';

const ACCURACY = fc.constantFrom<AccuracyName>('precise', 'standard', 'fast', 'arcade');
const SEED = fc.nat(1_000_000);

const circle = (x: number, y: number, radius: number): Circle => ({ id: null, x, y, radius });

/** So many sleepers that she can't come near, in no order. */
const farAway = ({ astronaut }: Level, count: number): Circle[] =>
  Array.from({ length: count }, (_, i) => circle(astronaut.x + 3e5 + 60 * ((7 * i) % count), astronaut.y - 3e5, 5));

/** A scene crowded with aliens. */
function crowd(seed: number, count: number): ReturnType<typeof randomScene> {
  const scene = randomScene(seed);
  const random = seeded(seed + 1);
  const { x, y } = scene.level.astronaut;
  const radius = [0.01, 3, 10][seed % 3];
  const aliens = Array.from({ length: count }, () => circle(x + 800 * (random() - 0.5), y + 800 * (random() - 0.5), radius));
  return { ...scene, level: { ...scene.level, aliens } };
}

// a list of 12 is looked at one by one, one of 300 through the index
it('sleepers far away change no bit of what the others do', () => {
  fc.assert(
    fc.property(SEED, ACCURACY, (seed, accuracy) => {
      const { level, holds, maxTime } = crowd(seed, 12);
      const many = { ...level, aliens: [...level.aliens, ...farAway(level, 300)] };
      const few = simulate(compile(level, accuracy), holds, { maxTime });
      const all = simulate(compile(many, accuracy), holds, { maxTime });
      expect([all.hash, all.events, all.clearance]).toEqual([few.hash, few.events, few.clearance]);
    }),
    { numRuns: 60 },
  );
});

it('after a reset or a restore a crowd goes on as it did', () => {
  fc.assert(
    fc.property(SEED, ACCURACY, fc.integer({ min: 1, max: 200 }), (seed, accuracy, tick) => {
      const { level, holds } = crowd(seed, 150);
      const simulation = createSimulation(compile(level, accuracy));
      const aliens = new Float64Array(3 * level.aliens.length);
      const script = joinHolds(holds);
      const end = (): string => {
        playScript(
          simulation,
          script.map(([a, b]) => [Math.max(a, simulation.tick), b] as const).filter(([a, b]) => b > a),
          300,
        );
        simulation.readAliens(aliens);
        return `${JSON.stringify(simulation.ending)} ${simulation.tick} ${aliens}`;
      };
      const whole = end();
      simulation.reset();
      expect(end()).toBe(whole);
      simulation.reset();
      playScript(simulation, script, tick);
      const snapshot = simulation.snapshot();
      expect(end()).toBe(whole);
      simulation.restore(snapshot);
      expect(end()).toBe(whole);
      simulation.reset();
      expect(end()).toBe(whole);
    }),
    { numRuns: 30 },
  );
});

it.each([8, 100, 1000, 20_000])('%i that sleep cost no work', (count) => {
  const level: Level = {
    ...randomScene(1).level,
    astronaut: { x: 0, y: 0, vx: 0, vy: 40 },
    blackHole: { x: 0, y: 5000, radius: 18 },
    range: 250,
    recoil: false,
    asteroids: [{ ...circle(100, 0, 16), hot: false }],
    novae: [],
    repulsors: [],
    minerals: [],
    aliens: [],
  };
  for (const accuracy of ['precise', 'standard', 'fast', 'arcade'] as const) {
    const looksOf = (aliens: readonly Circle[]): number => {
      const budget: WorkBudget = unlimited();
      const simulation = createSimulation(compile({ ...level, aliens }, accuracy), budget);
      // until she first presses she might drift anywhere: that is looked at once, as the simulation is made
      const made = budget.looks;
      playScript(simulation, [[0, 3600]], 3600);
      expect(simulation.ending).toBeNull();
      return budget.looks - made;
    };
    const ring = Array.from({ length: count }, (_, i) => circle(3000 + 60 * (i % 150), 3000 + 60 * Math.floor(i / 150), 25));
    expect(looksOf(ring) / looksOf([])).toBeLessThan(1.03);
  }
});
