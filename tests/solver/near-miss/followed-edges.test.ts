import { describe, expect, it } from 'vitest';
import type { LevelFile } from '../../../schema/index.ts';
import { isHunt } from '../../depth.ts';
import { type Asked, at, doomedBy, flowpipeBy, hot, levelWith, ORIGIN, spot, whyNot } from './near-miss.ts';

// Reachable sets contain more than what she can do; followed.test.ts compares them with what is true. Here the point where
// acceptance begins is measured and stated to some hundredths: a bound that becomes looser or tighter, or a term that is lost,
// moves it. Half of the scenes are checked as they are drawn, the others mirrored and turned; a hunt checks each in both ways.

interface Turn {
  readonly c: number;
  readonly s: number;
  readonly mirror: number;
}
const TURNS: readonly Turn[] = [
  { c: 1, s: 0, mirror: 1 },
  { c: -0.28, s: 0.96, mirror: -1 },
];

interface Scene extends Partial<LevelFile> {
  readonly v: readonly [number, number];
}

const turned = <T extends { x: number; y: number }>({ c, s, mirror }: Turn, thing: T): T => {
  const [x, y] = [thing.x - ORIGIN.x, mirror * (thing.y - ORIGIN.y)];
  return { ...thing, ...spot(c * x - s * y, s * x + c * y) };
};

function levelOf(scene: Scene, turn: Turn) {
  const { v, asteroids = [], novae = [], aliens = [], repulsors = [], minerals = [], blackHole = spot(5000, 5000) } = scene;
  const list = <T extends { x: number; y: number }>(things: readonly T[]): T[] => things.map((thing) => turned(turn, thing));
  const { x, y } = turned(turn, spot(...v));
  return levelWith({
    astronaut: { ...ORIGIN, vx: x - ORIGIN.x, vy: y - ORIGIN.y },
    asteroids: list(asteroids),
    novae: list(novae),
    aliens: list(aliens),
    repulsors: list(repulsors),
    minerals: list(minerals),
    blackHole: turned(turn, blackHole),
    recoil: scene.recoil,
  });
}

type Kind = 'doomed' | 'flowpipe';
const SIZES = { doomed: { cell: 8, bin: 4 }, flowpipe: { cell: 16, turns: 4 } };

interface Edge {
  readonly of: (n: number) => Scene;
  readonly grid?: {
    readonly steps?: number;
    readonly frames?: number;
    readonly cell?: number;
    readonly bin?: number;
    readonly turns?: number;
  };
  readonly asked?: Asked;
  readonly safe: 'above' | 'below';
  /**
   * Where acceptance begins; if a pair, the second value is for the turned scene, because her box is upright at the start in
   * both.
   */
  readonly doomed?: number;
  readonly flowpipe?: number | readonly [number, number];
  readonly says?: string;
}

const TOUCHES = 'she may touch it in step';
const FAST = 'she may reach the speed limit';
const MINERAL: Asked = { about: { kind: 'mineral', index: 0 } };
const SECONDS: Asked = { maxTime: 60 };
const LEFT = [-40, 0] as const;
const BEHIND = [at(50, 0)];

