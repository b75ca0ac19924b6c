import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, STATE_SIZE, TICK } from '../../engine/index.ts';
import { type Level, NO_OBJECTS, rulesOf } from '../../schema/index.ts';
import { type Certificate, type OrbitGrid, type Proof, verifyProof } from '../../solver/index.ts';
import { claimOf } from '../../solver/verify/claim.ts';
import { angleOf, cosineAndSine } from '../../solver/verify/orbits/arithmetic.ts';
import { type OrbitBox, OrbitSets } from '../../solver/verify/orbits/index.ts';
import { expectDeep, itQuick } from '../depth.ts';
import { real } from '../real.ts';
import { someRules } from './some-rules.ts';

const whole = (min: number, max: number) => fc.integer({ min, max });
const HOLE = { kind: 'blackHole' } as const;
const AWAY = { x: 0, y: 1e6, radius: 18 };

const EMPTY: Level = {
  name: 'orbits',
  description: '',
  astronaut: { x: 0, y: 0, vx: 0, vy: 0 },
  blackHole: AWAY,
  range: 250,
  recoil: false,
  ...NO_OBJECTS,
  runs: [],
};
const rock = (x: number, y: number, radius = 16, hot = false) => ({ id: null, x, y, radius, hot });

/** Held or free, each for so many ticks; `pump` holds while she approaches the nearest asteroid, `brake` while she leaves it. */
const script = fc.array(fc.tuple(whole(1, 40), fc.constantFrom('held', 'free', 'pump', 'brake')), {
  minLength: 8,
  maxLength: 16,
});
type Script = readonly (readonly [number, string])[];

/** Her state relative to an asteroid. */
interface Relative {
  readonly x: number;
  readonly y: number;
  readonly vx: number;
  readonly vy: number;
}

/** Her state at a tick relative to each asteroid, and which of them was the nearest. */
interface Moment {
  readonly to: readonly Relative[];
  readonly nearest: number;
}

/**
 * Plays a script and returns her states at all ticks while the run went on. The velocities of asteroids follow from their
 * places: they are accelerated only by recoil, so between two ticks by a constant amount.
 */
function momentsOf(level: Level, plan: Script): Moment[] {
  const simulation = createSimulation(compile(level));
  const state = new Float64Array(STATE_SIZE);
  const rocks = new Float64Array(2 * level.asteroids.length);
  const seen: { s: number[]; rocks: number[] }[] = [];
  const nearestTo = ({ s, rocks: r }: (typeof seen)[number]) =>
    level.asteroids
      .map((_, i) => Math.hypot(r[2 * i] - s[0], r[2 * i + 1] - s[1]))
      .reduce((best, d, i, all) => (d < all[best] ? i : best), 0);
  const look = () => {
    simulation.readState(state);
    simulation.readAsteroids(rocks);
    seen.push({ s: [...state], rocks: [...rocks] });
  };
  look();
  for (const [ticks, how] of plan) {
    for (let n = 0; n < ticks && simulation.ending === null; n++) {
      const now = seen[seen.length - 1];
      const i = nearestTo(now);
      const [x, y, vx, vy] = now.s;
      const nears = (now.rocks[2 * i] - x) * vx + (now.rocks[2 * i + 1] - y) * vy > 0;
      simulation.advance(1, how === 'held' || (how === 'pump' && nears) || (how === 'brake' && !nears));
      if (simulation.ending === null) look();
    }
  }
  // The last moment is left out: it has no later one from which to see how fast asteroids are.
  return seen.slice(0, level.recoil ? -1 : undefined).map((now, k) => {
    const [x, y, vx, vy] = now.s;
    const speed = (n: number) => (k === 0 || !level.recoil ? 0 : (seen[k + 1].rocks[n] - seen[k - 1].rocks[n]) / (2 * TICK));
    const to = level.asteroids.map((_, i) => ({
      x: x - now.rocks[2 * i],
      y: y - now.rocks[2 * i + 1],
      vx: vx - speed(2 * i),
      vy: vy - speed(2 * i + 1),
    }));
    return { to, nearest: nearestTo(now) };
  });
}

const momentum = ({ x, y, vx, vy }: Relative): number => x * vy - y * vx;

