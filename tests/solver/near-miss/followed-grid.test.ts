import { describe, expect, it } from 'vitest';
import type { Certificate } from '../../../solver/index.ts';
import { at, doomedBy, FRAMES, flowpipeBy, levelWith, ORIGIN, whyNot } from './near-miss.ts';

// What a certificate with reachable sets may ask for. She moves so fast that she is out of range soon, so all of it is quick.

const AWAY = levelWith({ astronaut: { ...ORIGIN, vx: -60, vy: 0 }, asteroids: [at(240, 0)] });

const doomed = doomedBy({ axis: [1, 0], cell: 8, bin: 4, frames: 4 }, 30);
const DOOMED = doomed(AWAY);
// Its sets may belong to no other grid.
type Follow = (steps: number, more?: object) => Certificate;
const withGrid: Follow = (_, more) => ({ ...DOOMED, grid: { ...DOOMED.grid, ...more } });
const FLOWPIPE = flowpipeBy({ axis: [1, 0], cell: 16, frames: 4, steps: 30, turns: 4 })(AWAY);
const withPipeGrid: Follow = (_, more) => ({ ...FLOWPIPE, grid: { ...FLOWPIPE.grid, ...more } });

describe.each([
  ['doomed', withGrid],
  ['flowpipe', withPipeGrid],
] as const)('%s', (kind, follow) => {
  const isPipe = kind === 'flowpipe';

  it('a malformed grid', () => {
    const accepted = (more: object) => whyNot(AWAY, follow(30, more));
    expect(accepted({})).toBeNull();
    expect(accepted({ cell: 0.25 })).not.toBe('its grid is not valid');
    expect(accepted({ cell: 1000 })).not.toBe('its grid is not valid');
    expect(accepted({ frames: 1, steps: 60 })).not.toBe('its grid is not valid');
    expect(accepted({ frames: 60, ...(isPipe && { steps: 3 }) })).not.toBe('its grid is not valid');
    const none: object[] = [
      ...[0.2499, 0, -8, 1000.1, Number.NaN, '8', null].map((cell) => ({ cell })),
      ...[0, 61, 1.5, '4', null].map((frames) => ({ frames })),
      ...(isPipe ? [0, 2, 401, 2.5, '30'].map((steps) => ({ steps })) : []),
      ...[undefined, null, [1], [1, 0, 0], [1, 1e-5], [0.6, 0.81], [Number.NaN, 0], '10', { 0: 1, 1: 0, length: 2 }].map(
        (axis) => ({ axis }),
      ),
      ...(isPipe ? [0, 65, 1.5, '4'].map((turns) => ({ turns })) : [0.2499, 1000.1, '4', null].map((bin) => ({ bin }))),
    ];
    for (const more of none) expect(accepted(more), JSON.stringify(more)).toBe('its grid is not valid');
    if (isPipe) {
      expect(accepted({ steps: 400 })).not.toBe('its grid is not valid');
      expect(accepted({ turns: 1 })).not.toBe('its grid is not valid');
      expect(accepted({ turns: 64 })).not.toBe('its grid is not valid');
    } else {
      expect(accepted({ bin: 0.25 })).not.toBe('its grid is not valid');
      expect(accepted({ bin: 1000 })).not.toBe('its grid is not valid');
    }
    expect(whyNot(AWAY, { ...follow(30), grid: undefined } as never)).toBe('its grid is not valid');
  });
});

describe('the sets of doomed', () => {
  const accepted = (layers: unknown) => whyNot(AWAY, { ...DOOMED, layers } as Certificate);
  const [first, ...rest] = DOOMED.layers;
  const withBox = (box: unknown) => accepted([[...first, box], ...rest]);
  const far = [-9000, -8999, -9000, -8999, -1, 1, -1, 1];
  const withNumber = (i: number, n: unknown) => withBox(far.map((old, k) => (k === i ? n : old)));

  it('an additional box does no harm', () => expect(withBox(far)).toBeNull());

  it('boxes are eight numbers, each least before its greatest, none too large', () => {
    const none = 'its sets are not valid';
    for (const layers of [undefined, null, {}, 'all', [...DOOMED.layers, null], [...DOOMED.layers, {}]])
      expect(accepted(layers), JSON.stringify(layers)).toBe(none);
    for (const box of [undefined, null, {}, 8, [], far.slice(1), [...far, 0], { ...far, length: 8 }])
      expect(withBox(box), JSON.stringify(box)).toBe(none);
    for (let i = 0; i < 8; i++) {
      const last = i % 2 === 1;
      for (const n of [Number.NaN, 1 / 0, -1 / 0, null, undefined, `${far[i]}`, [far[i]], last ? 1.001e9 : -1.001e9])
        expect(withNumber(i, n), `${i} ${n}`).toBe(none);
      expect(withNumber(i, last ? far[i - 1] - 1e-9 : far[i + 1] + 1e-9)).toBe(none);
    }
    expect(withNumber(0, -1e9)).not.toBe(none);
  });

  it('no more of them than allowed', () => {
    const count = DOOMED.layers.flat().length;
    const more = (n: number) => accepted([[...first, ...Array.from({ length: n }, () => far)], ...rest]);
    expect(more(20_000 - count)).toBeNull();
    expect(more(20_001 - count)).toBe('its sets are not valid');
  });

  it('no sets contain nothing', () => {
    expect(accepted([])).toBe('some runs may continue after 0 steps');
    expect(accepted([[], []])).toBe('its sets do not contain everything she may do by step 0');
    // Frames test the black hole before hazards, so it says nothing that the run ends at once.
    const atOnce = levelWith({ astronaut: { ...ORIGIN, vx: -60, vy: 0 }, asteroids: [at(200, 0)], novae: [at(0, 0, 30)] });
    const touching = { ...atOnce, blackHole: { ...atOnce.blackHole, ...ORIGIN } };
    for (const level of [atOnce, touching])
      expect(whyNot(level, { ...DOOMED, layers: [] }, { covers: FRAMES })).toBe('some runs may continue after 0 steps');
  });
});

describe('in frames', () => {
  // `arcade` computes with the coordinates of the file, so rounding errors grow with them; the proof holds up to a million px.
  const far = (x: number, y: number) => {
    const moved = { x, y };
    const level = levelWith({
      astronaut: { ...moved, vx: -60, vy: 0 },
      asteroids: [{ x: x + 200, y, radius: 16 }],
      blackHole: { x: x + 900, y },
    });
    return whyNot(level, doomed, { covers: FRAMES });
  };
  const coarse = 'with frames, rounding is too coarse so far out';

  it.each([
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ])('doomed does not cover coordinates beyond a million px, along %i, %i', (x, y) => {
    expect(far(x * 1e6 + y * 7, y * 1e6 + x * 7)).toBeNull();
    expect(far(x * 1.000_001e6 + y * 7, y * 1.000_001e6 + x * 7)).toBe(coarse);
  });

  it('outside of frames they are as good as any', () => {
    const level = levelWith({
      astronaut: { x: 3e6, y: 3e6, vx: -60, vy: 0 },
      asteroids: [{ x: 3e6 + 200, y: 3e6, radius: 16 }],
      blackHole: { x: 3e6 + 900, y: 3e6 },
    });
    expect(whyNot(level, doomed)).toBeNull();
  });
});
