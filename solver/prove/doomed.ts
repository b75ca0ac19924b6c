import { TICK } from '../../engine/index.ts';
import { followBoxes } from './boxes.ts';
import type { About, FanGrid, Proof } from './proof.ts';
import { distance } from './rounding.ts';
import { soonOverReason } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, type Setting, startsMoving, type Thing } from './setting.ts';

/** Grids to try by fineness: ticks per step, and sides of the squares in px and px/s. The coarse one usually suffices. */
const GRIDS = [
  [
    { cell: 8, bin: 16, frames: 6 },
    { cell: 4, bin: 8, frames: 4 },
  ],
  [
    { cell: 4, bin: 8, frames: 4 },
    { cell: 3, bin: 6, frames: 3 },
  ],
] as const;

/** The longest time to follow, s. */
const LONGEST = 8;

/** The most boxes by fineness, which keeps a certificate below 1 or 2 MB of JSON. */
const MOST_BOXES = [10_000, 20_000] as const;

/** How far the reachable set is followed on a grid; the farthest of all without a fineness. */
export const mostOf = ({ frames }: FanGrid, fineness = FINEST_BOXES) => ({
  steps: Math.floor(LONGEST / (frames * TICK)),
  boxes: MOST_BOXES[Math.min(fineness, FINEST_BOXES)],
});

/** Farther out than this, px, places are rounded too coarsely in frames. */
const FAR_OUT = 1e6;

/** The greatest fineness at which `doomed` differs from a lower one. */
export const FINEST_BOXES = GRIDS.length - 1;

/** Whether `doomed` may find a proof. */
export const mayDoom = ({ level }: Setting): boolean => startsMoving(level);

/**
 * `doomed`: from a moving start, every run ends at a hazard or out of range within seconds, whatever is pressed, and none comes
 * near the object.
 *
 * It computes the reachable set with interval arithmetic ({@link followBoxes}): boxes in place and velocity that contain every
 * state of every run, at the start and after each step. In one step a box grows by all accelerations that are possible at the
 * places it passes. That covers every method, because each adds up accelerations of places on the path, with positive weights of
 * the right sum (lemma `pushes`). Only where frames are asked for do boxes contain what frames do. The certificate holds all boxes, so nobody has to trust how
 * they were cut and joined. Rests on the lemmas `reach`, `pushes`, `recoil in steps`, `drift`, `speed limit`,
 * `mouths` and `winds`.
 * @param fineness 0, or 1 for finer grids and larger certificates
 */
export function proveDoomed(setting: Setting, about: About, goal: Thing, fineness = 0): Proof | null {
  const { level, maxTime, jump } = setting;
  if (!mayDoom(setting)) return null;
  const isFarOut = Math.max(Math.abs(level.astronaut.x), Math.abs(level.astronaut.y)) > FAR_OUT;
  for (const sizes of GRIDS[Math.min(fineness, FINEST_BOXES)]) {
    const grid: FanGrid = { ...sizes, axis: startAxis(setting) };
    const { closed, layers, endedBy } = followBoxes(setting, about, goal, grid, mostOf(grid, fineness));
    if (!closed) continue;
    return {
      code: 'doomed',
      about,
      reason: soonOverReason(about, layers.length * grid.frames * TICK, endedBy),
      covers: jump === 0 || isFarOut ? CONTINUOUS : ALL_ACCURACIES,
      maxTime: level.recoil ? maxTime : null,
      certificate: { kind: 'doomed', grid, layers },
    };
  }
  return null;
}

/** The first axis of the grid: towards the asteroid nearest to the start, so that the first pull lies along it. */
export function startAxis({ level: { asteroids, astronaut } }: Setting): readonly [number, number] {
  let best = Number.POSITIVE_INFINITY;
  let axis: readonly [number, number] = [1, 0];
  for (const a of asteroids) {
    const d = distance(a, astronaut);
    if (d >= best || d === 0) continue;
    best = d;
    axis = [(a.x - astronaut.x) / d, (a.y - astronaut.y) / d];
  }
  return axis;
}