/** The greatest error of a velocity that is computed from the places of asteroids, px/s. */
const blurOf = (level: Level): number =>
  level.recoil ? Math.max(...level.asteroids.map(({ radius }) => rulesOf(level).recoil / (2 * radius))) * TICK : 0;

const around = fc.tuple(real(-200, 200), real(-200, 200), fc.constantFrom(0.5, 4, 16, 32), fc.boolean());
const start = fc.tuple(real(0, 6.3), fc.constantFrom(0, 20, 60, 120));

/** Levels without fields and winds, in which she can fly for a while. */
const plainLevel = fc
  .record({
    first: fc.tuple(real(5, 200), real(0, 6.3), fc.constantFrom(0.5, 16, 32)),
    more: fc.array(around, { maxLength: 7 }),
    start,
    recoil: fc.boolean(),
  })
  .map(({ first: [d, turn, radius], more, start: [to, speed], recoil }): Level => {
    const asteroids = [
      rock(d * Math.cos(turn), d * Math.sin(turn), radius),
      ...more.map(([x, y, r, hot]) => rock(x, y, r, hot && Math.hypot(x, y) > r + 20)),
    ];
    return { ...EMPTY, recoil, asteroids, astronaut: { x: 0, y: 0, vx: speed * Math.cos(to), vy: speed * Math.sin(to) } };
  });

describe('momentum: relative to the nearest asteroid, angular momentum is preserved while it stays the nearest', () => {
  it('held or not, with and without recoil', () => {
    let compared = 0;
    let switches = 0;
    fc.assert(
      fc.property(plainLevel, script, (level, plan) => {
        const all = momentsOf(level, plan);
        const blur = blurOf(level);
        for (let k = 1; k < all.length; k++) {
          const { nearest, to } = all[k];
          const before = all[k - 1];
          if (before.nearest !== nearest) switches++;
          // Between the ticks another one may have been the nearest.
          const isClear = [to, before.to].every((seen) =>
            seen.every(({ x, y }, i) => i === nearest || Math.hypot(x, y) > Math.hypot(seen[nearest].x, seen[nearest].y) + 10),
          );
          if (before.nearest !== nearest || !isClear) continue;
          compared++;
          const [a, b] = [before.to[nearest], to[nearest]];
          const size = Math.hypot(a.x, a.y) * (1 + Math.hypot(a.vx, a.vy));
          expect(Math.abs(momentum(b) - momentum(a))).toBeLessThan(1e-9 * (size + 1) + 2 * blur * (1 + Math.hypot(b.x, b.y)));
        }
      }),
      { numRuns: 100 },
    );
    expectDeep(compared).toBeGreaterThan(5000);
    expectDeep(switches).toBeGreaterThan(20);
  });
});

/** Whether a state lies in a box. */
function isIn(box: OrbitBox, { x, y, vx, vy }: Relative, blur: number): boolean {
  const d = Math.hypot(x, y);
  const within = (n: number, [least, most]: readonly [number, number], slack: number) => n >= least - slack && n <= most + slack;
  if (!within(x * vy - y * vx, box.momentum, 1e-5 + blur * d)) return false;
  if (box.kind === 'near')
    return within(x, box.x, 1e-8) && within(y, box.y, 1e-8) && within(vx, box.vx, 1e-7 + blur) && within(vy, box.vy, 1e-7 + blur);
  const turns = Math.round(((box.angle[0] + box.angle[1]) / 2 - Math.atan2(y, x)) / (2 * Math.PI));
  return (
    within(d, box.distance, 1e-8) &&
    within(Math.atan2(y, x) + turns * 2 * Math.PI, box.angle, 1e-9) &&
    within((x * vx + y * vy) / d, box.rate, 1e-7 + blur)
  );
}

const someGrid = fc
  .record({ size: fc.constantFrom(3, 4, 6, 10, 25), part: fc.constantFrom(20, 50, 100), frames: fc.constantFrom(1, 2, 4, 6, 10) })
  .map(({ size, part, frames }): OrbitGrid => ({ place: size, speed: size, momentum: part * size, frames }));

const circle = (x: number, y: number, radius: number) => ({ id: null, x, y, radius });
const place = fc.tuple(real(-150, 150), real(-150, 150));

