import { compile, joinHolds, type Run, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { RandomScene } from '../scenes/random-scene.ts';
import { bySmallSteps } from './small-steps.ts';

/** Two step sizes, s: where the results by small steps differ between them, they decide nothing. */
const STEPS = [1 / 2000, 1 / 2700] as const;

/** Step sizes that decide where the engine and the first two disagree, s. */
const FINE_STEPS = [1 / 20_000, 1 / 31_000] as const;

/** Tolerated difference of places, px, and tolerated difference between the results of two step sizes. */
const MOST = 1e-6;
const DOUBT = 1e-8;

/** By how much the start is moved to see how errors grow, px, and how much they may grow. */
const NUDGE = 1e-7;
const MOST_GROWTH = 100;

/** Last digits of places are compared only near the origin, px. */
const FAR = 1e5;

export type StepsFinding =
  | { readonly what: 'agrees'; readonly jumps: number; readonly crossings: number }
  | { readonly what: 'vague' }
  | { readonly what: 'bug'; readonly why: string };

/** Compares her place in `precise` at the end of a scene with that of another program, which makes only small steps. */
export function checkBySteps({ level, holds, maxTime }: RandomScene): StepsFinding {
  const { x, y } = level.astronaut;
  if (Math.abs(x) > FAR || Math.abs(y) > FAR) return { what: 'vague' };
  const script = joinHolds(holds);
  const run = play(level, script, maxTime);
  if (run.outcome !== 'timeout' || nearsSpeedLimit(run)) return { what: 'vague' };
  const rough = compared(level, script, maxTime, STEPS, run);
  if (rough === null) return { what: 'vague' };
  const own = run.events.filter(({ type }) => type === 'effect');
  const jumps = own.filter((event) => event.type === 'effect' && event.effect === 'wormholes').length;
  if (rough <= MOST) return { what: 'agrees', jumps, crossings: own.length - jumps };
  const fine = compared(level, script, maxTime, FINE_STEPS, run);
  if (fine === null) return { what: 'vague' };
  if (fine <= MOST) return { what: 'agrees', jumps, crossings: own.length - jumps };
  if (grows(level, script, maxTime, run)) return { what: 'vague' };
  return { what: 'bug', why: `${fine} px from where small steps have her after ${maxTime} s` };
}

const play = (level: Level, holds: readonly Hold[], maxTime: number): Run =>
  simulate(compile(level, 'precise'), holds, { maxTime });

/** Distance between the ends of the run and of the small steps, px; null if the latter depends on the step size. */
function compared(
  level: Level,
  holds: readonly Hold[],
  maxTime: number,
  [coarser, finer]: readonly [number, number],
  { final }: Run,
): number | null {
  const a = bySmallSteps(level, holds, maxTime, coarser);
  const b = bySmallSteps(level, holds, maxTime, finer);
  if (!(Math.hypot(a.x - b.x, a.y - b.y) < DOUBT)) return null;
  return Math.hypot(final.x - b.x, final.y - b.y);
}

/** Whether a minimal change of the start becomes a large one: then the last digits decide, and both results may be right. */
function grows(level: Level, holds: readonly Hold[], maxTime: number, { final }: Run): boolean {
  const { astronaut } = level;
  return [
    [NUDGE, 0],
    [-NUDGE, 0],
    [0, NUDGE],
    [0, -NUDGE],
  ].some(([dx, dy]) => {
    const moved = play({ ...level, astronaut: { ...astronaut, x: astronaut.x + dx, y: astronaut.y + dy } }, holds, maxTime).final;
    return Math.hypot(moved.x - final.x, moved.y - final.y) > MOST_GROWTH * NUDGE;
  });
}

function nearsSpeedLimit({ trajectory }: Run): boolean {
  const state = new Float64Array(STATE_SIZE);
  for (let time = 0; time <= trajectory.duration; time += 1 / 60) {
    trajectory.at(time, state);
    if (Math.max(Math.abs(state[2]), Math.abs(state[3])) > 950) return true;
  }
  return false;
}
