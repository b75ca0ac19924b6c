import type { Outcome, Touched } from '../../engine/index.ts';
import { DEFAULT_RULES, type Hold, type Level } from '../../schema/index.ts';
import { type PlainLevel, plainLevel } from '../engine/plain-level.ts';
import { fallen } from './fall.ts';
import { orbitByQuadrature } from './orbit-by-quadrature.ts';
import { slideByAngle } from './slide-by-angle.ts';

/** What is known about a run without the engine. Omitted values are unknown, or follow from the rest. */
export interface Truth {
  /** The source of this knowledge. */
  readonly by: 'closed form' | 'exact construction' | 'integration' | 'invariants' | 'quadrature';
  readonly outcome: Outcome;
  readonly with?: Touched;
  /** The time of the end of the run, s. */
  readonly time?: number;
  /** The events before the end, in order, with the time if it is known; without presses and releases. */
  readonly events?: readonly { readonly what: string; readonly time?: number }[];
  /** Her places at these times, px. */
  readonly places?: readonly { readonly time: number; readonly x: number; readonly y: number }[];
  /** From `from` s on, only this asteroid pulls her: energy and angular momentum about it are conserved. */
  readonly conserved?: { readonly asteroid: number; readonly from: number };
}

export interface HardCase {
  readonly name: string;
  readonly why: string;
  readonly level: Level;
  readonly holds: readonly Hold[];
  /** s; {@link CASE_SECONDS} by default */
  readonly maxTime?: number;
  readonly truth: Truth;
  /** The factor by which the case multiplies a small error; 1 by default. */
  readonly sensitivity?: number;
}

/** The default duration of a case, s. */
export const CASE_SECONDS = 10;

const RANGE = 250;
const HELD: readonly Hold[] = [[0, 60 * CASE_SECONDS]];
const GAPS = [1e-3, -1e-3, 1e-6, -1e-6, 1e-9, -1e-9];
const signed = (g: number) => (g > 0 ? `+${g}` : `${g}`);
const upTo = (seconds: number, n: number) => Array.from({ length: n }, (_, i) => ((i + 1) * seconds) / n);

/** A level with one asteroid and the default range. */
const around = (x: number, y: number, more: PlainLevel = {}): Level =>
  plainLevel({ range: RANGE, asteroids: [{ x, y, radius: 16 }], ...more });

const NOVA: Touched = { kind: 'nova', index: 0 };
const HOLE: Touched = { kind: 'blackHole', index: 0 };

const fall = (name: string, why: string, d0: number, range = RANGE, seconds = CASE_SECONDS, sensitivity = 1): HardCase => ({
  name,
  why,
  level: plainLevel({ range, asteroids: [{ x: 0.6 * d0, y: 0.8 * d0, radius: range / 20 }] }),
  holds: [[0, 60 * seconds]],
  maxTime: seconds,
  sensitivity,
  truth: {
    by: 'closed form',
    outcome: 'timeout',
    events: [{ what: 'target 0', time: 0 }],
    places: upTo(seconds, 47).map((time) => {
      const way = fallen(d0, range, time);
      return { time, x: 0.6 * way, y: 0.8 * way };
    }),
  },
});

const falls = (): HardCase[] => [
  ...[0.5, 5, 17, 60, 100, 200].map((d0) =>
    fall(`fall ${d0}`, 'falls through the very centre again and again, where the direction of the pull jumps', d0),
  ),
  fall('fall 249.9', 'starts where the pull is nearly 0: what is off at first grows 2500 times', 249.9, RANGE, 40, 2500),
];

