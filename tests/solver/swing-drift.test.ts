import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { GUN_PULL } from '../../engine/index.ts';
import { swingDrift } from '../../solver/proofs/swing-drift.ts';

const RANGE = 250;
const SECONDS = 60;
const STEP = 1 / 240;

/** Whether the button is held at a distance from the asteroid, on one side of it or the other, falling in or swinging out. */
type Player = (side: number, far: number, inwards: boolean, random: number) => boolean;

interface Swing {
  /** how far the asteroid came from where it started, px */
  readonly drift: number;
  readonly reach: number;
  readonly way: number;
}

/** A minute on the line: she starts at rest at 0, the asteroid at `centre`. Ends where she is out of range. */
function swing(centre: number, radius: number, player: Player, random: () => number): Swing {
  let [s, v, c, w] = [0, 0, centre, 0];
  let [drift, reach, way] = [0, centre, 0];
  for (let t = 0; t < SECONDS; t += STEP) {
    const r = s - c;
    const side = Math.sign(r);
    if (player(side, Math.abs(r), (v - w) * r < 0, random())) {
      v -= side * GUN_PULL * (1 - Math.abs(r) / RANGE) * STEP;
      w += (side / (2 * radius)) * STEP;
    }
    s += v * STEP;
    c += w * STEP;
    if (Math.abs(s - c) > RANGE) break;
    drift = Math.max(drift, Math.abs(c - centre));
    reach = Math.max(reach, Math.abs(s - centre));
    way = Math.max(way, Math.abs(s));
  }
  return { drift, reach, way };
}

/** Pulls where it is far on the one side and near on the other, so that recoil adds up, and swings no farther out than it fell from. */
const greedy =
  (from: number): Player =>
  (side, far, inwards) =>
    side < 0 ? inwards && far > from : !inwards || far < from;

describe('how far recoil carries an asteroid that she swings through', () => {
  it('is never more than the bound', () => {
    const bound = ({ reach, way }: Swing, radius: number) => swingDrift(radius, RANGE, reach, way, SECONDS);
    let most = 0;
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
            const result = swing(centre, radius, player, player === mixed ? random : () => 0);
            expect(result.drift).toBeLessThan(bound(result, radius));
            most = Math.max(most, result.drift / bound(result, radius));
          }
        },
      ),
      { numRuns: 60 },
    );
    // a bound that nothing comes near would hold for any formula
    expect(most).toBeGreaterThan(0.05);
  });

  it('is a small part of what an asteroid drifts that is pulled one way all the time', () => {
    const always = (SECONDS * SECONDS) / 2 / 32;
    expect(swingDrift(16, RANGE, 60, 60, SECONDS)).toBeLessThan(0.2 * always);
  });

  it('has no bound where she may come to the end of the range', () => {
    expect(swingDrift(16, RANGE, RANGE, 100, SECONDS)).toBe(Number.POSITIVE_INFINITY);
  });
});