/** Any level, often with fields, winds and novae. */
const anyLevel = fc
  .record({
    level: plainLevel,
    fields: fc.array(place, { maxLength: 2 }),
    winds: fc.array(fc.tuple(place, real(-30, 30), real(-30, 30)), { maxLength: 1 }),
    novae: fc.array(place, { maxLength: 2 }),
    rules: fc.option(someRules, { freq: 3, nil: undefined }),
  })
  .map(
    ({ level, fields, winds, novae, rules }): Level => ({
      ...level,
      repulsors: fields.map(([x, y]) => circle(x, y, 40)),
      winds: winds.map(([[x, y], ax, ay]) => ({ ...circle(x, y, 60), ax, ay })),
      novae: novae.filter(([x, y]) => Math.hypot(x, y) > 60).map(([x, y]) => circle(x, y, 32)),
      ...(rules === undefined ? {} : { rules }),
    }),
  );

describe('the sets contain everything that she can do', () => {
  it('in any level, over any grid, at the end of every step', () => {
    let looked = 0;
    const kinds = new Set<string>();
    fc.assert(
      fc.property(anyLevel, someGrid, fc.array(script, { minLength: 3, maxLength: 3 }), (level, grid, plans) => {
        const sets = new OrbitSets(claimOf(level, HOLE, 60, 'exact'), grid);
        const layers = [[...sets.all()]];
        while (layers.length < 80 && sets.total < 5000) {
          sets.advance();
          if (sets.why !== null) break;
          layers.push([...sets.all()]);
        }
        if (layers.length === 1) return;
        const blur = blurOf(level);
        for (const plan of plans) {
          const moments = momentsOf(level, plan);
          for (let n = 0; n < layers.length && n * grid.frames < moments.length; n++) {
            const { to } = moments[n * grid.frames];
            const box = layers[n].find((one) => isIn(one, to[one.asteroid], blur));
            expect(box, `step ${n}`).toBeDefined();
            kinds.add(box?.kind ?? '');
            looked++;
          }
        }
      }),
      { numRuns: 40 },
    );
    expectDeep(looked).toBeGreaterThan(1500);
    expectDeep([...kinds].sort()).toEqual(['far', 'near']);
  });
});

describe('angles', () => {
  const out = new Float64Array(2);

  it('cosine and sine are right to 1e-15', () => {
    fc.assert(
      fc.property(real(-20, 20), (angle) => {
        cosineAndSine(angle, out, 0);
        expect(Math.abs(out[0] - Math.cos(angle))).toBeLessThan(6e-15);
        expect(Math.abs(out[1] - Math.sin(angle))).toBeLessThan(6e-15);
      }),
      { numRuns: 2000 },
    );
  });

  it('the angle of a vector is, too, in every eighth and on the axes', () => {
    fc.assert(
      fc.property(real(-3, 3), real(-3, 3), (x, y) => {
        for (const [a, b] of [
          [x, y],
          [x, 0],
          [0, y],
          [x, x],
          [x, -x],
          [x, 1e-12 * y],
        ])
          expect(Math.abs(angleOf(a, b) - Math.atan2(b, a))).toBeLessThan(1e-14);
      }),
      { numRuns: 2000 },
    );
    expect(angleOf(0, 0)).toBe(0);
  });
});

/** A start that soon leaves the range of the only asteroid. */
const LEAVING: Level = { ...EMPTY, asteroids: [rock(200, 0)], astronaut: { x: 0, y: 0, vx: -60, vy: 20 } };
const GRID: OrbitGrid = { place: 4, speed: 4, momentum: 200, frames: 4 };
const proofWith = (certificate: unknown, more: Partial<Proof> = {}): Proof => ({
  code: 'orbits',
  about: HOLE,
  reason: '',
  covers: ['precise'],
  maxTime: null,
  certificate: certificate as Certificate,
  ...more,
});
const whyNot = (level: Level, certificate: unknown, more?: Partial<Proof>): string | null => {
  const result = verifyProof(level, proofWith(certificate, more));
  return result.ok ? null : result.why;
};