const nearRadial = (near: number, far: number, range: number, name: string, why: string): HardCase => {
  const { speed, period, turn } = orbitByQuadrature(near, far, range);
  const turns = Math.max(1, Math.min(12, Math.floor(30 / period)));
  const seconds = Math.ceil(turns * period);
  return {
    name,
    why,
    level: plainLevel({ range, asteroids: [{ x: far, y: 0, radius: range / 20 }], astronaut: { vy: speed } }),
    holds: [[0, 60 * seconds]],
    maxTime: seconds,
    // an error in how far beside the centre she passes comes back 24 times as large after each turn: 117 times after five;
    // measured are 5e-9 px
    sensitivity: 10,
    truth: {
      by: 'quadrature',
      outcome: 'timeout',
      conserved: { asteroid: 0, from: 0 },
      // farthest and nearest points alternate
      places: Array.from({ length: 2 * turns }, (_, i) => {
        const angle = Math.PI - ((i + 1) * turn) / 2;
        const r = i % 2 === 0 ? near : far;
        return { time: ((i + 1) * period) / 2, x: far + r * Math.cos(angle), y: r * Math.sin(angle) };
      }),
    },
  };
};

const nearRadials = (): HardCase[] =>
  [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9].map((b) =>
    nearRadial(b, 100, RANGE, `near-radial ${b}`, `passes ${b} px beside the centre: the pull turns round within ${b / 80} s`),
  );

const scaled = (): HardCase[] => [
  fall('fall, scale 0.01', 'all lengths a hundredth: a swing takes 1.1 s', 1, 2.5, 5),
  fall('fall, scale 100', 'all lengths a hundred times: 27 s to the centre', 10_000, 25_000, 40),
  nearRadial(0.4, 1, 2.5, 'orbit, scale 0.01', 'all lengths a hundredth: the box is larger than the orbit'),
  nearRadial(4000, 10_000, 25_000, 'orbit, scale 100', 'all lengths a hundred times: a turn takes a minute'),
];

const ties = (): HardCase[] => [
  {
    name: 'tie at rest',
    why: 'rests between two asteroids at the same distance: the first in the list pulls',
    level: plainLevel({
      range: RANGE,
      asteroids: [
        { x: -100, y: 0, radius: 16 },
        { x: 100, y: 0, radius: 16 },
      ],
    }),
    holds: HELD,
    truth: {
      by: 'closed form',
      outcome: 'timeout',
      events: [{ what: 'target 0', time: 0 }],
      places: upTo(CASE_SECONDS, 20).map((time) => ({ time, x: -fallen(100, RANGE, time), y: 0 })),
    },
  },
  {
    name: 'tie, cold and hot',
    why: 'the hot one comes first in the list, but cold ones are looked at first',
    level: plainLevel({
      range: RANGE,
      asteroids: [
        { x: 100, y: 0, radius: 16, hot: true },
        { x: -100, y: 0, radius: 16 },
      ],
    }),
    holds: HELD,
    truth: {
      by: 'closed form',
      outcome: 'timeout',
      events: [{ what: 'target 1', time: 0 }],
      places: upTo(CASE_SECONDS, 20).map((time) => ({ time, x: -fallen(100, RANGE, time), y: 0 })),
    },
  },
  ...[0, 1].map((mirrored): HardCase => {
    const side = mirrored === 1 ? -1 : 1;
    return {
      name: `bisector glide${mirrored === 1 ? ', mirrored' : ''}`,
      why: 'glides along the bisector without a press, then presses: the first in the list, though neither is nearer',
      level: plainLevel({
        range: RANGE,
        astronaut: { vy: 60 },
        asteroids: [
          { x: -100 * side, y: 140, radius: 16 },
          { x: 100 * side, y: 140, radius: 16 },
        ],
      }),
      holds: [[100, 220]],
      maxTime: 3.6,
      truth: {
        by: 'invariants',
        outcome: 'timeout',
        events: [{ what: 'target 0', time: 100 / 60 }],
        places: [{ time: 100 / 60, x: 0, y: 100 }],
        conserved: { asteroid: 0, from: 100 / 60 },
      },
    };
  }),
];

