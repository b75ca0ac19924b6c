import { TICK } from '../../engine/index.ts';
import { followFan } from './fan.ts';
import type { About, Blocker, FanGrid, Proof } from './proof.ts';
import { distance } from './rounding.ts';
import { subject, thing } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, type Setting, type Thing } from './setting.ts';

/** How finely, ticks a step and px and px/s a square: the coarse one is enough mostly. */
const GRIDS = [
  { cell: 8, bin: 16, frames: 6 },
  { cell: 4, bin: 8, frames: 4 },
] as const;

/** What isn't over by then, s, or by so many boxes, will go on for long: a certificate has no more, and stays below 1 MB as JSON. */
const LONGEST = 8;
const MOST_BOXES = 10_000;

/** How far a fan is followed over a grid. */
export const mostOf = ({ frames }: FanGrid) => ({ steps: Math.floor(LONGEST / (frames * TICK)), boxes: MOST_BOXES });

/** Farther out, px, places of frames are rounded too coarsely. */
const FAR_OUT = 1e6;

/** Whatever she presses she runs into a hazard or out of range within seconds, and comes nowhere near the thing. */
export function proveDoomed(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, maxTime } = setting;
  const { vx, vy } = level.astronaut;
  const pushed = [...level.repulsors, ...level.winds].some((field) => distance(field, level.astronaut) <= field.radius);
  // at rest she can wait as long as she likes
  if (vx === 0 && vy === 0 && !pushed) return null;
  const isFarOut = Math.max(Math.abs(level.astronaut.x), Math.abs(level.astronaut.y)) > FAR_OUT;
  for (const fineness of GRIDS) {
    const grid: FanGrid = { ...fineness, axis: startAxis(setting) };
    const { closed, layers, endedBy } = followFan(setting, about, goal, grid, mostOf(grid));
    if (!closed) continue;
    return {
      code: 'doomed',
      about,
      reason: reasonOf(about, layers.length * grid.frames * TICK, endedBy),
      covers: isFarOut ? CONTINUOUS : ALL_ACCURACIES,
      maxTime: level.recoil ? maxTime : null,
      certificate: { kind: 'doomed', grid, layers },
    };
  }
  return null;
}

/** The grid's first axis: towards the asteroid nearest to the start, so that the first pull is along it. */
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

/** What runs end at, as a list in words. */
export function whatEnds(endedBy: readonly Blocker[]): string {
  const names = endedBy.map((by) => (by.kind === 'range' ? 'the end of the range' : thing(by)));
  const last = names.pop();
  return names.length > 0 ? `${names.join(', ')} or ${last}` : `${last}`;
}

function reasonOf(about: About, seconds: number, endedBy: readonly Blocker[]): string {
  return (
    `${subject(about)} is never reached: with the speed she has at the start every run ends within ${Math.ceil(seconds * 10) / 10} s ` +
    `at ${whatEnds(endedBy)}, whatever is pressed: start slower, elsewhere or in another direction, or clear her way`
  );
}
