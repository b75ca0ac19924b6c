import { describe, expect, it } from 'vitest';
import type { LevelFile } from '../../../schema/index.ts';
import type { DeadEnd, LineTrap } from '../../../solver/prove/index.ts';
import { type Asked, at, FRAMES, levelWith, nearMisses, ORIGIN, RANGE, spot, whyNot as whyNotBy } from './near-miss.ts';

// She falls to the right through an asteroid at 60 px. From 128 px on another one is equally near and pulls her down to the
// right, into two novae.

/** A fixed step uses the push of a place nearby, so dead ends cover `precise` only. */
const whyNot: typeof whyNotBy = (level, certificate, asked = {}) =>
  whyNotBy(level, certificate, { covers: ['precise'], ...asked });

const SOURCE = { asteroids: [at(60, 0), at(160, 60)], novae: [at(-60, 0), at(176, 0, 32), at(150, 66, 32)] };
const scene = (more: Partial<LevelFile> = {}) => levelWith({ ...SOURCE, blackHole: spot(300, 0), ...more });
const second = (nova: ReturnType<typeof at>) => scene({ novae: [SOURCE.novae[0], nova, SOURCE.novae[2]] });
// Along the direction from the first asteroid to the second, in which both together pull her.
const AXIS = [100 / Math.sqrt(13_600), 60 / Math.sqrt(13_600)] as const;
const trap = (more: Partial<DeadEnd> = {}, at = 128): LineTrap => ({
  kind: 'line-trap',
  target: 0,
  back: { at: -34.02, by: { kind: 'nova', index: 0 } },
  front: { at, by: { kind: 'dead-end', axis: AXIS, step: 1, ...more } },
  drift: null,
});

