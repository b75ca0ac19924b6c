import { TICK } from '../../../engine/index.ts';
import type { About, OrbitGrid, Proof } from '../proof.ts';
import { soonOverReason } from '../say.ts';
import { EXACT, type Setting, startsMoving, type Thing } from '../setting.ts';
import { followOrbits } from './follow.ts';

/** Random plays may last this long, s. */
const LONGEST_PLAY = 12;

/** How long she is followed at most, s: she may hover where random plays do not. */
const LONGEST = 20;

/**
 * The steps that are claimed, as a factor of those needed and steps more: the checker computes sets of its own, which may end
 * somewhat later.
 */
const SPARE = [1.5, 8] as const;

/** Grids by fineness, and how many boxes are followed on each. Too many boxes on a coarse grid hardly ever end. */
const TRIES: readonly { readonly grid: OrbitGrid; readonly boxes: number }[] = [
  { grid: { place: 6, speed: 6, momentum: 1500, frames: 12 }, boxes: 100_000 },
  { grid: { place: 4, speed: 4, momentum: 1000, frames: 12 }, boxes: 250_000 },
  { grid: { place: 3, speed: 3, momentum: 1000, frames: 12 }, boxes: 400_000 },
  { grid: { place: 2, speed: 2, momentum: 1000, frames: 12 }, boxes: 400_000 },
];

/** The greatest fineness at which `orbits` differs from a lower one. */
export const FINEST_ORBITS = TRIES.length - 1;

/** The most boxes that are followed on any grid. */
export const MOST_ORBITS = Math.max(...TRIES.map(({ boxes }) => boxes));

/** Whether `orbits` may find a proof. */
export const mayOrbit = ({ level, jump }: Setting): boolean => jump === 0 && startsMoving(level);

/**
 * `orbits`: from a moving start, every run ends at a hazard or out of range within seconds, and none comes near the object. It
 * covers `precise` only.
 *
 * Like `doomed` it computes a reachable set with interval arithmetic, but in coordinates about the nearest asteroid
 * ({@link followOrbits}): distance, direction, radial speed and angular momentum. While one asteroid stays the nearest and no
 * field or wind acts, her angular momentum about it is constant whatever is pressed (lemma `momentum`), so the set stays thin for
 * several seconds. The certificate names the grid only; the checker computes the sets by itself. Rests on the lemmas `reach`,
 * `pushes`, `momentum`, `drift`, `speed limit`, `mouths` and `winds`.
 * @param fineness 0 for a coarse grid that takes about a second at most, up to {@link FINEST_ORBITS} for finer ones that may take
 * several
 */
export function proveOrbits(setting: Setting, about: About, goal: Thing, fineness = 0): Proof | null {
  const { level, maxTime } = setting;
  if (!mayOrbit(setting)) return null;
  if (setting.longestPlay(LONGEST_PLAY) === null) return null;
  const { grid, boxes } = TRIES[Math.min(fineness, FINEST_ORBITS)];
  const most = Math.ceil(LONGEST / (grid.frames * TICK));
  const { closed, steps: needed, endedBy } = followOrbits(setting, about, goal, grid, { steps: most, boxes });
  // What is over at the start is for the provers of the start.
  if (!closed || needed === 0) return null;
  const steps = Math.ceil(SPARE[0] * needed) + SPARE[1];
  const seconds = steps * grid.frames * TICK;
  return {
    code: 'orbits',
    about,
    reason: soonOverReason(about, seconds, endedBy),
    covers: EXACT,
    maxTime: level.recoil ? maxTime : null,
    certificate: { kind: 'orbits', grid, steps },
  };
}

export { followOrbits } from './follow.ts';
