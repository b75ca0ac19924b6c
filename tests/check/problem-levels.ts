import type { LevelFile } from '../../schema/index.ts';

/** She rests 150 px beside a cold asteroid; the black hole lies behind it on the same line. */
const BASE: LevelFile = {
  version: 1,
  name: 'base',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [{ x: 150, y: 0, radius: 16 }],
  runs: [{ name: 'through', holds: [[0, 600]] }],
};

/** Its run completes it only at `arcade`, which looks for contacts at frames. */
const NEAR_MISS: LevelFile = {
  ...BASE,
  astronaut: { x: 500, y: 760, vx: 0, vy: -60 },
  blackHole: { x: 830, y: 510 },
  asteroids: [{ x: 600, y: 620, radius: 32 }],
  runs: [{ name: 'in frames only', holds: [[120, 435]] }],
};

const DRIFT: NonNullable<LevelFile['runs']>[number] = { name: 'drift', holds: [] };

/** One level for each problem that only a level that has it shows, by what it shows. */
export const PROBLEM_LEVELS: Readonly<Record<string, LevelFile>> = {
  'no run': { ...BASE, runs: [] },
  'no run that completes it': { ...BASE, runs: [DRIFT, { name: 'too "short"', holds: [[3, 9]] }] },
  'a run that fails beside one that completes it': { ...BASE, runs: [DRIFT, ...(BASE.runs ?? [])] },
  'a nova is hit': { ...BASE, novae: [{ x: 225, y: 0, radius: 16 }] },
  'a hot asteroid is hit, the second of its list': {
    ...BASE,
    asteroids: [
      { x: 150, y: 0, radius: 16 },
      { x: 230, y: 0, radius: 16, hot: true },
    ],
  },
  'an alien is hit': { ...BASE, aliens: [{ x: 230, y: 0, radius: 20 }] },
  'a black hole out of reach': { ...BASE, blackHole: { x: 9999, y: 0 } },
  'a black hole out of reach, and no run': { ...BASE, blackHole: { x: 9999, y: 0 }, runs: [] },
  'a covered black hole': { ...BASE, novae: [{ x: 300, y: 0, radius: 80 }], runs: [DRIFT] },
  'nothing in range': { ...BASE, astronaut: { x: -900, y: 0 } },
  'a start in a nova': { ...BASE, novae: [{ x: 0, y: 20, radius: 16 }] },
  'minerals that nobody collects': {
    ...BASE,
    minerals: [
      { x: 75, y: 0 },
      { x: 9000, y: 0 },
      { x: 200, y: 0 },
      { x: 100, y: 9000 },
    ],
  },
  'a covered mineral': { ...BASE, novae: [{ x: 100, y: 200, radius: 60 }], minerals: [{ x: 100, y: 200 }] },
  'more minerals than are asked about': {
    ...BASE,
    minerals: [
      ...Array.from({ length: 12 }, (_, i) => ({ x: 20 + 5 * i, y: 0 })),
      ...Array.from({ length: 15 }, (_, i) => ({ x: 5000 + 40 * i, y: 0 })),
    ],
  },
  'runs that complete it at some accuracies only': {
    ...NEAR_MISS,
    runs: [
      ...(NEAR_MISS.runs ?? []),
      { name: 'everywhere', holds: [[150, 435]] },
      { name: 'not in frames', holds: [[158, 435]] },
    ],
  },
  'a verdict that hangs on the accuracy': NEAR_MISS,
  'an untidy level': {
    ...BASE,
    asteroids: [
      { x: 150, y: 0, radius: 16 },
      { x: 150, y: 0, radius: 20 },
      { x: 150, y: 400, radius: 16 },
    ],
    repulsors: [{ x: 5000, y: 0, radius: 40 }],
    runs: [
      {
        name: 'through',
        holds: [
          [300, 600],
          [0, 320],
        ],
      },
    ],
  },
  'more warnings of a kind than are told': {
    ...BASE,
    minerals: Array.from({ length: 30 }, (_, i) => ({ x: 75 + Math.floor(i / 2), y: 0 })),
  },
  'an untidy level that allows it': {
    ...BASE,
    allow: {
      'same-place': 'twins',
      'repulsor-never-acts': 'scenery',
      'unused-asteroid': 'a landmark',
      'run-does-not-complete': 'a warning',
      'holds-overlap': 'nothing overlaps',
      'mineral-never-collectable': 'there is no mineral',
      'low-slack': 'for experts',
    },
    asteroids: [
      { x: 150, y: 0, radius: 16 },
      { x: 150, y: 0, radius: 20 },
      { x: 150, y: 400, radius: 16 },
    ],
    repulsors: [{ x: 5000, y: 0, radius: 40 }],
    runs: [...(BASE.runs ?? []), DRIFT],
  },
  'a broken level that allows its runs to fail': {
    ...BASE,
    allow: { 'run-does-not-complete': 'it cannot be allowed', 'unused-asteroid': 'nothing is known of it' },
    runs: [DRIFT],
  },
  'a lost mineral that is allowed': {
    ...BASE,
    allow: { 'mineral-never-collectable': 'only to be seen', 'mineral-out-of-reach': 'only to be seen' },
    minerals: [{ x: 0, y: 9000 }],
  },
};
