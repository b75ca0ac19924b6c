import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, playScript, STATE_SIZE, simulate } from '../../engine/index.ts';
import { THEME_NAMES } from '../../solver/index.ts';
import { drawFlights } from '../../solver/make/generate/flights.ts';
import { specOf } from '../../solver/make/generate/generator-spec.ts';
import { emptyLayout, type Layout, takesOver } from '../../solver/make/generate/layout.ts';
import { toLevel } from '../../solver/make/generate/level-file.ts';
import { Site, THEMES } from '../../solver/make/generate/themes/index.ts';
import { createRandom } from '../../solver/random.ts';
import { expectDeep } from '../depth.ts';

describe('a drawn flight', () => {
  it('is what its holds lead to, lies within the level, and has as many presses as asked for', () => {
    let count = 0;
    fc.assert(
      fc.property(fc.nat(2 ** 32 - 1), fc.constantFrom(...THEME_NAMES), (seed, theme) => {
        const asked = specOf({ seed, theme, size: 'small' });
        const spec = { ...asked, ...THEMES[theme].adjust(asked) };
        const random = createRandom(seed);
        const site = new Site(spec, random);
        if (!THEMES[theme].arrange(site)) return;
        const scene = compile(toLevel(site.layout), 'arcade');
        const simulation = createSimulation(scene);
        for (let i = 0; i < 5; i++) {
          for (const { holds, way, from } of drawFlights(simulation, spec, random).flights) {
            count++;
            expect(holds.length).toBeGreaterThanOrEqual(spec.presses[0]);
            expect(holds.length).toBeLessThanOrEqual(spec.presses[1]);
            expect(from).toBeLessThan(way.length);
            const again = createSimulation(scene);
            const state = new Float64Array(STATE_SIZE);
            for (const [i, place] of way.entries()) {
              playScript(
                again,
                holds.filter(([, release]) => release > again.tick),
                4 * i,
              );
              again.readState(state);
              expect([state[0], state[1]]).toEqual([place.x, place.y]);
            }
            expect(way.every(({ x, y }) => x > 0 && y > 0 && x < spec.width && y < spec.height)).toBe(true);
          }
        }
      }),
      { numRuns: 40 },
    );
    expectDeep(count).toBeGreaterThan(20);
  });
});

describe('a second asteroid', () => {
  const at = fc.record({ x: fc.integer({ min: -280, max: 280 }), y: fc.integer({ min: -280, max: 280 }) });

  it('that takes over does so when she falls from rest', () => {
    let count = 0;
    fc.assert(
      fc.property(fc.integer({ min: 90, max: 200 }), at, (fall, { x, y }) => {
        const [start, first, second] = [
          { x: 0, y: 0 },
          { x: fall, y: 0 },
          { x: fall + x, y },
        ];
        if (Math.hypot(second.x, second.y) < fall + 10 || !takesOver(start, first, second)) return;
        count++;
        const layout: Layout = {
          ...emptyLayout(specOf({ seed: 0 })),
          start: { ...start, vx: 0, vy: 0 },
          asteroids: [first, second].map((place) => ({ ...place, radius: 24, hot: false })),
        };
        const { events } = simulate(compile(toLevel(layout), 'arcade'), [[0, 1200]], { maxTime: 20 });
        expect(events.some((event) => event.type === 'target' && event.index === 1)).toBe(true);
      }),
      { numRuns: 300 },
    );
    expectDeep(count).toBeGreaterThan(20);
  });
});
