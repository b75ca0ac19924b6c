import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, type RunEvent, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { continuousNames } from './accuracies.ts';
import { type PlainLevel, plainLevel } from './plain-level.ts';

const KINDS = ['nova', 'hot asteroid', 'black hole', 'mineral', 'alien'] as const;

interface Place {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

function withThing(kind: (typeof KINDS)[number], circle: Place, parts: PlainLevel): PlainLevel {
  switch (kind) {
    case 'nova':
      return { ...parts, novae: [circle] };
    case 'hot asteroid':
      return { ...parts, asteroids: [...(parts.asteroids ?? [{ x: 1e5, y: 1e5, radius: 16 }]), { ...circle, hot: true }] };
    case 'black hole':
      return { ...parts, blackHole: circle };
    case 'mineral':
      return { ...parts, minerals: [circle] };
    default:
      return { ...parts, aliens: [circle] };
  }
}

/** The time of her first contact, s; null if there is none. */
function touchTime(parts: PlainLevel, holds: readonly Hold[], accuracy: (typeof continuousNames)[number]): number | null {
  const run = simulate(compile(plainLevel(parts), accuracy), holds, { maxTime: 0.25 });
  const touches = run.events.filter(({ type }) => type === 'mineral' || type === 'collided' || type === 'completed');
  return touches[0]?.time ?? null;
}

const ULP_BELOW_26 = 26 - 2 ** -48;

describe.each(continuousNames)('a start at which box and circle exactly touch, %s', (accuracy) => {
  describe.each(KINDS)('%s', (kind) => {
    const touch = (x: number, parts: PlainLevel, holds: readonly Hold[] = []) =>
      touchTime(withThing(kind, { x, y: 0, radius: 16 }, parts), holds, accuracy);

    it('is an immediate contact if she moves into it, and none if she rests, slides along or moves away', () => {
      expect(touch(26, { astronaut: { vx: 40 } })).toBe(0);
      expect(touch(26, { astronaut: { vx: 1e-3 } })).toBe(0);
      expect(touch(26, { astronaut: { vx: -40 } })).toBeNull();
      if (kind === 'alien') return;
      expect(touch(26, {})).toBeNull();
      expect(touch(26, { astronaut: { vy: 40 } })).toBeNull();
    });

    it('is decided correctly with one unit of the last digit more or less distance', () => {
      expect(touch(ULP_BELOW_26, {})).toBe(0);
      expect(touch(ULP_BELOW_26, { astronaut: { vx: -40 } })).toBe(0);
      const later = touch(26 + 2 ** -48, { astronaut: { vx: 2 ** -20 } });
      // 2^-48 px at 2^-20 px/s; an alien comes to meet her
      if (kind === 'alien') expect(later).toBeLessThan(2 ** -24);
      else expect(later).toBeCloseTo(2 ** -28, 14);
    });

    if (kind === 'hot asteroid') return;
    it('is an immediate contact if the gun pulls her into it from rest, and none if it pulls her away', () => {
      const holds: Hold[] = [[0, 60]];
      const asteroids = (x: number) => [{ x, y: 0, radius: 16 }];
      expect(touch(26, { asteroids: asteroids(100) }, holds)).toBe(0);
      if (kind === 'alien') return;
      expect(touch(26, { asteroids: asteroids(-100) }, holds)).toBeNull();
    });
  });
});

describe.each(continuousNames)('an exact touch as the gun is held from the first tick, %s', (accuracy) => {
  // the pull leads away along this side of her box, the wind or the alien towards her along the other
  const SIDES = [
    { x: 26, y: 0, away: [-1, 0] },
    { x: -26, y: 0, away: [1, 0] },
    { x: 0, y: 32, away: [0, -1] },
    { x: 0, y: -32, away: [0, 1] },
  ] as const;

  const firstTouch = (level: Level, holds: readonly Hold[]) => {
    const { events } = simulate(compile(level, accuracy), holds, { maxTime: 0.25 });
    return events.find(({ type }) => type === 'mineral' || type === 'collided' || type === 'completed')?.time ?? null;
  };

  it('is a contact if the wind is stronger than the pull, and none if it is weaker', () => {
    fc.assert(
      fc.property(
        fc.constantFrom('nova', 'black hole', 'mineral', 'hot asteroid'),
        fc.constantFrom(...SIDES),
        fc.integer({ min: 1, max: 37 }),
        fc.integer({ min: 0, max: 360 }),
        fc.integer({ min: -400, max: 400 }),
        (kind, { x, y, away }, strength, delay, at) => {
          // she looks at the asteroid: across, her box reaches 16 px, but upright at the start 10 px
          const turnsAway = away[0] === 0;
          const asteroids = [{ x: at + 20 * away[0], y: -at + 20 * away[1], radius: 2 }];
          const level = (wind: number, pull: number): Level => {
            const thing = withThing(
              kind,
              { x: at + x, y: -at + y, radius: 16 },
              { asteroids, range: 2000, astronaut: { x: at, y: -at } },
            );
            const winds = [{ id: null, x: at, y: -at, radius: 500, ax: -away[0] * wind, ay: -away[1] * wind }];
            return { ...plainLevel(thing), winds, rules: { pull } };
          };
          expect(firstTouch(level(strength, 39), [[0, 600]])).toBeNull();
          // not held, or too late, she is blown into it; turned, her box is 6 px away
          expect(firstTouch(level(strength, 39), [])).toBe(0);
          expect(firstTouch(level(strength, 39), [[1 + delay, 600]])).toBe(0);
          if (turnsAway) expect(firstTouch(level(strength, strength / 2), [[0, 600]])).not.toBe(0);
          else expect(firstTouch(level(strength, strength / 2), [[0, 600]])).toBe(0);
        },
      ),
      { numRuns: 40 },
    );
  });

  it('of an alien is a contact if it follows faster than the pull leads away', () => {
    for (const { x, y, away } of SIDES) {
      const level = (alienPull: number): Level => ({
        ...plainLevel({
          asteroids: [{ x: 20 * away[0], y: 20 * away[1], radius: 2 }],
          range: 2000,
          aliens: [{ x, y, radius: 16 }],
        }),
        rules: { alienPull },
      });
      expect(firstTouch(level(8), [[0, 600]])).toBeNull();
      expect(firstTouch(level(8), [])).toBe(0);
      const turnsAway = away[0] === 0;
      if (!turnsAway) expect(firstTouch(level(60), [[0, 600]])).toBe(0);
    }
  });

  it('is none if the press turns the box away, however fast she moves', () => {
    const level = (vy: number): Level =>
      plainLevel({
        astronaut: { vy },
        novae: [{ x: 0, y: 32, radius: 16 }],
        asteroids: [{ x: 0, y: 300, radius: 4 }],
        range: 2000,
      });
    expect(firstTouch(level(40), [])).toBe(0);
    // turned downwards, her box reaches 10 px: 6 px to go at 40 px/s and more
    const later = firstTouch(level(40), [[0, 60]]);
    expect(later).toBeGreaterThan(0.12);
    expect(later).toBeLessThan(0.15);
  });

  it('waits for the press together with what begins at the same instant and comes before it', () => {
    // she touches the black hole and moves into it; an alien that comes to meet her touches a corner; the press turns her away
    const parts: PlainLevel = {
      astronaut: { vx: -4, vy: 3 },
      asteroids: [{ x: 0, y: 50, radius: 5 }],
      range: 50,
      aliens: [{ x: -13, y: -20, radius: 5 }],
      blackHole: { x: -40, y: 3, radius: 30 },
    };
    const endOf = (holds: readonly Hold[]) => simulate(compile(plainLevel(parts), accuracy), holds, { maxTime: 0.25 });
    expect(endOf([])).toMatchObject({ outcome: 'collided', time: 0 });
    expect(endOf([[0, 15]])).toMatchObject({ outcome: 'completed', time: 0 });
  });

  it('gives the same run if the ticks before the press are 0 or more', () => {
    const asteroids = [{ x: -20, y: 0, radius: 2 }];
    const scene = compile(
      {
        ...plainLevel({ asteroids, range: 2000, novae: [{ x: 26, y: 0, radius: 16 }] }),
        winds: [{ id: null, x: 0, y: 0, radius: 500, ax: 20, ay: 0 }],
      },
      accuracy,
    );
    const simulation = createSimulation(scene);
    simulation.advance(0, false);
    expect(simulation.ending).toBeNull();
    simulation.advance(10, true);
    expect(simulation.ending).toBeNull();
    simulation.reset();
    simulation.advance(0, false);
    simulation.advance(1, false);
    expect(simulation.ending).toMatchObject({ outcome: 'collided', time: 0, tick: 0 });
  });
});

describe.each(continuousNames)('of what she touches and overlaps at one instant, %s', (accuracy) => {
  const told = (parts: PlainLevel, holds: readonly Hold[] = []) =>
    simulate(compile(plainLevel(parts), accuracy), holds, { maxTime: 12 })
      .events.filter(({ type }) => ['mineral', 'collided', 'completed', 'lost'].includes(type))
      .map(({ type }) => type);
  const nova = { novae: [{ x: 26, y: 0, radius: 16 }] };

  it('what she overlaps at the start counts before what she then moves into', () => {
    const astronaut = { vx: 40 };
    const overlapped = { x: -12, y: 0, radius: 7 };
    expect(told({ astronaut, ...nova, minerals: [overlapped] })).toEqual(['mineral', 'collided']);
    expect(told({ astronaut, ...nova, blackHole: overlapped })).toEqual(['completed']);
    expect(told({ astronaut, novae: [overlapped], minerals: [{ x: 17, y: 0, radius: 7 }] })).toEqual(['collided']);
    expect(told({ astronaut, ...nova, asteroids: [{ x: 0, y: 200, radius: 16 }], range: 199 })).toEqual(['lost']);
    expect(told({ astronaut, ...nova, blackHole: { x: 26, y: 0, radius: 16 } })).toEqual(['collided']);
  });

  it('minerals come first, then hazards, then the black hole, at the start and on the way', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 0, max: 40 }),
        fc.constantFrom(1, 2, 3, 5, 8, 20, 40, 200, 1000),
        fc.constantFrom('nova', 'hot asteroid', 'alien'),
        fc.constantFrom(1, -1),
        fc.boolean(),
        (gap, speed, kind, side, sleeps) => {
          fc.pre(gap < 10 * speed);
          const ahead = (radius: number, beside: number) => ({ x: side * (10 + gap + radius), y: beside, radius });
          const parts = withThing(kind, ahead(16, 3), {
            astronaut: { vx: side * speed },
            minerals: [ahead(7, -5), ahead(7, 9)],
            blackHole: ahead(18, -8),
          });
          const still = kind !== 'alien' || sleeps ? { alienSight: 0 } : {};
          const run = simulate(compile({ ...plainLevel(parts), rules: still }, accuracy), [], { maxTime: 12 });
          // an alien that sees her comes to meet her
          if (kind === 'alien' && !sleeps && gap > 0) return;
          expect(run.events.map(({ type }) => type)).toEqual(['mineral', 'mineral', 'collided']);
        },
      ),
      { numRuns: 60 },
    );
  });
});

