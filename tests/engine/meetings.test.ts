import fc from 'fast-check';
import { expect, it } from 'vitest';
import { INDEXING } from '../../engine/box-index.ts';
import { MeetingsOfMany, NOBODY } from '../../engine/effects/aliens/meetings-of-many.ts';
import { unlimited } from '../../engine/index.ts';
import { ALERTNESS, type Motion, RECORDS, SLOTS } from '../../engine/motion/index.ts';
import { seeded } from '../scenes/seeded.ts';

const { CHASER } = RECORDS;
const PULL = 30;
/** Length of the piece, s. */
const H = 0.05;

interface Crowd {
  readonly count: number;
  readonly awake: readonly number[];
  readonly m: Motion;
  readonly meetings: MeetingsOfMany;
}

/** Aliens in a square, some of them asleep and some gone; those that are awake move. */
function crowdOf(
  seed: number,
  count: number,
  size: number,
  radius: number,
  shares: { readonly awake: number; readonly gone: number },
): Crowd {
  const random = seeded(seed);
  const chasers = 40;
  const s = new Float64Array(chasers + CHASER * count);
  const r = Float64Array.from({ length: count }, () => radius * (1 + random()));
  const awake: number[] = [];
  for (let i = 0; i < count; i++) {
    const o = chasers + CHASER * i;
    const drawn = random();
    s[o] = size * random();
    s[o + 1] = size * random();
    s[o + 4] = drawn < shares.awake ? ALERTNESS.AWAKE : drawn > 1 - shares.gone ? ALERTNESS.GONE : ALERTNESS.ASLEEP;
    if (s[o + 4] !== ALERTNESS.AWAKE) continue;
    awake.push(i);
    s[o + 2] = 100 * (random() - 0.5);
    s[o + 3] = 100 * (random() - 0.5);
  }
  s[SLOTS.AWAKE_COUNT] = awake.length;
  const scene = { aliens: { count, r } };
  const m = {
    s,
    chasers,
    scene,
    rules: { alienPull: PULL },
    budget: unlimited(),
    parts: { indexing: INDEXING },
  } as unknown as Motion;
  const asleep = Array.from({ length: count }, (_, i) => i).filter((i) => s[chasers + CHASER * i + 4] === ALERTNESS.ASLEEP);
  const meetings = new MeetingsOfMany(m, { awake: Int32Array.from({ ...awake, length: count }), sleepersAround: () => asleep });
  return { count, awake, m, meetings };
}

/** Every pair with an awake alien that may touch within the piece, and each awake alien after its pairs. */
function expected({ count, awake, m }: Crowd): [number, number][] {
  const { s, chasers, scene } = m;
  const list: [number, number][] = [];
  const far = (i: number) => {
    const o = chasers + CHASER * i;
    return s[o + 4] === ALERTNESS.AWAKE ? (Math.hypot(s[o + 2], s[o + 3]) + PULL * H) * H : 0;
  };
  for (let i = 0; i < count; i++) {
    for (let j = i + 1; j < count; j++) {
      const [a, b] = [chasers + CHASER * i, chasers + CHASER * j];
      const states = [s[a + 4], s[b + 4]];
      if (states.includes(ALERTNESS.GONE) || !states.includes(ALERTNESS.AWAKE)) continue;
      if (Math.hypot(s[a] - s[b], s[a + 1] - s[b + 1]) < scene.aliens.r[i] + scene.aliens.r[j] + far(i) + far(j))
        list.push([i, j]);
    }
    if (awake.includes(i)) list.push([i, NOBODY]);
  }
  return list;
}

function visited({ meetings }: Crowd, isEnough: () => boolean): [number, number][] {
  const list: [number, number][] = [];
  meetings.visit(H, isEnough, (i, j) => list.push([i, j]));
  return list;
}

/** An alien itself comes after its pairs. */
const rank = ([i, j]: readonly [number, number]): number => i * 1e6 + (j === NOBODY ? 999_999 : j);

function expectAll(crowd: Crowd): void {
  const found = visited(crowd, () => false);
  const ranks = found.map(rank);
  expect(ranks).toEqual([...new Set(ranks)].sort((a, b) => a - b));
  const there = new Set(ranks);
  // awake ones that move alike are compared with each other, so a pair may be missing that only opposite detours could bring together
  const { s, chasers } = crowd.m;
  const isAwake = (i: number) => s[chasers + CHASER * i + 4] === ALERTNESS.AWAKE;
  const mustBe = expected(crowd).filter(([i, j]) => j === NOBODY || !(isAwake(i) && isAwake(j)));
  expect(mustBe.filter((pair) => !there.has(rank(pair)))).toEqual([]);
}

it('of many aliens are found in the order of all pairs', () => {
  const crowd = fc.record({
    seed: fc.nat(),
    count: fc.integer({ min: 17, max: 200 }),
    size: fc.constantFrom(0, 1, 100, 1000),
    radius: fc.constantFrom(0.001, 5, 1e6),
    awake: fc.constantFrom(0.02, 0.3, 1),
  });
  fc.assert(
    fc.property(crowd, ({ seed, count, size, radius, awake }) => {
      expectAll(crowdOf(seed, count, size, radius, { awake, gone: 0.1 }));
    }),
  );
});

// 100,000 pairs with a sleeper are kept, and more are sought again one by one
it('of a crowd in one place are all found', () => {
  const crowd = crowdOf(1, 900, 1, 1e6, { awake: 0.5, gone: 0.01 });
  const found = visited(crowd, () => false);
  expect(found.map(rank)).toEqual(expected(crowd).map(rank));
  expect(found.length).toBeGreaterThan(250_000);
});

it('end as soon as no other pair matters', () => {
  const crowd = crowdOf(2, 900, 1, 1e6, { awake: 0.5, gone: 0 });
  expect(visited(crowd, () => true)).toEqual(crowd.awake.map((i) => [i, NOBODY]));
  let left = 1000;
  const some = visited(crowd, () => left-- <= 0);
  expect(some.length).toBeLessThan(1000 * crowd.count);
  expect(some.filter(([, j]) => j === NOBODY)).toHaveLength(crowd.awake.length);
});
