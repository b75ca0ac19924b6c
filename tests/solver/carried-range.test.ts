import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile, simulate, TICK } from '../../engine/index.ts';
import { resolveLevel } from '../../schema/index.ts';
import { proveImpossible } from '../../solver/index.ts';
import { proveBy } from '../../solver/prove/prove.ts';
import { expectDeep } from '../depth.ts';
import { real } from '../real.ts';
import { type Look, lingering, type Player, watch } from './watched-play.ts';

// She starts at rest at 0, 0; the asteroid that she falls towards lies on the x axis. Recoil carries it, and the range with it.

const PULL = 39;
const RANGE = 250;
const SECONDS = 60;
const HOLE = { kind: 'blackHole' } as const;

const levelOf = (centre: number, radius: number, other: { x: number; y: number }) =>
  resolveLevel({
    version: 1,
    name: 'carried range',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 0, y: 9000 },
    recoil: true,
    asteroids: [
      { x: centre, y: 0, radius },
      { ...other, radius: 16 },
    ],
  });

const isProved = (centre: number, radius: number, x: number, y: number): boolean =>
  proveBy('line-trap', levelOf(centre, radius, { x, y }), HOLE, { accuracy: 'standard', maxTime: SECONDS }) !== null;

/** The least distance from the line, px, at which the other asteroid may be for the proof to hold; found by halving. */
function nearestProved(centre: number, radius: number, x: number): number {
  let [no, yes] = [0, 1000];
  while (yes - no > 0.1) {
    const y = (no + yes) / 2;
    if (isProved(centre, radius, x, y)) yes = y;
    else no = y;
  }
  return yes;
}

it('no play comes nearer to another asteroid that is as near to the line as the proof allows', () => {
  let closest = Number.POSITIVE_INFINITY;
  let far = 0;
  const at = ({ s, rocks }: Look) => s[0] - rocks[0];
  const speed = ({ s }: Look) => s[2];
  fc.assert(
    fc.property(
      real(20, 240),
      fc.constantFrom(4, 8, 16, 32),
      real(-1.5, 1.5),
      fc.array(real(0, 1), { minLength: 3, maxLength: 3 }),
      fc.infiniteStream(real(0, 1)),
      (centre, radius, part, [first, chance, within], numbers) => {
        const x = centre + part * RANGE;
        const y = nearestProved(centre, radius, x);
        const level = levelOf(centre, radius, { x, y });
        const luck = () => numbers.next().value as number;
        const out = [[1], [-1], [1, -1]].map((sides) => lingering(PULL, RANGE, at, speed, sides, 2 * within));
        const random: Player = (_, number) => number < chance;
        // First carried to one side, then off to the other.
        const turning = [out[0], out[1]].map((one, i): Player => {
          let tick = 0;
          return (look, number) => (tick++ < first * SECONDS * 60 ? one : out[1 - i])(look, number);
        });
        for (const player of [...out, ...turning, random]) {
          for (const { s, rocks } of watch(level, 'standard', SECONDS * 60, player, luck)) {
            if (s[1] !== 0) expect.fail(`${s[1]} px off the line`);
            const spare = Math.hypot(s[0] - x, s[1] - y) - Math.abs(s[0] - rocks[0]);
            if (spare < 0) expect.fail(`nearer to the other asteroid by ${-spare} px`);
            closest = Math.min(closest, spare);
            far = Math.max(far, Math.abs(rocks[0] - centre));
          }
        }
      },
    ),
    { numRuns: 12 },
  );
  // Otherwise nothing was at stake.
  expectDeep(closest).toBeLessThan(10);
  expectDeep(far).toBeGreaterThan(50);
});

it('a level that only the carried range opens is not proved impossible', () => {
  const range = 100;
  const withHole = (x: number) =>
    resolveLevel({
      version: 1,
      name: 'opened by recoil',
      range,
      astronaut: { x: 0, y: 0 },
      blackHole: { x, y: 0, radius: 18 },
      recoil: true,
      asteroids: [{ x: 70, y: 0, radius: 16 }],
    });
  const energy = (far: number) => PULL * (far - (far * far) / (2 * range));
  /** She lingers at the end of the range beyond the asteroid, is turned back soon on this side, and lets go at last. */
  const play = (within: number, letGo: number) => {
    const held: [number, number][] = [];
    let tick = 0;
    const player: Player = ({ s, rocks }) => {
      const at = s[0] - rocks[0];
      const outwards = at < 0 ? -s[2] : s[2];
      const turn = at < 0 ? 0.26 * range : range - within;
      // where she would be after another tick
      const next = Math.abs(at) + outwards * TICK;
      const brakes = next > turn || (outwards * outwards) / 2 > energy(turn) - energy(next);
      const falls = outwards * outwards < (at < 0 ? 0.05 : 0.56) * PULL * range;
      const now = outwards < 0 ? falls : brakes && tick < letGo;
      if (now && held.at(-1)?.[1] === tick) held[held.length - 1][1]++;
      else if (now) held.push([tick, tick + 1]);
      tick++;
      return now;
    };
    const looks = watch(withHole(9000), 'precise', SECONDS * 60, player, () => 0);
    return { held, farthest: Math.max(...looks.map(({ s }) => s[0])) };
  };
  const plays = [0.7, 1].flatMap((within) => Array.from({ length: 12 }, (_, i) => play(within, 60 * (34 + 2 * i))));
  const { held, farthest } = plays.reduce((a, b) => (b.farthest > a.farthest ? b : a));
  // Without recoil she would be lost at 170 px.
  expect(farthest).toBeGreaterThan(174);

  const opened = withHole(farthest + 10 + 18 - 0.1);
  expect(simulate(compile(opened, 'precise'), held, { maxTime: SECONDS }).outcome).toBe('completed');
  expect(proveImpossible(opened, { accuracy: 'precise', maxTime: SECONDS })).toBeNull();
  const most = (1.01 * SECONDS * SECONDS) / (4 * 16);
  expect(proveImpossible(withHole(70 + range + most + 10 + 18 + 0.1), { accuracy: 'precise', maxTime: SECONDS })?.code).toBe(
    'line-trap',
  );
});