describe('a dead end', () => {
  it('holds', () => expect(whyNot(scene(), trap())).toBeNull());

  const leaves = 'she may turn away from its axis';
  nearMisses({
    // Measured: on the other side the paths pass the novae.
    'a nova that is too small to stop all ways': {
      why: (r) => whyNot(second(at(176, 0, r)), trap()),
      truth: 11,
      safe: 'above',
      slack: [1.02, 1.06],
      says: '',
      reach: 4,
      grain: 0.01,
    },
    'a nova that is too far': {
      why: (x) => whyNot(second(at(x, 0, 32)), trap()),
      truth: 210,
      safe: 'below',
      slack: [1.43, 1.48],
      says: leaves,
      reach: 4,
      grain: 0.01,
    },
    'a nova that is too high': {
      why: (y) => whyNot(second(at(176, -y, 32)), trap()),
      truth: 26,
      safe: 'below',
      slack: [1.16, 1.22],
      says: leaves,
      reach: 4,
      grain: 0.01,
    },
    'a nova that is too low': {
      why: (y) => whyNot(second(at(176, y, 32)), trap()),
      truth: 43,
      safe: 'below',
      slack: [1, 1.06],
      says: leaves,
      reach: 4,
      grain: 0.01,
    },
    'a black hole near the way': {
      why: (y) => whyNot(scene({ blackHole: spot(120, -y) }), trap()),
      // On the line she extends 16 px beside it.
      truth: 34,
      safe: 'above',
      slack: [2.44, 2.48],
      says: '',
      reach: 4,
      grain: 0.005,
    },
    'a field that reaches the place where she leaves the line': {
      why: (r) => whyNot(scene({ repulsors: [at(135, -60, r)] }), trap()),
      truth: Math.hypot(7, 60),
      safe: 'below',
      slack: [0.009, 0.012],
      says: '',
      reach: 2,
    },
    'a third asteroid that is as near, at the other side': {
      why: (y) => whyNot(scene({ asteroids: [...SOURCE.asteroids, at(160, -y)] }), trap()),
      truth: 60,
      safe: 'above',
      slack: [1.26, 1.32],
      says: '',
      reach: 4,
      grain: 0.005,
    },
  });

  it('begins where the other asteroid is equally near, neither before nor behind', () => {
    expect(whyNot(scene(), trap({}, 127.999))).toBe('the previous asteroid may be the nearest again');
    expect(whyNot(scene(), trap({}, 128.001))).toBe('asteroid 2 may be the nearer one on the stretch');
  });

  it('has an axis and a step', () => {
    const axis = 'its axis is not a direction';
    for (const bad of [
      undefined,
      null,
      [1],
      [1, 0, 0],
      [0.9, 0.5],
      [1, 1e-4],
      [0.8, 0.5],
      [1 - 1e-8, 0],
      [0, 0],
      [Number.NaN, 0],
      'x',
    ]) {
      expect(whyNot(scene(), trap({ axis: bad as never })), JSON.stringify(bad)).toBe(axis);
    }
    for (const step of [0.2499, 4.001, 0, -1, Number.NaN, '1' as never, null as never]) {
      expect(whyNot(scene(), trap({ step }))).toBe('its step is not valid');
    }
    for (const step of [0.25, 0.5, 2, 4]) expect(whyNot(scene(), trap({ step }))).not.toBe('its step is not valid');
    const aside = 'she does not move along its axis';
    expect(whyNot(scene(), trap({ axis: [-1, 0] }))).toBe(aside);
    expect(whyNot(scene(), trap({ axis: [0, 1] }))).toBe(aside);
    expect(whyNot(scene(), trap({ axis: [0.12, -Math.sqrt(1 - 0.12 ** 2)] }))).toBe(aside);
    expect(whyNot(scene(), trap({ axis: [0.13, Math.sqrt(1 - 0.13 ** 2)] }))).not.toBe(aside);
  });

  it('does not cover recoil, frames or fixed steps', () => {
    const asked: Asked = { maxTime: 60 };
    const recoil = whyNot(scene({ recoil: true }), { ...trap(), drift: { back: 300, ahead: 300 } }, asked);
    expect(recoil).toBe('with recoil the border between two asteroids moves');
    expect(whyNot(scene(), trap(), { covers: FRAMES })).not.toBeNull();
    for (const steps of ['fast', 'standard'] as const) {
      expect(whyNot(scene(), trap(), { covers: [steps] }), steps).not.toBeNull();
    }
  });

  it('may also end at the end of the range', () => {
    // No nova ahead, but a range at whose end the two asteroids lie.
    const level = (range: number) =>
      levelWith({ asteroids: [at(60, 0), at(160, 60)], novae: [at(-60, 0)], blackHole: spot(2000, 0), range });
    expect(whyNot(level(RANGE), trap())).not.toBeNull();
  });

  it('may also end the stretch behind the start, on a slanted line', () => {
    // Seen from 94 px along the line, looking back: the asteroid is 34 px ahead, the dead end 34 px behind.
    const turned = (x: number, y: number) => ({ x: 0.6 * (94 - x) - 0.8 * y, y: 0.8 * (94 - x) + 0.6 * y });
    const moved = (thing: { x: number; y: number; radius: number }) => {
      const { x, y } = turned(thing.x - ORIGIN.x, thing.y - ORIGIN.y);
      return at(x, y, thing.radius);
    };
    const level = (more: Partial<LevelFile> = {}) =>
      levelWith({ asteroids: SOURCE.asteroids.map(moved), novae: SOURCE.novae.map(moved), blackHole: spot(3000, 0), ...more });
    const axis = [-0.6 * AXIS[0] - 0.8 * AXIS[1], -0.8 * AXIS[0] + 0.6 * AXIS[1]] as const;
    const swung = (back: number): LineTrap => ({
      kind: 'line-trap',
      target: 0,
      back: { at: back, by: { kind: 'dead-end', axis, step: 1 } },
      front: { at: 128.02, by: { kind: 'nova', index: 0 } },
      drift: null,
    });
    expect(whyNot(level(), swung(-34))).toBeNull();
    expect(whyNot(level(), swung(-33.999))).toBe('the previous asteroid may be the nearest again');
    expect(whyNot(level(), swung(-34.001))).toBe('asteroid 2 may be the nearer one on the stretch');
    expect(
      whyNot(level({ novae: [moved(SOURCE.novae[0]), moved(at(176, 0, 11)), moved(SOURCE.novae[2])] }), swung(-34)),
    ).not.toBeNull();
  });

  it('is where she is, however the level is moved and mirrored', () => {
    const flip = ({ x, y, ...more }: { x: number; y: number; radius: number }) => ({
      ...more,
      x: 2 * ORIGIN.x - x,
      y: 2 * ORIGIN.y - y,
    });
    const flipped = levelWith({ asteroids: SOURCE.asteroids.map(flip), novae: SOURCE.novae.map(flip), blackHole: spot(-300, 0) });
    expect(whyNot(flipped, trap({ axis: [-AXIS[0], -AXIS[1]] }))).toBeNull();
    const back: LineTrap = { ...trap(), front: { at: 34.02, by: { kind: 'nova', index: 0 } } };
    expect(whyNot(flipped, { ...back, back: { at: -1, by: { kind: 'dead-end', axis: [1, 0], step: 1 } } })).not.toBeNull();
  });
});