/** Ends in the nova if the gap is negative; else passes it. */
const grazed = (gap: number, time: number): Truth =>
  gap < 0
    ? { by: 'closed form', outcome: 'collided', with: NOVA, time, events: [] }
    : { by: 'closed form', outcome: 'timeout', events: [] };

/** A corner of the unturned box along (3, 4) / 5 at `speed` (a multiple of 5), past a nova of radius r at `gap` px. */
function corner(speed: number, r: number, gap: number): { level: Level; truth: Truth } {
  const way = 300;
  const x = 10 + 0.6 * way + (4 * r) / 5 + 0.8 * gap;
  const y = -16 + 0.8 * way - (3 * r) / 5 - 0.6 * gap;
  // the gap after rounding
  const left = (4 * (x - 10) - 3 * (y + 16)) / 5 - r;
  return {
    level: plainLevel({ astronaut: { vx: (3 * speed) / 5, vy: (4 * speed) / 5 }, novae: [{ x, y, radius: r }] }),
    truth: grazed(left, (way - Math.sqrt(-left * (2 * r + left))) / speed),
  };
}

const grazes = (): HardCase[] =>
  GAPS.flatMap((gap): HardCase[] => {
    const why = `passes by ${signed(gap)} px: ${gap > 0 ? 'a miss' : 'a hit'} whatever the speed`;
    const r = 16;
    const x = 10 + r + gap;
    const y = 16 + r + gap;
    const until = (left: number) => (284 - Math.sqrt(-left * (2 * r + left))) / 200;
    const untilAcross = (left: number) => (290 - Math.sqrt(-left * (2 * r + left))) / 200;
    const along = { vx: 0, vy: 200 };
    const across = { vx: 200, vy: 0 };
    const alien = 50 + gap;
    return [
      {
        name: `graze side ${signed(gap)}`,
        why,
        level: plainLevel({ astronaut: along, novae: [{ x, y: 300, radius: r }] }),
        holds: [],
        truth: grazed(x - 26, until(x - 26)),
      },
      {
        name: `graze top ${signed(gap)}`,
        why,
        level: plainLevel({ astronaut: across, novae: [{ x: 300, y: -y, radius: r }] }),
        holds: [],
        truth: grazed(y - 32, untilAcross(y - 32)),
      },
      { name: `graze corner ${signed(gap)}`, why, holds: [], ...corner(300, 10, gap) },
      {
        name: `graze circle ${signed(gap)}`,
        why: `an alien on its way to her passes one asleep by ${signed(gap)} px: ${gap > 0 ? 'it kills her' : 'both explode'}`,
        level: plainLevel({
          aliens: [
            { x: 0, y: -149, radius: 25 },
            { x: alien, y: -145, radius: 25 },
          ],
        }),
        holds: [],
        truth:
          gap < 0
            ? {
                by: 'closed form',
                outcome: 'timeout',
                events: [{ what: 'explosion 0 1', time: Math.sqrt(1 - Math.sqrt(-(alien - 50) * (100 + (alien - 50))) / 4) }],
              }
            : {
                by: 'closed form',
                outcome: 'collided',
                with: { kind: 'alien', index: 0 },
                time: Math.sqrt(27),
                events: [],
              },
      },
      {
        name: `turned corner ${signed(gap)}`,
        why: `the press turns a corner to ${signed(gap)} px from a nova which the unturned box is far from; the pull moves it away`,
        level: plainLevel({
          range: RANGE,
          asteroids: [{ x: 60, y: 80, radius: 16 }],
          novae: [{ x: -20.8 - gap, y: 1.6, radius: 2 }],
        }),
        holds: [[30, 60]],
        maxTime: 1,
        truth: { ...grazed(gap, 0.5), by: 'exact construction', events: [{ what: 'target 0', time: 0.5 }] },
      },
      {
        name: `rim ${signed(gap)}`,
        why: `her centre passes the rim of a field ${signed(gap)} px outside${gap < 0 ? ', that is, through it' : ''}`,
        level: plainLevel({ astronaut: { vy: 100 }, repulsors: [{ x: 48 + gap, y: 200, radius: 48 }] }),
        holds: [],
        truth: {
          by: 'closed form',
          outcome: 'timeout',
          events:
            gap > 0
              ? []
              : [{ what: 'enter 0', time: (200 - Math.sqrt((48 - (48 + gap)) * (96 + gap))) / 100 }, { what: 'leave 0' }],
        },
      },
    ];
  });

