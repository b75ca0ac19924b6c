import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { accuracyNames, continuousNames } from './accuracies.ts';
import { type PlainLevel, plainLevel } from './plain-level.ts';

const even = (min: number, max: number) => fc.integer({ min: 0, max: 1_000_000 }).map((k) => min + ((max - min) * k) / 1e6);

type Mouths = readonly [x: number, y: number, toX: number, toY: number, radius: number];

const withMouths = (parts: PlainLevel, ...wormholes: readonly Mouths[]): Level => ({
  ...plainLevel(parts),
  wormholes: wormholes.map(([x, y, toX, toY, radius]) => ({ id: null, x, y, toX, toY, radius })),
});

const play = (level: Level, accuracy: (typeof accuracyNames)[number], seconds: number) => {
  const { final, events } = simulate(compile(level, accuracy), [], { maxTime: seconds });
  return { final, jumps: events.flatMap((event) => (event.type === 'effect' ? [event.index] : [])) };
};

describe.each(accuracyNames)('mouths of several wormholes, %s', (accuracy) => {
  it('that are one and the same let her out, from wherever and however she comes', () => {
    fc.assert(
      fc.property(
        fc.record({
          speed: even(20, 200),
          turn: fc.integer({ min: 0, max: 359 }),
          beside: even(-0.95, 0.95),
          radius: fc.constantFrom(10, 20, 33.3),
          x: even(-3000, 3000),
          y: even(500, 3000),
          sharing: fc.integer({ min: 1, max: 4 }),
          // the shared exit is the first or the second mouth of its wormholes
          swapped: fc.boolean(),
          before: fc.boolean(),
        }),
        ({ speed, turn, beside, radius, x, y, sharing, swapped, before }) => {
          const [cos, sin] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)];
          const [cx, cy] = [100 * cos - beside * radius * sin, 100 * sin + beside * radius * cos];
          const others = Array.from({ length: sharing }, (_, k): Mouths => {
            const away = [-4000 - 200 * k, -4000] as const;
            return swapped ? [x, y, ...away, radius] : [...away, x, y, radius];
          });
          const hers: Mouths = swapped ? [x, y, cx, cy, radius] : [cx, cy, x, y, radius];
          const start = { astronaut: { vx: speed * cos, vy: speed * sin } };
          const level = withMouths(start, ...(before ? [...others, hers] : [hers, ...others]));
          const ticks = Math.ceil((60 * 300) / speed);
          const { final, jumps } = play(level, accuracy, ticks / 60);
          expect(jumps).toEqual([before ? sharing : 0]);
          const far = (speed * ticks) / 60;
          expect(Math.hypot(final.x - (far * cos + x - cx), final.y - (far * sin + y - cy))).toBeLessThan(1e-8);
        },
      ),
      { numRuns: 60 },
    );
  });

  it('that are one and the same take her through the first wormhole in the file', () => {
    const flies = { astronaut: { vx: 60 } };
    const exits = [300, -300, 500];
    const level = withMouths(flies, ...exits.map((y): Mouths => [100, 3, 1000, y, 20]));
    expect(play(level, accuracy, 3)).toMatchObject({ jumps: [0], final: { y: 297 } });
    // there are so many that an index finds them
    const many = withMouths(flies, ...Array.from({ length: 100 }, (_, k): Mouths => [100, 3, 1000, 300 + 50 * k, 20]));
    expect(play(many, accuracy, 3)).toMatchObject({ jumps: [0], final: { y: 297 } });
  });

  it('do not fire where she comes out inside them or on their rims, and fire where she comes to them later', () => {
    const flies = { astronaut: { vx: 60 } };
    const [far, way]: [Mouths, Mouths] = [
      [1000, 0, 5000, 5000, 40],
      [100, 0, 1000, 0, 20],
    ];
    // into a larger mouth of another wormhole: out of it without a jump
    expect(play(withMouths(flies, way, far), accuracy, 4)).toMatchObject({ jumps: [0], final: { y: 0 } });
    // onto the rim of one from within, and of one that she enters there
    for (const x of [1020, 1000, 980]) {
      const other: Mouths = [x, 0, 5000, 5000, Math.abs(x - 980) || 20];
      expect(play(withMouths(flies, way, other), accuracy, 1.5).jumps).toEqual([0]);
    }
    // a mouth within the exit, which she reaches by her own motion
    const within: Mouths = [1000, 0, 5000, 5000, 10];
    expect(play(withMouths(flies, way, within), accuracy, 4).jumps).toEqual([0, 1]);
  });

  it('let her go where a mouth lies within its twin', () => {
    // both mouths of one wormhole, one in the other: she leaves the exit and is still in the entrance
    const level = withMouths({ astronaut: { vx: 60 } }, [100, 0, 112, 5, 20]);
    expect(play(level, accuracy, 5)).toMatchObject({ jumps: [0], final: { y: 5 } });
    const back = withMouths({ astronaut: { vx: 60 } }, [112, 5, 100, 0, 20]);
    expect(play(back, accuracy, 5).jumps).toEqual([0]);
  });
});

