import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DEFAULT_RULES } from '../../schema/index.ts';
import { type SwingStretch, swingDrift } from '../../solver/prove/swing-drift.ts';
import { expectDeep } from '../depth.ts';

const RANGE = 250;
const SECONDS = 60;
const STEP = 1 / 240;

/** Whether the button is held at a distance from the asteroid, on either side, while she falls in or swings out. */
type Player = (side: number, far: number, inwards: boolean, random: number) => boolean;

interface Swing {
  /** How far the asteroid has moved from its start, px. */
  readonly drift: { readonly back: number; readonly ahead: number };
  readonly stretch: SwingStretch;
}

/** How far an asteroid drifts that is pulled in one direction all the time, px; plus 1 %, as for frames. */
const always = (radius: number): number => (1.01 * SECONDS * SECONDS) / 4 / radius;

/** A minute on the line: she starts at rest at 0, the asteroid at `centre`. It ends where she is out of range. */
function swing(centre: number, radius: number, player: Player, random: () => number): Swing {
  let [s, v, c, w] = [0, 0, centre, 0];
  let drift = { back: 0, ahead: 0 };
  let stretch = { centre, back: 0, front: 0 };
  for (let t = 0; t < SECONDS; t += STEP) {
    const r = s - c;
    const side = Math.sign(r);
    if (player(side, Math.abs(r), (v - w) * r < 0, random())) {
      v -= side * DEFAULT_RULES.pull * (1 - Math.abs(r) / RANGE) * STEP;
      w += (side / (2 * radius)) * STEP;
    }
    s += v * STEP;
    c += w * STEP;
    if (Math.abs(s - c) > RANGE) break;
    drift = { back: Math.max(drift.back, centre - c), ahead: Math.max(drift.ahead, c - centre) };
    stretch = { centre, back: Math.min(stretch.back, s), front: Math.max(stretch.front, s) };
  }
  return { drift, stretch };
}

/**
 * Pulls where the distance is large on one side and small on the other, so that recoil adds up, and swings no farther out than
 * it fell from.
 */
const greedy =
  (from: number): Player =>
  (side, far, inwards) =>
    side < 0 ? inwards && far > from : !inwards || far < from;

describe('how far recoil carries an asteroid through which she swings', () => {
  it('is never more than the bound', () => {
    let most = { back: 0, ahead: 0 };
    fc.assert(
      fc.property(
        fc.integer({ min: 5, max: 120 }),
        fc.constantFrom(16, 32),
        fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: 4, maxLength: 4 }),
        fc.integer({ min: 0, max: 120 }),
        fc.infiniteStream(fc.double({ min: 0, max: 1, noNaN: true })),
        (centre, radius, [rightIn, rightOut, leftIn, leftOut], from, numbers) => {
          const random = () => numbers.next().value as number;
          const chances = [leftIn, leftOut, rightIn, rightOut];
          const mixed: Player = (side, far, inwards, luck) =>
            luck < chances[(side > 0 ? 2 : 0) + (inwards ? 0 : 1)] && (side > 0 || far > from);
          for (const player of [mixed, greedy(from), greedy(Math.min(from, centre / 2))]) {
            const { drift, stretch } = swing(centre, radius, player, player === mixed ? random : () => 0);
            const bound = swingDrift(DEFAULT_RULES, radius, RANGE, stretch, SECONDS, always(radius));
            expect(drift.back).toBeLessThan(bound.back);
            expect(drift.ahead).toBeLessThan(bound.ahead);
            most = { back: Math.max(most.back, drift.back / bound.back), ahead: Math.max(most.ahead, drift.ahead / bound.ahead) };
          }
        },
      ),
      { numRuns: 30 },
    );
    // A bound that nothing comes near would hold for any formula.
    expectDeep(most.back).toBeGreaterThan(0.05);
    expectDeep(most.ahead).toBeGreaterThan(0.05);
  });

  it('is a small part of the drift of an asteroid that is pulled in one direction all the time', () => {
    const { back, ahead } = swingDrift(DEFAULT_RULES, 16, RANGE, { centre: 30, back: -30, front: 90 }, SECONDS, always(16));
    expect(Math.max(back, ahead)).toBeLessThan(0.2 * always(16));
  });

  it('is smaller ahead where she comes less far ahead', () => {
    const { back, ahead } = swingDrift(DEFAULT_RULES, 16, RANGE, { centre: 60, back: -30, front: 90 }, SECONDS, always(16));
    expect(ahead).toBeLessThan(0.5 * back);
  });

  it('equals that of a constant pull where she may reach the end of the range', () => {
    const { ahead } = swingDrift(DEFAULT_RULES, 16, RANGE, { centre: 60, back: -30, front: 60 + RANGE }, SECONDS, always(16));
    expect(ahead).toBe(always(16));
  });
});