const fast = (): HardCase[] =>
  [0.02, -0.02, 1e-6, -1e-6].map((gap) => ({
    name: `990 px/s, radius 0.5, ${signed(gap)}`,
    why: `16.5 px a tick past a nova 1 px wide, ${gap > 0 ? 'missed' : 'clipped by a corner'}`,
    holds: [],
    ...corner(990, 0.5, gap),
  }));

const simultaneous = (): HardCase[] => [
  ...[1e-6, -1e-6, 1e-9, -1e-9].map(
    (s): HardCase => ({
      name: `black hole ${s > 0 ? 'before' : 'after'} nova by ${Math.abs(s)} s`,
      why: 'what is touched first decides, however short the time',
      level: plainLevel({
        astronaut: { vx: 100 },
        blackHole: { x: 300, y: -16 },
        novae: [{ x: 298 + 100 * s, y: 16, radius: 16 }],
      }),
      holds: [],
      truth:
        s > 0
          ? { by: 'closed form', outcome: 'completed', with: HOLE, time: 2.72, events: [] }
          : { by: 'closed form', outcome: 'collided', with: NOVA, time: 2.72 + s, events: [] },
    }),
  ),
  {
    name: 'black hole with nova',
    why: 'touched in the same instant, mirror images of one another: the hazard wins',
    level: plainLevel({
      astronaut: { vx: 100 },
      blackHole: { x: 300, y: -20, radius: 18 },
      novae: [{ x: 300, y: 20, radius: 18 }],
    }),
    holds: [],
    truth: { by: 'exact construction', outcome: 'collided', with: NOVA, events: [] },
  },
  {
    name: 'corner turned into a nova',
    why: 'nothing moves; the press turns a corner 0.01 px into a nova',
    level: around(60, 80, { novae: [{ x: 20.79, y: -1.6, radius: 2 }] }),
    holds: [[30, 60]],
    truth: { by: 'exact construction', outcome: 'collided', with: NOVA, time: 0.5, events: [{ what: 'target 0', time: 0.5 }] },
  },
];

const fields = (): HardCase[] => {
  const pushed = (side: number, first: number, second: number): Truth => ({
    by: 'closed form',
    outcome: 'timeout',
    events: [
      // she starts inside: nothing is entered
      { what: `leave ${first}`, time: Math.sqrt(3.8) },
      { what: `leave ${second}`, time: Math.sqrt(5.8) },
    ],
    places: [
      ...upTo(Math.sqrt(5.8), 10).map((time) => ({ time, x: side * 10 * time * time, y: 0 })),
      { time: 4, x: side * (58 + 20 * Math.sqrt(5.8) * (4 - Math.sqrt(5.8))), y: 0 },
    ],
  });
  const right = { x: 10, y: 0, radius: 48 };
  const left = { x: -10, y: 0, radius: 48 };
  const slow = Math.sqrt(40_000 - 2 * 20 * 48);
  const enters = 0.26;
  const leaves = enters + (2 * (200 - slow)) / 20;
  return [
    {
      name: 'overlapping fields',
      why: 'inside two fields: the first in the list pushes until she has left it',
      level: plainLevel({ repulsors: [right, left] }),
      holds: [],
      truth: pushed(-1, 0, 1),
    },
    {
      name: 'overlapping fields, reversed',
      why: 'the same with the list the other way round: the mirrored way',
      level: plainLevel({ repulsors: [left, right] }),
      holds: [],
      truth: pushed(1, 0, 1),
    },
    {
      name: 'through the centre of a field',
      why: 'the direction of the push jumps in the centre',
      level: plainLevel({ astronaut: { vx: 200 }, repulsors: [{ x: 100, y: 0, radius: 48 }] }),
      holds: [],
      maxTime: 5,
      truth: {
        by: 'closed form',
        outcome: 'timeout',
        events: [
          { what: 'enter 0', time: enters },
          { what: 'leave 0', time: leaves },
        ],
        places: [
          { time: (enters + leaves) / 2, x: 100, y: 0 },
          { time: 5, x: 148 + 200 * (5 - leaves), y: 0 },
        ],
      },
    },
    {
      name: 'rests in the centre of a field',
      why: 'no direction to be pushed in, held or not',
      level: plainLevel({ repulsors: [{ x: 0, y: 0, radius: 48 }] }),
      holds: [[100, 200]],
      truth: { by: 'exact construction', outcome: 'timeout', places: upTo(10, 5).map((time) => ({ time, x: 0, y: 0 })) },
    },
    ...slides(),
  ];
};

