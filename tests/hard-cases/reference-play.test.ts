import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Hold, Level } from '../../schema/index.ts';
import { plainLevel } from '../engine/plain-level.ts';
import { NotCovered, type Played, play } from '../judges/reference-play/index.ts';
import { declareMissing } from '../missing.ts';
import {
  continuousReferences,
  hardReferences,
  hasContinuousReferences,
  hasHardReferences,
  NO_REFERENCES,
} from '../truth/references.ts';

type Dd = Played['end']['time'];

const toNumber = ({ hi, lo }: Dd): number => hi + lo;

const from = (level: Level, holds: readonly Hold[], maxTicks: number): Played =>
  play(level, holds, { maxTicks, every: 60, nudge: [0, 0, 0, 0] });

/** A double-double as a whole number of 1e-36, for exact arithmetic. */
function exactly({ hi, lo }: Dd): bigint {
  const whole = (value: number): bigint => {
    // value = mantissa * 2^exponent
    let exponent = 0;
    let mantissa = value;
    while (!Number.isInteger(mantissa)) {
      mantissa *= 2;
      exponent++;
    }
    return (BigInt(mantissa) * 10n ** 36n) / 2n ** BigInt(exponent);
  };
  return whole(hi) + whole(lo);
}

const ONE = 10n ** 36n;
const product = (...factors: bigint[]): bigint => factors.reduce((a, b) => (a * b) / ONE);

describe('the reference with 32 digits', () => {
  it('shares nothing with the engine', () => {
    const folder = new URL('../judges/reference-play/', import.meta.url);
    const files = readdirSync(folder);
    expect(files.length).toBeGreaterThan(4);
    const imports = files.flatMap((file) =>
      [...readFileSync(new URL(file, folder), 'utf8').matchAll(/from '([^']+)'/g)].map(([, path]) => path),
    );
    expect(imports.filter((path) => !path.startsWith('./') && path !== '../../../schema/index.ts')).toEqual([]);
  });

  it('falls in a wind as the closed form says, to 28 digits', () => {
    const level = {
      ...plainLevel({ range: 1000, asteroids: [{ x: 500, y: 0, radius: 16 }] }),
      winds: [{ id: null, x: 0, y: 0, radius: 400, ax: 7, ay: -3 }],
    };
    const { end, outcome } = from(level, [], 70);
    expect(outcome).toBe('timeout');
    const t = (ONE * 70n) / 60n;
    expect(Number(exactly(end.at.x) - product(7n * ONE, t, t) / 2n) / 1e36).toBeCloseTo(0, 27);
    expect(Number(exactly(end.velocity.y) + 3n * t) / 1e36).toBeCloseTo(0, 27);
  });

  it('keeps energy and angular momentum of an orbit to 24 digits', () => {
    const level = plainLevel({ range: 250, asteroids: [{ x: 100, y: 0, radius: 16 }], astronaut: { vy: 41 } });
    const { end } = from(level, [[0, 1200]], 1200);
    const [x, y, vx, vy] = [end.at.x, end.at.y, end.velocity.x, end.velocity.y].map(exactly);
    const dx = x - 100n * ONE;
    const momentum = product(dx, vy) - product(y, vx);
    expect(Math.abs(Number(momentum + 4100n * ONE) / 1e36)).toBeLessThan(1e-24);
    // v2 / 2 + 39 (d - d2 / 500), with d from its square by Newton's method
    const d2 = product(dx, dx) + product(y, y);
    let d = BigInt(Math.round(Math.sqrt(Number(d2) / 1e36) * 1e15)) * 10n ** 21n;
    for (let n = 0; n < 3; n++) d = (d + (d2 * ONE) / d) / 2n;
    const energy = (product(vx, vx) + product(vy, vy)) / 2n + 39n * (d - d2 / 500n);
    const atStart = (1681n * ONE) / 2n + 39n * (100n * ONE - (10_000n * ONE) / 500n);
    expect(Math.abs(Number(energy - atStart) / 1e36)).toBeLessThan(1e-24);
  });

  it('slides on a rim between a pull inwards and a push outwards, as fast as she was', () => {
    const level = plainLevel({
      range: 400,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      astronaut: { x: 50, vy: 3 },
      repulsors: [{ x: 0, y: 0, radius: 50 }],
    });
    const { end, slides } = from(level, [[0, 600]], 600);
    expect([...slides]).toEqual(['field']);
    expect(toNumber(end.at.x)).toBeCloseTo(50 * Math.cos(0.6), 13);
    expect(toNumber(end.at.y)).toBeCloseTo(50 * Math.sin(0.6), 13);
  });

  it('says where it does not know how to go on: at rest on two rims between a pull inwards and a push outwards', () => {
    const level = plainLevel({
      range: 400,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      astronaut: { x: 50 },
      repulsors: [
        { x: 0, y: 0, radius: 50 },
        { x: 20, y: 0, radius: 30 },
      ],
    });
    expect(() => from(level, [[0, 60]], 60)).toThrow(NotCovered);
  });
});

const suite = 'the reference with 32 digits, against references made elsewhere';

if (!hasContinuousReferences || !hasHardReferences) declareMissing(suite, NO_REFERENCES);
else {
  describe(suite, () => {
    // each hard case, and a sample of the others
    const cases = [...hardReferences(), ...continuousReferences().filter((_, i) => i % 9 === 0)];

    it.each(cases)('$id: the same to the last digit of a double', ({ level, reference }) => {
      const played = from(level, reference.holds, 3600);
      expect([played.outcome, played.with]).toEqual([reference.outcome, reference.with]);
      expect(played.minerals.map(({ index }) => index)).toEqual(reference.minerals.map(({ index }) => index));
      const { at, velocity, time } = played.end;
      const { final } = reference;
      const far = Math.max(1, Math.abs(final.x), Math.abs(final.y));
      expect(Math.abs(toNumber(at.x) - final.x)).toBeLessThan(1e-14 * far);
      expect(Math.abs(toNumber(at.y) - final.y)).toBeLessThan(1e-14 * far);
      expect(Math.abs(toNumber(velocity.x) - final.vx)).toBeLessThan(1e-13);
      expect(Math.abs(toNumber(velocity.y) - final.vy)).toBeLessThan(1e-13);
      expect(Math.abs(toNumber(time) - reference.time)).toBeLessThan(1e-14 * Math.max(1, reference.time));
    });
  });
}