const edges: Readonly<Record<string, Edge>> = {
  'out of range': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(230, 0)] }),
    grid: { steps: 20 },
    safe: 'above',
    doomed: 16.447,
    flowpipe: 16.428,
  },
  'out of range, in long steps': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(230, 0)] }),
    grid: { frames: 8 },
    safe: 'above',
    doomed: 14.307,
    flowpipe: 14.283,
  },
  'out of range, a tick a step': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(240, 0)] }),
    grid: { steps: 40, frames: 1 },
    safe: 'above',
    doomed: 15.359,
    flowpipe: 15.353,
  },
  'out of range, aslant': {
    of: (v) => ({ v: [-v, 5], asteroids: [at(220, 40)] }),
    grid: { steps: 20 },
    safe: 'above',
    doomed: 22.765,
    flowpipe: 22.74,
  },
  'out of a range that recoil moves': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(225, 0, 4)], recoil: true }),
    grid: { steps: 20 },
    asked: SECONDS,
    safe: 'above',
    doomed: 20.81,
    flowpipe: 20.783,
  },
  'out of two ranges that recoil moves': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(225, 30, 4), at(225, -40, 6)], recoil: true }),
    grid: { steps: 20 },
    asked: SECONDS,
    safe: 'above',
    doomed: 19.346,
    flowpipe: 19.321,
  },
  'out of the ranges of two that are as near': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(150, 180), at(150, -180)] }),
    grid: { steps: 20 },
    safe: 'above',
    doomed: 19.279,
    flowpipe: 19.261,
  },
  'another range below': {
    of: (y) => ({ v: [-45, 0], asteroids: [at(235, 0), at(150, y)] }),
    grid: { steps: 20 },
    safe: 'above',
    doomed: 143.207,
    flowpipe: 143.14,
  },
  'another range above': {
    of: (x) => ({ v: [-45, 0], asteroids: [at(235, 0), at(x, -190)] }),
    grid: { steps: 20 },
    safe: 'above',
    doomed: 107.31,
    flowpipe: 107.263,
  },
  'a field that pushes her back into range': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(225, 0)], repulsors: [at(30, 0, 300)] }),
    grid: { steps: 20 },
    safe: 'above',
    doomed: 6.063,
    flowpipe: 5.638,
  },
  'a nova ahead': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, 0, 30)] }),
    safe: 'below',
    doomed: 61.617,
    flowpipe: 62.065,
  },
  'a nova ahead, followed finely': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, 0, 30)] }),
    grid: { steps: 30, frames: 2, cell: 4, bin: 2 },
    safe: 'below',
    doomed: 64.426,
    flowpipe: 64.893,
  },
  'a nova ahead, followed coarsely': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, 0, 30)] }),
    grid: { cell: 20, bin: 10 },
    safe: 'below',
    doomed: 61.561,
    flowpipe: 62.067,
  },
  'a nova ahead, in few long steps': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, 0, 40)] }),
    grid: { steps: 4, frames: 10 },
    safe: 'below',
    doomed: 68.71,
    flowpipe: 69.356,
  },
  'a nova aside': {
    of: (y) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-35, y, 30)] }),
    safe: 'below',
    doomed: 37.675,
    flowpipe: [44.339, 40.793],
  },
  'two novae with a gap': {
    of: (y) => ({ v: LEFT, asteroids: [at(50, 30)], novae: [at(-35, 15 - y, 20), at(-35, 15 + y, 20)] }),
    safe: 'below',
    doomed: 38.212,
    flowpipe: [40.11, 45.225],
  },
  'a hot asteroid that recoil might move': {
    of: (r) => ({ v: LEFT, asteroids: [at(50, 0), hot(-35, 0, r)], recoil: true }),
    asked: SECONDS,
    safe: 'above',
    doomed: 30.15,
  },
  'a hot asteroid ahead': {
    of: (x) => ({ v: LEFT, asteroids: [at(50, 0), hot(-x, 0, 30)] }),
    safe: 'below',
    flowpipe: 66.389,
  },
  'a small hot asteroid ahead, with recoil': {
    of: (x) => ({ v: LEFT, asteroids: [at(50, 0), hot(-x, 0, 5)], recoil: true }),
    asked: SECONDS,
    safe: 'below',
    flowpipe: 46.814,
  },
  'a hot asteroid aside, with recoil': {
    of: (y) => ({ v: LEFT, asteroids: [at(50, 0), hot(-35, y, 20)], recoil: true }),
    asked: SECONDS,
    safe: 'below',
    flowpipe: 29.665,
  },
  'a second asteroid that is never the nearest': {
    of: (x) => ({ v: [0, 30], asteroids: [at(60, 0, 4), at(-x, 0, 4)], novae: [at(25, 60, 35)] }),
    safe: 'above',
    flowpipe: 60.193,
  },
  'a second asteroid that is never the nearest, with recoil': {
    of: (x) => ({ v: [0, 30], asteroids: [at(60, 0, 4), at(-x, 0, 4)], novae: [at(25, 60, 35)], recoil: true }),
    asked: SECONDS,
    safe: 'above',
    flowpipe: 61.084,
  },
  'a second asteroid above that is never the nearest': {
    of: (y) => ({ v: [0, 30], asteroids: [at(60, 0, 4), at(-60, -y, 4)], novae: [at(25, 60, 35)] }),
    safe: 'above',
    flowpipe: 4.915,
  },
  'a second asteroid above that is never the nearest, with recoil': {
    of: (y) => ({ v: [0, 30], asteroids: [at(60, 0, 4), at(-60, -y, 4)], novae: [at(25, 60, 35)], recoil: true }),
    asked: SECONDS,
    safe: 'above',
    flowpipe: 5.372,
  },
  'a second asteroid below that becomes the nearest late': {
    of: (y) => ({ v: [0, 30], asteroids: [at(60, 0, 4), at(-40, y, 4)], novae: [at(25, 60, 35)], recoil: true }),
    asked: SECONDS,
    safe: 'above',
    flowpipe: 66.754,
  },
  'a nova behind an asteroid that she flies through': {
    of: (x) => ({ v: [40, 0], asteroids: [at(20, 0)], novae: [at(x, 0, 30)] }),
    safe: 'below',
    doomed: 68.577,
    flowpipe: 67.348,
  },
  'a nova aside, behind an asteroid that she flies through': {
    of: (y) => ({ v: [40, 0], asteroids: [at(20, 0)], novae: [at(60, y, 30)] }),
    safe: 'below',
    doomed: 21.253,
    flowpipe: 20.717,
  },
  'a nova aside, behind an asteroid that recoil moves': {
    of: (y) => ({ v: [60, 0], asteroids: [at(15, 20, 6)], novae: [at(70, y, 40)], recoil: true }),
    grid: { steps: 10 },
    asked: SECONDS,
    safe: 'below',
    doomed: 38.371,
    flowpipe: 39.876,
  },
  'a nova below, between two asteroids': {
    of: (y) => ({ v: [0, 30], asteroids: [at(60, 0), at(-60, 10)], novae: [at(0, y, 60)] }),
    safe: 'below',
    doomed: 91.713,
    flowpipe: 91.79,
  },
  'a wide nova between two asteroids': {
    of: (x) => ({ v: [-25, 0], asteroids: [at(0, -40), at(10, 60)], novae: [at(-x, 0, 60)] }),
    grid: { steps: 24, cell: 6 },
    safe: 'below',
    flowpipe: [94.323, 94.216],
  },
  'a nova aside, when her box is turned': {
    of: (y) => ({ v: LEFT, asteroids: [at(50, 40)], novae: [at(-35, y, 30)] }),
    grid: { turns: 16 },
    safe: 'below',
    doomed: 38.448,
    flowpipe: [45.267, 40.794],
  },
  'a nova aside, when her box is turned the other way': {
    of: (y) => ({ v: LEFT, asteroids: [at(50, -40)], novae: [at(-35, y, 30)] }),
    grid: { turns: 16 },
    safe: 'below',
    doomed: 33.789,
    flowpipe: [41.133, 40.794],
  },
  'a nova aside, when all directions are one': {
    of: (y) => ({ v: LEFT, asteroids: [at(20, -40)], novae: [at(-35, y, 30)] }),
    grid: { turns: 1 },
    safe: 'below',
    doomed: 32.458,
  },
  'a nova aside, when directions are three': {
    of: (y) => ({ v: LEFT, asteroids: [at(0, -30)], novae: [at(-45, -y, 30)] }),
    grid: { turns: 3 },
    safe: 'below',
    doomed: 35.985,
  },
  'a nova aside, in small cells': {
    of: (y) => ({ v: LEFT, asteroids: [at(20, -40)], novae: [at(-45, y, 40)] }),
    grid: { cell: 2 },
    safe: 'below',
    doomed: 38.541,
    flowpipe: [41.141, 41.18],
  },
  'a nova ahead, in small cells': {
    of: (x) => ({ v: LEFT, asteroids: [at(20, -40)], novae: [at(-x, 10, 50)] }),
    grid: { steps: 16, cell: 3 },
    safe: 'below',
    doomed: 84.792,
    flowpipe: [85.455, 85.444],
  },
  'a nova for what a field below pushes up': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, -20, 30)], repulsors: [at(-8, 25, 28)] }),
    safe: 'below',
    doomed: 65.906,
    flowpipe: [67.146, 67.076],
  },
  'a field that brings her to a nova aside': {
    of: (r) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-60, -23, 30)], repulsors: [at(-8, 35, r)] }),
    safe: 'above',
    doomed: 36.033,
    flowpipe: 35.583,
  },
  'a field above that brings her to a nova aside': {
    of: (r) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-60, 23, 30)], repulsors: [at(-8, -35, r)] }),
    safe: 'above',
    doomed: 36.033,
    flowpipe: 35.583,
  },
  'a nova aside of what a field pushes': {
    of: (y) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-60, -y, 30)], repulsors: [at(-8, 35, 32)] }),
    safe: 'below',
    doomed: 11.235,
    flowpipe: 21.511,
  },
  'a nova for what a field around her pushes': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, 0, 30)], repulsors: [at(-5, 8, 80)] }),
    safe: 'below',
    doomed: 72.442,
    flowpipe: 72.583,
  },
  'a nova for what a field about her way pushes anywhere': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, 0, 40)], repulsors: [at(-6, 0.5, 3)] }),
    safe: 'below',
    doomed: 72.056,
    flowpipe: 72.419,
  },
  'a nova for what two fields push': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-x, 0, 30)], repulsors: [at(5, 20, 30), at(5, -30, 40)] }),
    safe: 'below',
    doomed: 70.597,
    flowpipe: 70.71,
  },
  'a black hole ahead, for a mineral': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, blackHole: { ...spot(-x, 0), radius: 30 }, minerals: [spot(700, 700)] }),
    asked: MINERAL,
    safe: 'below',
    doomed: 61.617,
    flowpipe: 62.065,
  },
  'an alien ahead': { of: (x) => ({ v: LEFT, asteroids: BEHIND, aliens: [at(-x, 0, 30)] }), safe: 'below', flowpipe: 64.496 },
  'a large alien ahead': {
    of: (x) => ({ v: LEFT, asteroids: BEHIND, aliens: [at(-x, 0, 40)] }),
    safe: 'below',
    flowpipe: 74.518,
  },
  'an alien aside': {
    of: (y) => ({ v: LEFT, asteroids: BEHIND, aliens: [at(-35, y, 30)] }),
    safe: 'below',
    flowpipe: [46.529, 43.276],
  },
  'two aliens that may explode': {
    of: (y) => ({ v: LEFT, asteroids: BEHIND, aliens: [at(-35, 10, 30), at(-35, 10 + y, 30)] }),
    safe: 'above',
    flowpipe: 60.037,
  },
  'a black hole at the start': {
    of: (d) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-35, 0, 30)], blackHole: spot(-10, d) }),
    safe: 'above',
    doomed: 36.262,
    flowpipe: 36.248,
    says: TOUCHES,
  },
  'a black hole behind the start': {
    of: (d) => ({ v: [-40, 10], asteroids: [at(50, 40)], novae: [at(-35, 10, 40)], blackHole: spot(5, d) }),
    safe: 'above',
    doomed: 37.318,
    flowpipe: 37.304,
    says: TOUCHES,
  },
  'a black hole beside her way': {
    of: (d) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-60, 0, 30)], blackHole: spot(-25, -d) }),
    safe: 'above',
    doomed: 36.993,
    flowpipe: 36.979,
    says: TOUCHES,
  },
  'a mineral at the start': {
    of: (d) => ({ v: LEFT, asteroids: BEHIND, novae: [at(-35, 0, 30)], minerals: [{ ...spot(-10, d), radius: 7 }] }),
    asked: MINERAL,
    safe: 'above',
    doomed: 24.948,
    flowpipe: 24.933,
    says: TOUCHES,
  },
  'a mineral to which a field pushes her': {
    of: (d) => ({
      v: LEFT,
      asteroids: BEHIND,
      novae: [at(-60, 0, 30)],
      repulsors: [at(-8, 35, 32)],
      minerals: [{ ...spot(-25, -d), radius: 7 }],
    }),
    asked: MINERAL,
    safe: 'above',
    doomed: 25.994,
    flowpipe: 25.981,
    says: TOUCHES,
  },
  'the speed limit to the left': {
    of: (v) => ({ v: [-v, 0], asteroids: [at(230, 0)] }),
    grid: { frames: 8 },
    safe: 'below',
    doomed: 500.003,
    flowpipe: 437.6,
    says: FAST,
  },
  'the speed limit to the right': {
    of: (v) => ({ v: [v, 0], asteroids: [at(-50, 0)], novae: [at(35, 0, 60)] }),
    safe: 'below',
    doomed: 500,
    flowpipe: 468.8,
    says: FAST,
  },
  'the speed limit downwards': {
    of: (v) => ({ v: [0, v], asteroids: BEHIND, novae: [at(0, 45, 60)] }),
    safe: 'below',
    doomed: 500,
    flowpipe: 468.8,
    says: FAST,
  },
  'the speed limit upwards': {
    of: (v) => ({ v: [0, -v], asteroids: BEHIND, novae: [at(0, -45, 60)] }),
    safe: 'below',
    doomed: 500,
    flowpipe: 468.8,
    says: FAST,
  },
};