const slides = (): HardCase[] => {
  const field = { x: 0, y: 0, radius: 48 };
  const along = (
    name: string,
    why: string,
    repulsors: readonly (typeof field)[],
    astronaut: Partial<Level['astronaut']>,
    recoil = false,
  ): HardCase => {
    const level = plainLevel({ range: 250, astronaut, recoil, asteroids: [{ x: 70, y: 11, radius: 16 }], repulsors });
    const { time, off } = slideByAngle(level, 10);
    const places = upTo(time, 10).map((at) => slideByAngle(level, at));
    const events = [{ what: 'target 0', time: 0 }, { what: 'enter 0' }, ...(off ? [{ what: 'leave 0', time }] : [])];
    const maxTime = Math.ceil(60 * time) / 60;
    return { name, why, level, holds: HELD, maxTime, truth: { by: 'integration', outcome: 'timeout', events, places } };
  };
  return [
    along('slides along a rim', 'the push drives her out, the gun in: she can only slide', [field], { x: -48 }),
    along('slides and comes off', 'fast along the rim, she leaves it before she is out of its sight', [field], {
      x: -48,
      vy: 12,
    }),
    along('slides on two equal fields', 'in and out of two at once; equal fields are one', [field, { ...field }], { x: -48 }),
    along(
      'slides where two rims touch',
      'a smaller field lies in a larger one and touches its rim where she starts',
      [field, { x: -8, y: 0, radius: 40 }],
      { x: -48 },
    ),
    along('slides and draws the asteroid', 'what holds her on the rim moves', [field], { x: -48, vy: -5 }, true),
  ];
};

const aliens = (): HardCase[] => [
  {
    name: 'alien pair explodes',
    why: 'two aliens on straight ways to her meet before they reach her',
    level: plainLevel({
      aliens: [
        { x: -50, y: -120, radius: 25 },
        { x: 50, y: -120, radius: 25 },
      ],
    }),
    holds: [],
    truth: {
      by: 'closed form',
      outcome: 'timeout',
      events: [{ what: 'explosion 0 1', time: Math.sqrt(16.25) }],
      places: [{ time: 10, x: 0, y: 0 }],
    },
  },
  {
    name: 'sleeping aliens that touch exactly',
    why: 'touching from outside is no contact, and asleep they stay so: nothing ever happens, and the run must go on',
    level: plainLevel({
      aliens: [
        { x: 300, y: 0, radius: 25 },
        { x: 350, y: 0, radius: 25 },
      ],
    }),
    holds: [],
    truth: { by: 'exact construction', outcome: 'timeout', events: [] },
  },
  {
    name: 'alien at exactly 150 px',
    why: 'not nearer than 150 px: asleep',
    level: plainLevel({ aliens: [{ x: 90, y: 120, radius: 25 }] }),
    holds: [],
    truth: { by: 'exact construction', outcome: 'timeout', events: [] },
  },
];