// turned by 3-4-5 and with a corner 3-4-5 from the centre of the circle nothing is rounded but sine and cosine
const turned: Place[] = [];
for (let i = -30; i <= 30; i++) {
  for (let j = -30; j <= 30; j++) {
    const [along, across] = [3 * i + 4 * j, 3 * j - 4 * i];
    const [gx, gy] = [Math.abs(along) - 10, Math.abs(across) - 16];
    const radius = gx > 0 && gy > 0 ? Math.hypot(gx, gy) : Math.max(gx, gy);
    if (radius > 0 && radius < 60 && Number.isInteger(radius)) turned.push({ x: 5 * i, y: 5 * j, radius });
  }
}

describe.each(continuousNames)('a press that turns the box into an exact touch, %s', (accuracy) => {
  const apart = turned.filter(({ x, y, radius }) => {
    const [gx, gy] = [Math.max(0, Math.abs(x) - 10), Math.max(0, Math.abs(y) - 16)];
    return gx * gx + gy * gy > (radius + 1) * (radius + 1);
  });

  it('is an immediate contact if the pull continues into it, and none if it leads away', () => {
    expect(apart.length).toBeGreaterThan(20);
    const holds: Hold[] = [[0, 60]];
    const found = { into: 0, away: 0 };
    for (const circle of apart) {
      // the asteroid is 250 px away along 3-4-5, she rests
      const [along, across] = [(3 * circle.x + 4 * circle.y) / 5, (3 * circle.y - 4 * circle.x) / 5];
      // a circle beside the box is passed along its side
      if (Math.abs(along) <= 10 && Math.abs(across) > 16) continue;
      const time = touchTime({ asteroids: [{ x: 150, y: 200, radius: 16 }], range: 1000, novae: [circle] }, holds, accuracy);
      expect.soft(time, JSON.stringify(circle)).toBe(along > 0 ? 0 : null);
      found[along > 0 ? 'into' : 'away']++;
    }
    expect(found.into).toBeGreaterThan(5);
    expect(found.away).toBeGreaterThan(5);
  });
});

