import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import { formatLevel, type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { createPackJudge, packLevel, THEME_NAMES, type ThemeName } from '../../solver/index.ts';
import { compose } from '../../solver/make/generate/compose.ts';
import { specOf } from '../../solver/make/generate/generator-spec.ts';
import { emptyLayout, type Layout } from '../../solver/make/generate/layout.ts';
import { toLevel } from '../../solver/make/generate/level-file.ts';
import { findRoute, type Route } from '../../solver/make/generate/route.ts';
import { DIRECTIONS, TURN } from '../../solver/make/generate/themes/directions.ts';
import { bestImage, Site, symmetryOf, THEMES, withImages } from '../../solver/make/generate/themes/index.ts';
import { createRandom } from '../../solver/random.ts';
import { someOf } from '../depth.ts';
import { once } from '../once.ts';

interface Place {
  readonly x: number;
  readonly y: number;
}

const away = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

// Seeds whose layouts have a route that suits the theme.
const SEEDS: Readonly<Record<ThemeName, readonly number[]>> = {
  orbits: [4, 5],
  corridors: [0, 1],
  slings: [11, 14],
  lures: [2],
  fields: [3, 4],
};

/** Runs a generator to its end. */
function finish<T>(steps: Generator<number, T>): T {
  let step = steps.next();
  while (step.done !== true) step = steps.next();
  return step.value;
}

/** Composed levels of a theme, before they are made harder. */
function composed(theme: ThemeName): { level: Level; route: Route }[] {
  const asked = specOf({ seed: 0, theme, difficulty: 'easy' });
  const spec = { ...asked, ...THEMES[theme].adjust(asked) };
  const made: { level: Level; route: Route }[] = [];
  for (const seed of SEEDS[theme]) {
    const random = createRandom(seed);
    const site = new Site(spec, random);
    const route = THEMES[theme].arrange(site) ? finish(findRoute(site.layout, spec, random, THEMES[theme])) : null;
    if (route === null) continue;
    const around = finish(compose(route, spec, THEMES[theme], random));
    if (typeof around !== 'string') made.push({ level: toLevel(around.layout), route });
  }
  return made;
}

/** Her centre in each tick of a run. */
function pathOf(level: Level, { run }: Route): { places: Place[]; outcome: string } {
  const played = simulate(compile(level, 'arcade'), run.holds);
  const state = new Float64Array(STATE_SIZE);
  const places: Place[] = [];
  for (let tick = 0; tick * TICK < played.time; tick++) {
    played.trajectory.at(tick * TICK, state);
    places.push({ x: state[0], y: state[1] });
  }
  return { places, outcome: played.outcome };
}

/** What each theme promises, measured another way. */
const MEASURED_ANEW: Readonly<Record<ThemeName, (level: Level, places: Place[], route: Route) => boolean>> = {
  // more than half around one asteroid, by the angle
  orbits: ({ asteroids }, places) =>
    asteroids.some((asteroid) => {
      let [swept, most] = [0, 0];
      for (let i = 1; i < places.length; i++) {
        const [a, b] = [places[i - 1], places[i]].map(({ x, y }) => Math.atan2(y - asteroid.y, x - asteroid.x));
        swept += Math.atan2(Math.sin(b - a), Math.cos(b - a));
        most = Math.max(most, Math.abs(swept));
      }
      return most > Math.PI;
    }),
  // from most of the route a line across it meets a nova on both sides, not far away
  corridors: ({ novae }, places) => {
    const middle = places.filter((place) => away(place, places[0]) > 60 && away(place, places[places.length - 1]) > 60);
    const sheltered = middle.filter((place, i) => {
      const next = middle[Math.min(i + 1, middle.length - 1)];
      const sides = novae
        .filter((nova) => away(nova, place) < 115)
        .map((nova) => Math.sign((next.x - place.x) * (nova.y - place.y) - (next.y - place.y) * (nova.x - place.x)));
      return sides.includes(1) && sides.includes(-1);
    });
    return sheltered.length >= 0.5 * middle.length;
  },
  // she covers a long way while the gun is not held
  slings: (_, places, { run }) => {
    let free = 0;
    for (let tick = 1; tick < places.length; tick++) {
      if (!run.holds.some(([press, release]) => tick >= press && tick < release)) free += away(places[tick - 1], places[tick]);
    }
    return free >= 2 * THEMES.slings.least(specOf({ seed: 0 })) - 20;
  },
  // a mineral that she does not come near, with novae on a part of a circle around it: more than a fifth, and not all around
  lures: ({ minerals, novae }, places) =>
    minerals.some((mineral) => {
      const arc = novae.filter((nova) => away(nova, mineral) < 70).map(({ x, y }) => Math.atan2(y - mineral.y, x - mineral.x));
      arc.sort((a, b) => a - b);
      const gaps = arc.map((angle, i) => (i + 1 < arc.length ? arc[i + 1] - angle : arc[0] + 2 * Math.PI - angle));
      const open = Math.max(...gaps);
      return (
        arc.length >= 3 && open > 0.6 * Math.PI && open < 1.6 * Math.PI && places.every((place) => away(place, mineral) > 48)
      );
    }),
  fields: ({ repulsors }, places) =>
    places.filter((place) => repulsors.some((field) => away(field, place) < field.radius)).length >= 0.11 * places.length,
};

describe.each(someOf(THEME_NAMES, 2))('a level composed around %s', (theme) => {
  const made = once(() => composed(theme));

  it('is of the theme, by another measure, and its route completes it', () => {
    expect(made().length).toBe(SEEDS[theme].length);
    for (const { level, route } of made()) {
      const { places, outcome } = pathOf(level, route);
      expect(outcome).toBe('completed');
      expect(MEASURED_ANEW[theme](level, places, route)).toBe(true);
    }
  });

  it('has no objects that touch, and none that is cut off', () => {
    const { width, height } = specOf({ seed: 0 });
    for (const { level } of made()) {
      const bodies = [level.blackHole, ...level.asteroids, ...level.novae, ...level.repulsors, ...level.aliens];
      for (const [i, a] of bodies.entries()) {
        expect(Math.min(a.x, a.y) - a.radius).toBeGreaterThanOrEqual(20);
        expect(a.x + a.radius).toBeLessThanOrEqual(width - 20);
        expect(a.y + a.radius).toBeLessThanOrEqual(height - 20);
        for (const b of bodies.slice(i + 1)) expect(away(a, b)).toBeGreaterThanOrEqual(a.radius + b.radius + 12);
      }
    }
  });
});

describe('symmetry', () => {
  const spec = specOf({ seed: 0, theme: 'orbits' });
  const nova = fc.record({ x: fc.integer({ min: 60, max: 740 }), y: fc.integer({ min: 60, max: 540 }), radius: fc.constant(12) });

  it('gives every nova a counterpart that fits, and the counterpart of that is the nova', () => {
    fc.assert(
      fc.property(fc.array(nova, { maxLength: 6 }), fc.constantFrom('mirror', 'rotate'), (novae, kind) => {
        const layout: Layout = {
          ...emptyLayout(spec),
          start: { x: 4000, y: 4000, vx: 0, vy: 0 },
          blackHole: { x: -4000, y: 700, radius: 18 },
          asteroids: [{ x: 400, y: 300, radius: 16, hot: false }],
        };
        const site = new Site(spec, createRandom(1), layout);
        for (const one of novae) site.nova(one, one.radius);
        const placed = site.layout.novae.length;
        const image = bestImage(kind, site);
        if (image === null) throw new Error('expected an image');
        for (const one of site.layout.novae) expect(away(image(image(one)), one)).toBeLessThan(1.5);
        const full = withImages(new Site(spec, createRandom(1), site.layout), image);
        expect(full.novae.slice(0, placed)).toEqual(site.layout.novae);
        const singles = full.novae.filter((one) => full.novae.every((other) => away(image(one), other) > 6)).length;
        expect(symmetryOf(full, image)).toBeCloseTo(1 - singles / Math.max(1, full.novae.length), 9);
      }),
      { numRuns: 40 },
    );
  });

  it('has directions of length 1 at equal angles', () => {
    for (const [i, { x, y }] of DIRECTIONS.entries()) {
      expect(x).toBeCloseTo(Math.cos((2 * Math.PI * i) / TURN), 12);
      expect(y).toBeCloseTo(Math.sin((2 * Math.PI * i) / TURN), 12);
    }
  });
});

describe('a pack', () => {
  it('has rising grades, a seed for each try, and every theme in turn if mixed', () => {
    fc.assert(
      fc.property(fc.integer({ min: 2, max: 40 }), fc.nat(1000), (count, seed) => {
        const pack = { count, seed, theme: 'mixed', grades: [2, 6] } as const;
        const tries = [0, 1, 2].flatMap((round) => Array.from({ length: count }, (_, i) => packLevel(pack, i, round)));
        expect(new Set(tries.map((one) => one.seed)).size).toBe(3 * count);
        const grades = tries.slice(0, count).map(({ difficulty }) => Number(difficulty));
        expect(grades).toEqual([...grades].sort((a, b) => a - b));
        expect([grades[0], grades[count - 1]]).toEqual([2, 6]);
        expect(new Set(tries.map(({ theme }) => theme)).size).toBe(Math.min(count, THEME_NAMES.length));
      }),
    );
  });

  it('rejects a level that is a mirror image of an earlier one, and one of the same name', () => {
    const file: LevelFile = {
      version: 1,
      name: 'One',
      astronaut: { x: 100, y: 300 },
      blackHole: { x: 500, y: 180 },
      asteroids: [
        { x: 240, y: 280, radius: 16 },
        { x: 420, y: 120, radius: 32 },
      ],
      novae: [{ x: 300, y: 420, radius: 16 }],
      runs: [{ name: 'solution', holds: [[10, 90]] }],
    };
    const turned = {
      ...file,
      name: 'Two',
      astronaut: { x: -100, y: 300 },
      blackHole: { x: -500, y: 180 },
      asteroids: file.asteroids?.map((asteroid) => ({ ...asteroid, x: -asteroid.x })),
      novae: file.novae?.map((one) => ({ ...one, x: -one.x })),
    };
    const judge = createPackJudge();
    expect([judge.accepts(file), judge.accepts(turned), judge.accepts({ ...file, name: 'Three' })]).toEqual([true, false, false]);
    expect(resolveLevel(turned).novae[0].x).toBe(-300);
    expect(formatLevel(file)).not.toBe(formatLevel(turned));
  });
});