const starts = (): HardCase[] => [
  {
    name: 'starts in a nova',
    why: 'over before anything moves',
    level: plainLevel({ novae: [{ x: 5, y: 5, radius: 16 }] }),
    holds: [],
    truth: { by: 'exact construction', outcome: 'collided', with: NOVA, time: 0, events: [] },
  },
  {
    name: 'starts in the black hole',
    why: 'over before anything moves',
    level: plainLevel({ blackHole: { x: 5, y: 5 } }),
    holds: [],
    truth: { by: 'exact construction', outcome: 'completed', with: HOLE, time: 0, events: [] },
  },
  {
    name: 'starts in both',
    why: 'the hazard wins',
    level: plainLevel({ blackHole: { x: 5, y: 5 }, novae: [{ x: -5, y: 5, radius: 16 }] }),
    holds: [],
    truth: { by: 'exact construction', outcome: 'collided', with: NOVA, time: 0, events: [] },
  },
  {
    name: 'starts in the centre of her target',
    why: 'the pull has no direction: nothing moves, and the angle is kept',
    level: around(0, 0),
    holds: HELD,
    truth: { by: 'exact construction', outcome: 'timeout', places: upTo(10, 5).map((time) => ({ time, x: 0, y: 0 })) },
  },
  {
    name: 'starts at the range',
    why: 'at exactly the range the pull is 0 and nothing is lost',
    level: around(150, 200),
    holds: HELD,
    truth: { by: 'exact construction', outcome: 'timeout', places: upTo(10, 5).map((time) => ({ time, x: 0, y: 0 })) },
  },
  {
    name: 'recoil at rest in the centre',
    why: 'a target without direction is not drawn anywhere, and the other asteroid is not nearer',
    level: around(0, 0, {
      recoil: true,
      asteroids: [
        { x: 0, y: 0, radius: 16 },
        { x: 100, y: 0, radius: 16 },
      ],
    }),
    holds: HELD,
    truth: { by: 'exact construction', outcome: 'timeout', places: upTo(10, 5).map((time) => ({ time, x: 0, y: 0 })) },
  },
  {
    name: 'recoil on a line',
    why: 'she and the asteroid fall towards each other: the distance follows the closed form of a pull that is a little stronger',
    level: around(100, 0, { recoil: true }),
    holds: [[0, 150]],
    maxTime: 2.5,
    truth: {
      by: 'closed form',
      outcome: 'timeout',
      places: upTo(2.5, 10).map((time) => {
        const drawn = 1 / 32;
        const reach = (RANGE * (DEFAULT_RULES.pull + drawn)) / DEFAULT_RULES.pull;
        const distance = reach - (reach - 100) * Math.cosh(time * Math.sqrt(DEFAULT_RULES.pull / RANGE));
        return { time, x: 100 - (drawn * time * time) / 2 - distance, y: 0 };
      }),
    },
  },
  {
    name: 'hardly any sideways speed',
    why: 'vy 1e-12 px/s: beside the centre by less than the last digit of its place',
    level: around(60, 0, { astronaut: { vy: 1e-12 } }),
    holds: HELD,
    truth: {
      by: 'closed form',
      outcome: 'timeout',
      places: upTo(10, 40).map((time) => ({ time, x: fallen(60, RANGE, time), y: 0 })),
    },
  },
];