describe.each(continuousNames)('a start exactly on a rim, %s', (accuracy) => {
  const firstOf = (type: RunEvent['type'], parts: PlainLevel, holds: readonly Hold[] = []) => {
    const run = simulate(compile(plainLevel(parts), accuracy), holds, { maxTime: 0.1 });
    return run.events.find((event) => event.type === type && !(event.type === 'target' && event.index === 0))?.time ?? null;
  };
  const holds: Hold[] = [[0, 6]];
  const asteroids = [{ x: 60, y: 80, radius: 16 }];

  it('crosses it at once if she moves or is pulled over it', () => {
    const repulsors = [{ x: 30, y: 40, radius: 50 }];
    expect(firstOf('enter', { repulsors, astronaut: { vx: 30, vy: 40 } })).toBeLessThan(1e-12);
    expect(firstOf('enter', { repulsors, asteroids }, holds)).toBeLessThan(1e-9);
    const aliens = [{ x: 90, y: 120, radius: 5 }];
    expect(firstOf('wake', { aliens, astronaut: { vx: 30, vy: 40 } })).toBeLessThan(1e-12);
    expect(firstOf('wake', { aliens, asteroids }, holds)).toBeLessThan(1e-9);
    expect(firstOf('lost', { asteroids, range: 100, astronaut: { vx: -30, vy: -40 } })).toBeLessThan(1e-12);
    const two = [...asteroids, { x: -60, y: 80, radius: 16 }];
    expect(firstOf('target', { asteroids: two, astronaut: { vx: -40 } }, holds)).toBeLessThan(1e-12);
  });

  it('of the ranges of two asteroids is not lost if she leaves one as she enters the other', () => {
    const two = [
      { x: -200, y: 0, radius: 20 },
      { x: -160, y: 120, radius: 20 },
    ];
    const along = plainLevel({ astronaut: { vy: 100 }, asteroids: two, range: 200 });
    expect(simulate(compile(along, accuracy), [], { maxTime: 0.25 }).outcome).toBe('timeout');
    const level = plainLevel({
      astronaut: { x: -50, vx: 100 },
      asteroids: [-200, 200].map((x) => ({ x, y: 0, radius: 20 })),
      range: 200,
    });
    expect(simulate(compile(level, accuracy), [], { maxTime: 2 }).outcome).toBe('timeout');
  });

  it('does not cross it while she rests or moves the other way', () => {
    const repulsors = [{ x: 30, y: 40, radius: 50 }];
    const aliens = [{ x: 90, y: 120, radius: 5 }];
    for (const astronaut of [{}, { vx: -30, vy: -40 }]) {
      expect(firstOf('enter', { repulsors, astronaut })).toBeNull();
      expect(firstOf('wake', { aliens, astronaut })).toBeNull();
    }
    for (const astronaut of [{}, { vx: 30, vy: 40 }]) expect(firstOf('lost', { asteroids, range: 100, astronaut })).toBeNull();
    const two = [...asteroids, { x: -60, y: 80, radius: 16 }];
    expect(firstOf('target', { asteroids: two, astronaut: { vx: 40 } }, holds)).toBeNull();
    expect(firstOf('target', { asteroids: two }, holds)).toBeNull();
  });
});
