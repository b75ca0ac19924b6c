import { compile, type Run, type Scene, STATE_SIZE, simulate, WorkBudget } from '../../engine/index.ts';
import { NotCovered, type Played, play, type Sample, taylor } from '../../engine/work-precision/reference/index.ts';
import type { RandomScene } from '../scenes/random-scene.ts';

/** What `precise` promises, times how a change of the start grows: px, px/s and s. */
const PROMISE = 1e-9;

/** Beyond this growth the last digits decide. */
const ILL = 1e6;

/** Growth between two samples may be larger than at them: what is compared on the way, and within how much of the promise. */
const MOST_ON_THE_WAY = 1e4;
const SLACK_ON_THE_WAY = 10;

/** Growth of the time of the end above which what she touches is grazed, s per px. */
const MOST_GRAZING = 2;

/** What touches exactly may be moved into as slowly as with t^4, so that rounding hides the beginning, s. */
const LATEST_TOUCH = 1e-6;

/** By how much the start is moved to measure growth, px and px/s. */
const NUDGE = 1e-9;

/** Ticks between two places that are compared. */
const EVERY = 10;

/** Work after which the reference gives up, evaluations of a force or a guard. */
const MOST_WORK = 20_000_000;

/** Pieces of motion that a second of play may take. */
const MOST_PIECES = 20_000;

/** Bounces and passes that the engine treats as something simpler, see docs/decisions.md: s and px. */
const SHORTEST_BOUNCE = 1 / 1000;
const NEAREST_PASS = 1e-6;

/** What a comparison says about a scene. */
export interface Judgement {
  /** Why the end was not compared; null if it was. */
  readonly excluded: string | null;
  /** What is wrong with the engine. */
  readonly bugs: readonly { readonly accuracy: string; readonly what: string }[];
  /** The largest difference at the end, in units of what is promised. */
  readonly error: number;
}

const value = ({ hi, lo }: { readonly hi: number; readonly lo: number }): number => hi + lo;

const NUDGES = [
  [NUDGE, 0, 0, 0],
  [0, NUDGE, 0, 0],
  [0, 0, NUDGE, 0],
  [0, 0, 0, NUDGE],
] as const;

const endingOf = ({ outcome, with: touched }: Pick<Run, 'outcome' | 'with'> | Played): string =>
  touched === null ? outcome : `${outcome} with ${touched.kind} ${touched.index}`;

/** Holds the engine against the reference: where she is all along, how and when the run ends, what she collects. */
export function judgeScene({ level, holds, maxTime }: RandomScene): Judgement {
  const maxTicks = Math.round(maxTime * 60);
  const playFrom = (nudge: readonly [number, number, number, number]) =>
    play(level, holds, { method: taylor, maxTicks, every: EVERY, nudge, mostWork: MOST_WORK });
  let truth: Played;
  let nudged: Played[];
  try {
    truth = playFrom([0, 0, 0, 0]);
    nudged = NUDGES.map(playFrom);
  } catch (error) {
    if (error instanceof NotCovered) return { excluded: error.message, bugs: [], error: 0 };
    throw error;
  }
  const bugs: { accuracy: string; what: string }[] = [];
  const bug = (accuracy: string, what: string) => bugs.push({ accuracy, what });
  const run = played(compile(level, 'precise'), holds, maxTime);
  if (typeof run === 'string') return { excluded: null, bugs: [{ accuracy: 'precise', what: run }], error: 0 };

  const simple = simplified(level, truth);
  if (simple !== null) return { excluded: simple, bugs, error: 0 };
  const isExact = truth.margins.exact > 0;
  const alike = nudged.filter((other) => endingOf(other) === endingOf(truth));
  const agreeing = isExact ? alike.filter((other) => growth(truth.end, other.end) < ILL) : nudged;
  // the promise is one of places relative to the level, whose numbers have 16 digits
  const far = 1 + 1e-6 * (Math.abs(level.astronaut.x) + Math.abs(level.astronaut.y));
  const wrongPlace = differsOnTheWay(run, truth, agreeing, far);
  if (wrongPlace !== null) bug('precise', wrongPlace);
  const all = alike.length === nudged.length || isExact;
  const grown = Math.max(1, ...agreeing.map((other) => growth(truth.end, other.end)));
  const grownTime = Math.max(1, ...agreeing.map((other) => apart(other.end.time, truth.end.time) / NUDGE));
  const narrow = narrowness(truth, grown);
  let excluded: string | null = null;
  if (!all || agreeing.length === 0 || grown > ILL) excluded = 'ill-conditioned';
  else if (narrow !== null) excluded = narrow;
  if (excluded !== null) return { excluded, bugs, error: 0 };

  // of things that are touched exactly, which is no contact, several may be entered at the same instant
  const either = truth.margins.exact > 1 && run.outcome === truth.outcome && run.time === value(truth.end.time);
  if (endingOf(run) !== endingOf(truth) && !either) {
    bug('precise', `${endingOf(run)} at ${run.time} s; it should be ${endingOf(truth)} at ${value(truth.end.time)} s`);
    return { excluded, bugs, error: Number.POSITIVE_INFINITY };
  }
  const error = Math.max(
    distance(run.final, truth.end) / (PROMISE * grown * far),
    Math.abs(run.time - value(truth.end.time)) / Math.max(PROMISE * grownTime, isExact ? LATEST_TOUCH : 0),
  );
  if (!(error <= 1))
    bug('precise', `ends ${distance(run.final, truth.end)} px and ${run.time - value(truth.end.time)} s off, growth ${grown}`);
  const collected = run.minerals.map(({ index }) => index).sort((a, b) => a - b);
  const toCollect = truth.minerals.map(({ index }) => index).sort((a, b) => a - b);
  if (String(collected) !== String(toCollect)) bug('precise', `collects minerals [${collected}]; it should be [${toCollect}]`);
  // of these her path alone says nothing: what she may touch moves, with errors of its own
  const moves = level.aliens.length > 0 || (level.recoil && level.asteroids.some(({ hot }) => hot));
  for (const accuracy of moves ? [] : (['standard', 'fast'] as const)) {
    const what = endsOtherwise(played(compile(level, accuracy), holds, maxTime), truth, grownTime);
    if (what !== null) bug(accuracy, what);
  }
  return { excluded, bugs, error };
}