const limits = (): HardCase[] => {
  const rate = Math.sqrt(DEFAULT_RULES.pull / RANGE);
  // from the centre outwards at 1000 px/s up to the range
  const out = Math.atanh((RANGE * rate) / 1000) / rate;
  const wide = 1e6;
  const slow = Math.sqrt(DEFAULT_RULES.pull / wide);
  const speedAt = (t: number) => (wide - 1e5) * slow * Math.sinh(slow * t) + 990 * Math.cosh(slow * t);
  let [low, high] = [0, 1];
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    if (speedAt(middle) < 1000) low = middle;
    else high = middle;
  }
  const way = (t: number) => (wide - 1e5) * (Math.cosh(slow * t) - 1) + (990 / slow) * Math.sinh(slow * t);
  return [
    {
      name: 'speed limit reached',
      why: 'falls from 990 px/s to the limit between two ticks, then goes on at the limit',
      level: plainLevel({ range: wide, astronaut: { vx: 990 }, asteroids: [{ x: 1e5, y: 0, radius: 16 }] }),
      holds: HELD,
      truth: {
        by: 'closed form',
        outcome: 'timeout',
        places: [
          { time: low, x: way(low), y: 0 },
          ...[1, 5, 10].map((time) => ({ time, x: way(low) + 1000 * (time - low), y: 0 })),
        ],
      },
    },
    ...[0, -100].map(
      (x): HardCase => ({
        name: `at the limit along the pull from ${x}`,
        why: 'starts at the speed limit on the line of the pull, which is cut off on one side of the centre and brakes on the other',
        level: around(0, 0, { astronaut: { x, vx: 1000 } }),
        holds: HELD,
        truth: { by: 'closed form', outcome: 'lost', time: -x / 1000 + out },
      }),
    ),
  ];
};

const holds = (): HardCase[] => [
  {
    name: 'a hold of no length',
    why: 'pressed and released in the same tick: never held',
    level: around(100, 100, { astronaut: { vx: 10 } }),
    holds: [[50, 50]],
    maxTime: 5,
    truth: { by: 'exact construction', outcome: 'timeout', events: [], places: [{ time: 5, x: 50, y: 0 }] },
  },
  {
    name: 'single ticks',
    why: 'held every other tick: 150 presses, each of them an event',
    level: around(100, 0),
    holds: Array.from({ length: 150 }, (_, i): Hold => [2 * i, 2 * i + 1]),
    maxTime: 1,
    truth: {
      by: 'closed form',
      outcome: 'timeout',
      places: (() => {
        // on the line, tick by tick: the pull's closed form for a tick, then a tick of drift
        const rate = Math.sqrt(DEFAULT_RULES.pull / RANGE);
        const [c, s] = [Math.cosh(rate / 60), Math.sinh(rate / 60)];
        let [u, v] = [RANGE - 100, 0];
        const places: { time: number; x: number; y: number }[] = [];
        for (let tick = 0; tick < 60; tick++) {
          [u, v] = tick % 2 === 0 ? [u * c + (v / rate) * s, u * rate * s + v * c] : [u + v / 60, v];
          places.push({ time: (tick + 1) / 60, x: u - (RANGE - 100), y: 0 });
        }
        return places;
      })(),
    },
  },
  {
    name: 'back-to-back holds',
    why: 'released and pressed in the same tick is held on',
    level: around(100, 0),
    holds: [
      [0, 100],
      [100, 101],
      [101, 600],
    ],
    truth: {
      by: 'closed form',
      outcome: 'timeout',
      events: [{ what: 'target 0', time: 0 }],
      places: upTo(10, 20).map((time) => ({ time, x: fallen(100, RANGE, time), y: 0 })),
    },
  },
];

/** The hard cases by family. Each call makes a new table, so that callers can't change each other's. */
export const hardFamilies = () => ({
  falls: falls(),
  nearRadials: nearRadials(),
  scaled: scaled(),
  ties: ties(),
  grazes: grazes(),
  fast: fast(),
  simultaneous: simultaneous(),
  fields: fields(),
  aliens: aliens(),
  starts: starts(),
  limits: limits(),
  holds: holds(),
});

/** Every hard case whose truth is a closed form, a construction or an integration of its own. */
export const hardCases = (): HardCase[] => Object.values(hardFamilies()).flat();