describe.each(continuousNames)('a jump while the gun is held, %s', (accuracy) => {
  // she falls down into a mouth and comes out at (2000, 30), where her target is to the right
  const jump = (mouth: Mouths, ...novae: PlainLevel['novae'] & {}): Level => {
    const asteroids = [0, mouth[2] + 15].map((x, i) => ({ x, y: 40 - 10 * i, radius: 16 }));
    return withMouths({ range: 5000, asteroids, novae }, mouth);
  };
  const holds: Hold[] = [[0, 600]];
  const first = (level: Level) => {
    const { events } = simulate(compile(level, accuracy), holds, { maxTime: 2 });
    return events.find(({ type }) => type === 'effect' || type === 'collided');
  };

  it.each([
    ['far away', [0, 50, 2000, 50, 20]],
    ['within its twin', [0, 50, 12, 50, 20]],
  ] as const)('turns the box to its new target before contacts are tested, %s', (_where, mouth) => {
    const [x, y] = [mouth[2], 30];
    const jumped = first(jump(mouth));
    expect(jumped).toMatchObject({ type: 'effect' });
    const at = jumped?.time ?? 0;
    const endOf = (dx: number, dy: number, radius: number) => {
      const { outcome, time } = simulate(compile(jump(mouth, { x: x + dx, y: y + dy, radius }), accuracy), holds, { maxTime: 2 });
      return { outcome, isAtOnce: Math.abs(time - at) < 1e-9 };
    };
    // falling, she reaches 10 px down and 16 px aside; turned to the right, 16 px up and down and 10 px aside
    expect(endOf(0, 16 + 7, 7.5)).toEqual({ outcome: 'collided', isAtOnce: true });
    expect(endOf(0, 16 + 7, 6.5).isAtOnce).toBe(false);
    expect(endOf(10 + 4, 0, 3.5).isAtOnce).toBe(false);
  });
});

describe.each(accuracyNames)('mouths that share their exit, pulled into one, %s', (accuracy) => {
  it('let her out, though fixed steps put her beside their rims and other events reset what happened last', () => {
    let jumped = 0;
    fc.assert(
      fc.property(
        fc.record({
          vx: fc.integer({ min: -300, max: 300 }),
          vy: fc.integer({ min: -300, max: 300 }),
          pull: fc.integer({ min: 39, max: 1000 }),
          x: fc.integer({ min: -60, max: 60 }),
          radius: fc.constantFrom(20, 40, 60),
          aliens: fc.integer({ min: 0, max: 2 }),
        }),
        ({ vx, vy, pull, x, radius, aliens }) => {
          const [exitX, exitY] = [3000, 4000];
          // an alien that loses sight of her and one that sees her, at the very instant of the jump
          const where = [-70, exitX + 60].slice(0, aliens).map((at) => ({ x: at, y: at < 0 ? 300 : exitY + 200, radius: 7 }));
          const make = (sharing: number): Level => ({
            ...withMouths(
              {
                astronaut: { vx, vy },
                range: 5000,
                asteroids: [{ x, y: 90, radius: 16 }],
                aliens: where,
              },
              [x, 90, exitX, exitY, radius],
              ...Array.from({ length: sharing }, (_, k): Mouths => [-9000 - 500 * k, 0, exitX, exitY, radius]),
            ),
            rules: { pull, alienSight: 400 },
          });
          const holds: Hold[] = [[0, 600]];
          const run = (sharing: number) => {
            const { events, final } = simulate(compile(make(sharing), accuracy), holds, { maxTime: 1 });
            return { jumps: events.flatMap((event) => (event.type === 'effect' ? [event.index] : [])), final };
          };
          const alone = run(0);
          if (alone.jumps.length > 0) jumped++;
          const { jumps, final } = run(2);
          expect(jumps).toEqual(alone.jumps);
          expect(Math.hypot(final.x - alone.final.x, final.y - alone.final.y)).toBeLessThan(1e-6);
        },
      ),
      { numRuns: 40 },
    );
    expectDeep(jumped).toBeGreaterThan(5);
  });
});

describe.each(accuracyNames)('a wormhole to which she comes back, %s', (accuracy) => {
  it('takes her once, although an alien falls asleep at that instant', () => {
    const level = withMouths(
      {
        astronaut: { vx: -400, vy: -500 },
        blackHole: { x: 700, y: -800 },
        range: 2000,
        asteroids: [{ x: 30, y: 80, radius: 1 }],
        aliens: [{ x: -70, y: 10, radius: 30 }],
      },
      [-70, 0, -14, 113, 60],
    );
    const { events, outcome } = simulate(compile(level, accuracy), [[0, 30]], { maxTime: 0.5 });
    const times = events.flatMap(({ type, time }) => (type === 'effect' ? [time] : []));
    expect(times).toHaveLength(3);
    expect(Math.min(times[1] - times[0], times[2] - times[1])).toBeGreaterThan(0.1);
    expect(outcome).toBe('timeout');
  });
});