describe('certificates', () => {
  const good = { kind: 'orbits', grid: GRID, steps: 40 };

  it('is accepted', () => {
    expect(whyNot(LEAVING, good)).toBeNull();
  });

  it.each(['arcade', 'fast', 'standard'] as const)('does not cover %s', (accuracy) => {
    expect(whyNot(LEAVING, good, { covers: [accuracy] })).toBe('with fixed steps her angular momentum is not preserved');
    expect(whyNot(LEAVING, good, { covers: ['precise', accuracy] })).toBe(
      'with fixed steps her angular momentum is not preserved',
    );
  });

  it('with recoil it says for how long', () => {
    const recoil = { ...LEAVING, recoil: true };
    expect(whyNot(recoil, good)).toBe('with recoil it must say how long a run may last');
    expect(whyNot(recoil, good, { maxTime: 60 })).toBeNull();
  });

  const WRONG = [
    Number.NaN,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
    -4,
    0,
    1e-300,
    1e300,
    '4',
    null,
    undefined,
    [4],
    {},
  ];

  it.each(Object.keys(GRID))('a grid needs a sensible %s', (name) => {
    for (const value of WRONG)
      expect(whyNot(LEAVING, { ...good, grid: { ...GRID, [name]: value } })).toBe('its grid is not valid');
  });

  it('frames and steps are whole numbers, and there is a grid', () => {
    expect(whyNot(LEAVING, { ...good, grid: { ...GRID, frames: 2.5 } })).toBe('its grid is not valid');
    for (const value of [...WRONG, 2.5])
      expect(whyNot(LEAVING, { ...good, steps: value })).toBe('its number of steps is not valid');
    for (const grid of [undefined, null, 4, [], {}]) expect(whyNot(LEAVING, { ...good, grid })).toBe('its grid is not valid');
  });

  it('the ends of what is allowed', () => {
    const ends = { place: [0.25, 50], speed: [0.25, 1000], momentum: [1, 1e6], frames: [1, 60] };
    for (const [name, [least, most]] of Object.entries(ends)) {
      for (const [value, beyond] of [
        [least, 0.99 * least],
        [most, 1.01 * most],
      ]) {
        expect(whyNot(LEAVING, { ...good, grid: { ...GRID, [name]: value }, steps: 1 })).not.toBe('its grid is not valid');
        expect(whyNot(LEAVING, { ...good, grid: { ...GRID, [name]: beyond }, steps: 1 })).toBe('its grid is not valid');
      }
    }
  });

  it('needs as many steps as it takes, and no more', () => {
    const steps = Array.from({ length: 40 }, (_, n) => n + 1).find(
      (n) => whyNot(LEAVING, { ...good, steps: n }) === null,
    ) as number;
    expect(whyNot(LEAVING, { ...good, steps: steps - 1 })).toBe(`some runs may continue after ${steps - 1} steps`);
    expect(whyNot(LEAVING, { ...good, steps: 10_000 })).toBeNull();
  });

  it('refuses levels without an asteroid, and lengths at which rounding matters', () => {
    expect(whyNot({ ...LEAVING, asteroids: [] }, good)).toBe('there is no asteroid');
    expect(whyNot({ ...LEAVING, range: 2e6 }, good)).toBe('the range is too large');
    expect(whyNot({ ...LEAVING, asteroids: [rock(2e6, 0)] }, good)).toBe('she starts too far from every asteroid');
  });

  it('a run that is over at the start still touches what is there', () => {
    const over = { ...EMPTY, asteroids: [rock(0, 0, 32, true)], minerals: [circle(25, 0, 7)] };
    expect(whyNot(over, good)).toBeNull();
    expect(whyNot(over, good, { about: { kind: 'mineral', index: 0 } })).toBe('she may touch it in step 0');
  });

  itQuick('refuses what would take too long', () => {
    const orbiting = { ...EMPTY, asteroids: [rock(60, 0)], astronaut: { x: 0, y: 0, vx: 0, vy: 30 } };
    // A few steps into far too many cells each.
    const tiny = { kind: 'orbits', grid: { place: 0.25, speed: 0.25, momentum: 1, frames: 60 }, steps: 10 };
    expect(whyNot(orbiting, tiny)).toBe('following her takes too many boxes');
  });
});
