import { describe, expect, it } from 'vitest';
import type { Certificate } from '../../../solver/index.ts';
import { at, FRAMES, levelWith, ORIGIN, whyNot } from './near-miss.ts';

// What a certificate that follows her may ask for. Where she moves so fast that she is out of range soon, all of it is quick.

type Grid = Certificate & { kind: 'doomed' | 'flowpipe' };
type Follow = (steps: number, more?: Partial<Grid['grid']>) => Certificate;
const doomed: Follow = (steps, more) =>
  ({ kind: 'doomed', grid: { axis: [1, 0], cell: 8, bin: 4, frames: 4, steps, ...more } }) as Certificate;
const flowpipe: Follow = (steps, more) =>
  ({ kind: 'flowpipe', grid: { axis: [1, 0], cell: 16, frames: 4, steps, turns: 4, ...more } }) as Certificate;

const AWAY = levelWith({ astronaut: { ...ORIGIN, vx: -60, vy: 0 }, asteroids: [at(200, 0)] });

describe.each([
  ['doomed', doomed],
  ['flowpipe', flowpipe],
] as const)('%s', (kind, follow) => {
  const isPipe = kind === 'flowpipe';

  it('a grid that is none', () => {
    const accepted = (more: object) => whyNot(AWAY, follow(30, more));
    expect(accepted({})).toBeNull();
    expect(accepted({ cell: 0.25 })).not.toBe('its grid is none');
    expect(accepted({ cell: 1000 })).not.toBe('its grid is none');
    expect(accepted({ frames: 1, steps: 60 })).not.toBe('its grid is none');
    expect(accepted({ frames: 60, steps: isPipe ? 3 : 1 })).not.toBe('its grid is none');
    expect(accepted({ steps: isPipe ? 400 : 1000, frames: 4 })).not.toBe('its grid is none');
    const none: object[] = [
      ...[0.2499, 0, -8, 1000.1, Number.NaN, '8', null].map((cell) => ({ cell })),
      ...[0, 61, 1.5, '4', null].map((frames) => ({ frames })),
      ...[0, isPipe ? 2 : -1, isPipe ? 401 : 1001, 2.5, '30'].map((steps) => ({ steps })),
      ...[undefined, null, [1], [1, 0, 0], [1, 1e-5], [0.6, 0.81], [Number.NaN, 0], '10', { 0: 1, 1: 0, length: 2 }].map(
        (axis) => ({ axis }),
      ),
      ...(isPipe ? [0, 65, 1.5, '4'].map((turns) => ({ turns })) : [0.2499, 1000.1, '4', null].map((bin) => ({ bin }))),
    ];
    for (const more of none) expect(accepted(more), JSON.stringify(more)).toBe('its grid is none');
    if (isPipe) {
      expect(accepted({ turns: 1 })).not.toBe('its grid is none');
      expect(accepted({ turns: 64 })).not.toBe('its grid is none');
    } else {
      expect(accepted({ bin: 0.25 })).not.toBe('its grid is none');
      expect(accepted({ bin: 1000 })).not.toBe('its grid is none');
    }
    expect(whyNot(AWAY, { ...follow(30), grid: undefined } as never)).toBe('its grid is none');
  });
});

describe('with frames', () => {
  // `arcade` reckons in places as they are in the file, so that rounding grows with them: up to a million px the proof holds
  const far = (x: number, y: number) => {
    const moved = { x, y };
    const level = levelWith({
      astronaut: { ...moved, vx: -60, vy: 0 },
      asteroids: [{ x: x + 200, y, radius: 16 }],
      blackHole: { x: x + 900, y },
    });
    return whyNot(level, doomed(30), { covers: FRAMES });
  };
  const coarse = 'with frames places so far out are too coarse';

  it.each([
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ])('doomed says nothing of places beyond a million px, along %i, %i', (x, y) => {
    expect(far(x * 1e6 + y * 7, y * 1e6 + x * 7)).toBeNull();
    expect(far(x * 1.000_001e6 + y * 7, y * 1.000_001e6 + x * 7)).toBe(coarse);
  });

  it('without frames they are as good as any', () => {
    const level = levelWith({
      astronaut: { x: 3e6, y: 3e6, vx: -60, vy: 0 },
      asteroids: [{ x: 3e6 + 200, y: 3e6, radius: 16 }],
      blackHole: { x: 3e6 + 900, y: 3e6 },
    });
    expect(whyNot(level, doomed(30))).toBeNull();
  });
});