/** Plays with a limit on pieces, and looks for numbers that are none. */
function played(scene: Scene, holds: RandomScene['holds'], maxTime: number): Run | string {
  try {
    const run = simulate(scene, holds, { maxTime, budget: new WorkBudget(MOST_PIECES * maxTime) });
    if (run.stopped !== null) return `takes more than ${MOST_PIECES} pieces a second, up to ${run.time} s`;
    const { x, y, vx, vy, cos, sin } = run.final;
    if (![x, y, vx, vy, cos, sin, run.time].every(Number.isFinite)) return 'the end is not finite';
    return run;
  } catch (error) {
    return `throws ${error instanceof Error ? error.message : error}`;
  }
}

/** By how much a small change of the start has grown at a moment. */
const growth = (a: Sample, b: Sample): number =>
  Math.max(
    ...(['x', 'y'] as const).flatMap((axis) => [apart(a.at[axis], b.at[axis]), apart(a.velocity[axis], b.velocity[axis])]),
  ) / NUDGE;

/** The difference of two numbers with 32 digits. */
const apart = (a: Sample['time'], b: Sample['time']): number => Math.abs(a.hi - b.hi + (a.lo - b.lo));

const distance = (a: { x: number; y: number; vx: number; vy: number }, b: Sample): number =>
  Math.max(
    Math.hypot(a.x - value(b.at.x), a.y - value(b.at.y)),
    Math.hypot(a.vx - value(b.velocity.x), a.vy - value(b.velocity.y)),
  );

/** Where she first is elsewhere than she should be, as long as small changes have not grown too much. */
function differsOnTheWay(run: Run, truth: Played, nudged: readonly Played[], far: number): string | null {
  const state = new Float64Array(STATE_SIZE);
  let grown = 1;
  for (const [i, sample] of truth.samples.entries()) {
    const time = value(sample.time);
    if (time > run.time) return null;
    for (const other of nudged) {
      if (i >= other.samples.length) return null;
      grown = Math.max(grown, growth(sample, other.samples[i]));
    }
    if (grown > MOST_ON_THE_WAY || narrowness(truth, grown) !== null) return null;
    // what happens at the start may show a moment later
    if (time === 0) continue;
    run.trajectory.at(time, state);
    const off = distance({ x: state[0], y: state[1], vx: state[2], vy: state[3] }, sample);
    const promised = PROMISE * grown * far;
    if (!(off <= SLACK_ON_THE_WAY * promised)) {
      return `is ${off} px off at ${time.toFixed(4)} s, where changes of the start have grown by ${grown}`;
    }
  }
  return null;
}

/** Why a run is one of those that the engine simplifies on purpose; null if it is none. */
function simplified({ winds }: RandomScene['level'], truth: Played): string | null {
  if (truth.slides.has('wind') || (truth.slides.size > 0 && winds.length > 0)) return 'slides on a rim in a wind';
  if (truth.quickestCrossing < SHORTEST_BOUNCE) return 'bounces on a rim';
  if (truth.nearestCentre < NEAREST_PASS && winds.length > 0) return 'passes a centre in a wind';
  return null;
}

/** Why the last digits may decide, although nudges changed nothing; null if they do not. */
function narrowness(truth: Played, grown: number): string | null {
  const least = 10 * PROMISE * grown;
  if (truth.margins.narrowest < least) return 'narrow miss';
  if (truth.clearance < least) return 'narrow gap';
  if (truth.narrowestOrder > 0 && truth.narrowestOrder < PROMISE) return 'narrow order';
  return null;
}

/** Whether an accuracy with fixed steps, which is near enough all along that it must end alike, does not. */
function endsOtherwise(run: Run | string, truth: Played, grownTime: number): string | null {
  if (typeof run === 'string') return run;
  // what is touched exactly now and then is entered by any error, and what is only grazed is missed
  if (truth.margins.exact > 0 || grownTime > MOST_GRAZING) return null;
  const state = new Float64Array(STATE_SIZE);
  let off = 1e-6;
  for (const { time, at, velocity } of truth.samples) {
    if (value(time) > run.time) break;
    run.trajectory.at(value(time), state);
    off = Math.max(off, Math.hypot(state[0] - value(at.x), state[1] - value(at.y)));
    off = Math.max(off, Math.hypot(state[2] - value(velocity.x), state[3] - value(velocity.y)));
  }
  const margin = Math.min(truth.margins.narrowest, truth.clearance, truth.narrowestOrder);
  if (20 * off > margin || endingOf(run) === endingOf(truth)) return null;
  return `${endingOf(run)} at ${run.time} s; it should be ${endingOf(truth)} at ${value(truth.end.time)} s, and she is within ${off} px all along`;
}
