import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { ACCURACIES, type Accuracy, accuracyOf, atAccuracy, compile, simulate } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { plainLevel } from './plain-level.ts';

const level = plainLevel({ astronaut: { vx: 20 }, asteroids: [{ x: 100, y: 60, radius: 16 }], range: 400 });
const TAYLOR = { integrator: 'taylor', rate: null, tolerance: 1e-9, contact: 'swept' };
const RK4 = { integrator: 'rk4', rate: 120, tolerance: null, contact: 'frame' };

/** Everything that takes an accuracy, also from code without types. */
const ways: readonly (readonly [string, (accuracy: unknown) => unknown])[] = [
  ['compile', (accuracy) => compile(level, accuracy as Accuracy)],
  ['atAccuracy', (accuracy) => atAccuracy(compile(level), accuracy as Accuracy)],
  ['accuracyOf', (accuracy) => accuracyOf(accuracy as Accuracy)],
];

describe.each(ways)('a custom accuracy, %s', (_way, use) => {
  it.each<[object, string]>([
    [{ ...TAYLOR, integrator: 'euller' }, 'integrator: expected arcade, euler, verlet, rk4 or taylor, found "euller"'],
    [{ ...TAYLOR, integrator: undefined }, 'integrator: expected arcade, euler, verlet, rk4 or taylor, found nothing'],
    [{ ...TAYLOR, contact: 'sweep' }, 'contact: expected "frame" or "swept", found "sweep"'],
    [{ ...RK4, contact: undefined }, 'contact: expected "frame" or "swept", found nothing'],
    [{ ...TAYLOR, tolerance: null }, 'tolerance: expected 1e-14 to 1 px for taylor, found null'],
    [{ ...TAYLOR, tolerance: undefined }, 'tolerance: expected 1e-14 to 1 px for taylor, found null'],
    [{ ...TAYLOR, tolerance: '1e-9' }, 'tolerance: expected 1e-14 to 1 px for taylor, found "1e-9"'],
    [{ ...TAYLOR, tolerance: 0 }, 'tolerance: expected 1e-14 to 1 px for taylor, found 0'],
    [{ ...TAYLOR, tolerance: Number.NaN }, 'tolerance: expected 1e-14 to 1 px for taylor, found NaN'],
    [{ ...TAYLOR, rate: 60 }, 'rate: taylor chooses its own steps: expected null, and a tolerance instead, found 60'],
    [{ ...RK4, rate: null }, 'rate: expected 1 to 100000 Hz for rk4, found null'],
    [{ ...RK4, rate: Number.NaN }, 'rate: expected 1 to 100000 Hz for rk4, found NaN'],
    [{ ...RK4, rate: Number.POSITIVE_INFINITY }, 'rate: expected 1 to 100000 Hz for rk4, found Infinity'],
    [{ ...RK4, rate: -60 }, 'rate: expected 1 to 100000 Hz for rk4, found -60'],
    [{ ...RK4, rate: 1e-300 }, 'rate: expected 1 to 100000 Hz for rk4, found 1e-300'],
    [{ ...RK4, tolerance: 1e-9 }, 'tolerance: rk4 has fixed steps: expected null, and a rate instead, found 1e-9'],
    [{ ...ACCURACIES.arcade, rate: 120 }, 'arcade has 60 frames per second and no other setting'],
    [{ ...ACCURACIES.arcade, contact: 'swept' }, 'arcade has 60 frames per second and no other setting'],
  ])('that is malformed is refused: %o', (accuracy, message) => {
    expect(() => use(accuracy)).toThrow(RangeError);
    expect(() => use(accuracy)).toThrow(message);
  });
});

describe('an accuracy', () => {
  it.each([['precize'], ['toString'], [''], [null], [7]])('that is none is refused: %o', (accuracy) => {
    expect(() => compile(level, accuracy as never)).toThrow(
      /^accuracy: expected arcade, fast, standard, precise, or a custom setting of accuracyOf, found /,
    );
  });

  it('may leave out what does not apply to its integrator', () => {
    const { rate: _rate, ...taylor } = TAYLOR;
    const { tolerance: _tolerance, ...rk4 } = RK4;
    for (const [part, whole] of [
      [taylor, TAYLOR],
      [rk4, RK4],
    ]) {
      const { accuracy } = compile(level, part as Accuracy);
      expect(accuracy).toEqual({ ...whole, name: expect.any(String) });
      const hash = (of: object) => simulate(compile(level, of as Accuracy), [[0, 300]], { maxTime: 20 }).hash;
      expect(hash(part)).toBe(hash(whole));
    }
  });

  it('stays the same object if nothing is missing', () => {
    for (const accuracy of [...Object.values(ACCURACIES), { ...ACCURACIES.precise, name: 'mine', tolerance: 1e-11 }]) {
      expect(compile(level, accuracy).accuracy).toBe(accuracy);
    }
    expect(accuracyOf(TAYLOR as Accuracy)).toBe(ACCURACIES.precise);
  });

  it('is refused, or plays a run that stays finite', () => {
    const any = fc.oneof(fc.constantFrom(null, undefined, 0, 1, 60, 1e5, 1e-14, 1e-9), fc.double(), fc.string());
    const member = <T>(...good: readonly T[]) => fc.oneof({ weight: 4, arbitrary: fc.constantFrom<unknown>(...good) }, any);
    let played = 0;
    fc.assert(
      fc.property(
        fc.record({
          integrator: member('arcade', 'euler', 'verlet', 'rk4', 'taylor'),
          rate: member(null, undefined, 1, 30, 60, 777.7),
          tolerance: member(null, undefined, 1e-14, 1e-9, 1),
          contact: member('frame', 'swept'),
        }),
        (accuracy) => {
          let scene: ReturnType<typeof compile>;
          try {
            scene = compile(level, accuracy as unknown as Accuracy);
          } catch (error) {
            expect(error).toBeInstanceOf(RangeError);
            return;
          }
          played++;
          const { final } = simulate(scene, [[0, 120]], { maxTime: 3 });
          expect(Object.values(final).every(Number.isFinite)).toBe(true);
        },
      ),
      { numRuns: 300 },
    );
    expectDeep(played).toBeGreaterThan(20);
  });
});
