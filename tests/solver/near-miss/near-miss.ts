import { expect, it } from 'vitest';
import type { AccuracyName } from '../../../engine/index.ts';
import { type Level, type LevelFile, resolveLevel } from '../../../schema/index.ts';
import {
  type About,
  type Certificate,
  type Doomed,
  type FanGrid,
  type Flowpipe,
  type PipeGrid,
  type Proof,
  verifyProof,
} from '../../../solver/index.ts';
import { followBoxes } from '../../../solver/prove/boxes.ts';
import { followPipes } from '../../../solver/prove/pipe.ts';
import { settingOf, thingOf } from '../../../solver/prove/setting.ts';
import { isHunt } from '../../depth.ts';

// The game's numbers from its description and not from the sources: the two must agree.
export const BOX = { halfWidth: 10, halfHeight: 16, halfDiagonal: Math.sqrt(10 * 10 + 16 * 16) };
export const RANGE = 250;
/** px/s² at distance 0 */
export const PULL = 39;
export const TICK = 1 / 60;
/** The direction from the centre of the upright box to its lower right corner. */
export const CORNER = { x: 10 / BOX.halfDiagonal, y: 16 / BOX.halfDiagonal };

/** A level whose start is at 1000, -2000, so that relative and absolute coordinates differ. */
export const ORIGIN = { x: 1000, y: -2000 };

export const at = (x: number, y: number, radius = 16) => ({ x: ORIGIN.x + x, y: ORIGIN.y + y, radius });
export const hot = (x: number, y: number, radius = 16) => ({ ...at(x, y, radius), hot: true });
export const spot = (x: number, y: number) => ({ x: ORIGIN.x + x, y: ORIGIN.y + y });

/** A level at rest that contains only a black hole that nobody reaches; places by {@link at}. */
export const levelWith = (more: Partial<LevelFile>): Level =>
  resolveLevel({ version: 1, name: 'near miss', astronaut: spot(0, 0), blackHole: spot(5000, 5000), asteroids: [], ...more });

export interface Asked {
  readonly covers?: readonly AccuracyName[];
  readonly about?: About;
  readonly maxTime?: number | null;
}

export const CONTINUOUS: readonly AccuracyName[] = ['fast', 'standard', 'precise'];
const HOLE: About = { kind: 'blackHole' };
export const FRAMES: readonly AccuracyName[] = ['arcade'];

export const proofWith = (certificate: Certificate, { covers = CONTINUOUS, about, maxTime = null }: Asked = {}): Proof => ({
  code: certificate.kind,
  about: about ?? HOLE,
  reason: '',
  covers,
  maxTime,
  certificate,
});

/** A certificate for a level, whether it holds or not. */
export type Maker<C extends Certificate = Certificate> = (level: Level, asked?: Asked) => C;

/**
 * The reachable sets over a grid, as far as they can be followed in so many steps. If she may touch the object or goes on, they
 * are as good as any others, and the checker must find it out.
 */
export const doomedBy =
  (grid: FanGrid, steps: number): Maker<Doomed> =>
  (level, { covers = CONTINUOUS, about = HOLE, maxTime = null } = {}) => {
    const setting = settingOf(level, maxTime, covers.includes('arcade'));
    const goal = thingOf(level, about.kind === 'mineral' ? level.minerals[about.index] : level.blackHole);
    const { layers } = followBoxes(setting, about, goal, grid, { steps, boxes: 100_000 });
    return { kind: 'doomed', grid, layers };
  };

/** The same as a flowpipe; the grid gives the number of steps. */
export const flowpipeBy =
  (grid: PipeGrid): Maker<Flowpipe> =>
  (level, { about = HOLE, maxTime = null } = {}) => {
    const goal = thingOf(level, about.kind === 'mineral' ? level.minerals[about.index] : level.blackHole);
    const { layers } = followPipes(settingOf(level, maxTime, false), about, goal, grid, { sets: 25_000, parts: 25_000 });
    return { kind: 'flowpipe', grid, layers };
  };

/** The checker's answer: null, or what is wrong. */
export function whyNot(level: Level, certificate: Certificate | Maker, asked?: Asked): string | null {
  const made = typeof certificate === 'function' ? certificate(level, asked) : certificate;
  const verdict = verifyProof(level, proofWith(made, asked));
  return verdict.ok ? null : verdict.why;
}

export interface NearMiss {
  /** What is wrong, for a varied number; null where the proof is accepted. */
  readonly why: (n: number) => string | null;
  /**
   * The number at which the claim becomes false by the game's rules, or one where it is certainly false, found by simulation.
   */
  readonly truth: number;
  /** The side on which the claim is true. */
  readonly safe: 'above' | 'below';
  /** How far on the safe side acceptance begins: at least, at most. */
  readonly slack: readonly [least: number, most: number];
  /** The checker's answer on the other side. */
  readonly says: string;
  /** How far on the false side it is tried; 5 by default. */
  readonly reach?: number;
  /** How precisely the slack is stated; where a check takes long, fewer numbers are tried, and the farthest only in a hunt. */
  readonly grain?: number;
}

/** Tests the twins: just false is refused for that reason, just true is accepted; and the slack between them. */
export function nearMisses(cases: Readonly<Record<string, NearMiss>>): void {
  for (const [name, one] of Object.entries(cases)) {
    it(`${name}: false at ${Number(one.truth.toPrecision(6))}, slack up to ${one.slack[1]}`, () => expectNearMiss(one));
  }
}

function expectNearMiss({ why, truth, safe, slack, says, reach = 5, grain = 0 }: NearMiss): void {
  const sign = safe === 'above' ? 1 : -1;
  const dear = isHunt ? [grain, reach] : [grain];
  const falseBy = grain > 0 ? dear : [1e-9, 1e-6, 1e-3, 0.1 * reach, reach];
  for (const off of falseBy) expect(why(truth - sign * off), `${off} on the false side`).toContain(says);
  // Acceptance begins between these two.
  const [least, most] = slack;
  if (least - grain > 0) expect(why(truth + sign * (least - grain)), `${least} on the true side`).not.toBeNull();
  expect(why(truth + sign * most), `${most} on the true side`).toBeNull();
}
