import { ACCURACIES, type Accuracy, type AccuracyName, compile, type Run, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import type { RandomScene } from '../scenes/random-scene.ts';
import { differencesInParts } from './parts.ts';
import { verifyRun } from './verify-run.ts';

/**
 * `bug` must not occur. `hangs` is a run whose outcome depends on its last digits: it is reported, but not as an error of the
 * engine. `excluded` is a scene about which nothing was decided.
 */
export interface Finding {
  readonly kind: 'bug' | 'hangs' | 'excluded';
  readonly accuracy: string;
  readonly what: string;
}

const TIGHTER: Accuracy = { ...ACCURACIES.precise, name: 'precise at 1e-11', tolerance: 1e-11 };

/**
 * How far a place may be beyond what a rule allows, px. With fixed steps the displayed places differ from those that guards
 * use.
 */
const SLACK: Readonly<Record<AccuracyName, number>> = {
  arcade: Number.POSITIVE_INFINITY,
  fast: 0.1,
  standard: 1e-3,
  precise: 1e-8,
};

/** Relative change of energy and angular momentum allowed per tick. */
const DRIFT: Readonly<Record<AccuracyName, number>> = {
  arcade: Number.POSITIVE_INFINITY,
  fast: 1e-2,
  standard: 1e-3,
  precise: 1e-10,
};

/** More pieces than this per second of play mean that the run does not advance. */
const MOST_PIECES_A_SECOND = 2000;

/**
 * Looks for any error in a scene: broken rules along the path, numbers that are not finite, runs that do not advance, different
 * bits when split or continued from snapshots, and a different ending at a tighter tolerance.
 */
export function checkScene({ level, holds, maxTime }: RandomScene, seed: number): Finding[] {
  const findings: Finding[] = [];
  for (const accuracy of ['precise', 'standard', 'fast'] as const) {
    const bug = (what: string) => findings.push({ kind: 'bug', accuracy, what });
    try {
      const scene = compile(level, accuracy);
      const run = simulate(scene, holds, { maxTime });
      const slack = SLACK[accuracy] + 4e-15 * (Math.abs(level.astronaut.x) + Math.abs(level.astronaut.y));
      for (const what of verifyRun(scene, holds, run, slack, DRIFT[accuracy])) bug(what);
      for (const what of differencesInParts(scene, run, holds, maxTime, seed, () => undefined)) bug(what);
      const { pieces } = run.work;
      if (pieces > 1000 + MOST_PIECES_A_SECOND * run.time) bug(`${pieces} pieces`);
      if (accuracy === 'precise') findings.push(...atTwoTolerances(level, holds, maxTime, run));
    } catch (error) {
      bug(`throws ${error instanceof Error ? error.message : error}`);
    }
  }
  return findings;
}

function atTwoTolerances(level: Level, holds: readonly Hold[], maxTime: number, run: Run): Finding[] {
  const tighter = simulate(compile(level, TIGHTER), holds, { maxTime });
  const difference = firstDifference(run, tighter);
  if (difference === null) return [];
  // if a start moved by a billionth of a pixel also changes the ending, the run is unstable and the engine is not at fault
  const { x, y } = level.astronaut;
  const step = Math.max(1e-9, 1e-15 * Math.max(Math.abs(x), Math.abs(y)));
  const moves = [
    [step, 0],
    [-step, 0],
    [0, step],
    [0, -step],
  ];
  const hangs = [run, tighter].some((still, i) =>
    moves.some(([dx, dy]) => {
      const of = { ...level, astronaut: { ...level.astronaut, x: x + dx, y: y + dy } };
      const moved = simulate(compile(of, i === 0 ? 'precise' : TIGHTER), holds, { maxTime });
      return ending(moved) !== ending(still) || Math.abs(moved.time - still.time) > 1e-6;
    }),
  );
  return [{ kind: hangs ? 'hangs' : 'bug', accuracy: 'precise', what: `two tolerances: ${difference}` }];
}

const ending = (run: Run): string => `${run.outcome} ${run.with?.kind} ${run.with?.index}`;

/** The first event in which two runs of the same script differ, if they end differently; otherwise null. */
function firstDifference(a: Run, b: Run): string | null {
  if (ending(a) === ending(b) && Math.abs(a.time - b.time) < 1e-6) return null;
  const name = (run: Run, i: number) => {
    const event = run.events[i];
    return event === undefined ? 'nothing more' : JSON.stringify(event);
  };
  for (let i = 0; i < Math.max(a.events.length, b.events.length); i++) {
    const { time: ta, ...ea } = a.events[i] ?? { time: -1 };
    const { time: tb, ...eb } = b.events[i] ?? { time: -1 };
    if (JSON.stringify(ea) !== JSON.stringify(eb) || Math.abs(ta - tb) > 1e-6) return `${name(a, i)} against ${name(b, i)}`;
  }
  return `${ending(a)} against ${ending(b)}`;
}