describe.each(['doomed', 'flowpipe'] as const)('%s, measured', (kind: Kind) => {
  const asked = Object.entries(edges).flatMap(([name, edge], i) => (edge[kind] === undefined ? [] : [[name, edge, i] as const]));
  it.each(asked)('%s', (_, { of, grid, asked, safe, says, ...edge }, i) => {
    const sign = safe === 'above' ? 1 : -1;
    const isMeasuredTwice = Array.isArray(edge[kind]);
    const own = (kind === 'doomed' ? i : i + 1) % TURNS.length;
    for (const [n, turn] of TURNS.entries()) {
      if (n !== own && !isMeasuredTwice && !isHunt) continue;
      const steps = grid?.steps ?? 12;
      const axis = [turn.c, turn.s] as const;
      const certificate =
        kind === 'doomed'
          ? doomedBy({ axis, frames: 4, ...SIZES.doomed, ...grid }, steps)
          : flowpipeBy({ axis, frames: 4, ...SIZES.flowpipe, ...grid, steps });
      const why = (value: number) => whyNot(levelOf(of(value), turn), certificate, asked);
      const begins = [edge[kind] ?? 0].flat()[isMeasuredTwice ? n : 0];
      expect(why(begins - sign * 0.01)).toContain(says ?? `some runs may continue after ${steps} steps`);
      expect(why(begins + sign * 0.01)).toBeNull();
    }
  });
});
