import type { Hold, Level } from '../../schema/basics/index.ts';
import type { Accuracy } from '../accuracy.ts';
import { compile } from '../compile.ts';
import { TICK } from '../constants.ts';
import { ContinuousSimulation, methodWith } from '../continuous/index.ts';
import type { Effect } from '../effects/index.ts';
import type { EventRule, Motion } from '../motion/index.ts';
import type { Scene } from '../scene.ts';
import { joinHolds, playScript } from '../script.ts';
import { createSimulation } from '../simulate.ts';
import type { Simulation } from '../simulation.ts';
import { maxTicksOf } from '../terms.ts';
import { unlimited } from '../work-budget.ts';

/** Something whose cost per simulated second is measured. */
export interface Player {
  /** Players with the same name here run the same code: to warm one warms all. */
  readonly code: string;
  /** Called before each `play`; not timed. */
  prepare?(): void;
  /** Does the work once; returns the seconds it simulated. */
  play(): number;
}

/** A cost in microseconds per simulated second. */
export interface Cost {
  /** Disturbances only add to a time, so this is nearest to the truth. */
  readonly minimum: number;
  /** The upper quartile. */
  readonly high: number;
  /** How often it was timed: {@link FEWEST_ROUNDS} times at least, unless the time was used up. */
  readonly rounds: number;
}

interface CostOptions {
  /** Approximate time for the whole measurement, ms. */
  readonly budget: number;
  /** The longest that it takes, ms; a play that has begun ends. */
  readonly most: number;
  /** Shortest time of one sample, ms; shorter work is repeated within the sample. */
  readonly sample: number;
}

export const FEWEST_ROUNDS = 5;
const MOST_ROUNDS = 41;

/** A player is warm when so many turns in a row did not make it faster by more than a twentieth. */
const CALM_TURNS = 8;
const FASTER = 0.95;
/** A turn of warming up, in samples. */
const WARM_SAMPLES = 4;
/** The first player of a code plays for at least so many turns: compilers decide by how often functions ran, not by time. */
const LEAST_TURNS = 75;
/** Largest number of plays that are timed together to find out how long one takes. */
const MOST_PLAYS = 1024;

/**
 * Times players against each other. They take turns (A B C, B C A, ...), so a disturbance of the machine affects all of them.
 * @param now - a clock, ms
 * @returns one cost per player, in the same order; null for those whose turn did not come: the last ones, as the first has one
 */
export function measureCosts(players: readonly Player[], now: () => number, options: CostOptions): (Cost | null)[] {
  const { budget, sample } = options;
  const end = now() + options.most;
  const time = (player: Player, times: number): readonly [ms: number, seconds: number] => {
    let ms = 0;
    let seconds = 0;
    if (player.prepare === undefined) {
      const start = now();
      for (let i = 0; i < times; i++) seconds += player.play();
      return [now() - start, seconds];
    }
    for (let i = 0; i < times; i++) {
      player.prepare();
      const start = now();
      seconds += player.play();
      ms += now() - start;
    }
    return [ms, seconds];
  };

  const once = warmUp(players, time, now, [now() + budget / 2, end], sample);
  const times = once.map(({ ms }) => Math.max(1, Math.round(sample / Math.max(ms, 1e-3))));
  const round = once.reduce((sum, { ms }, i) => sum + ms * times[i], 0);
  const rounds = Math.max(FEWEST_ROUNDS, Math.min(MOST_ROUNDS, Math.floor((0.5 * budget) / Math.max(round, 1e-3))));

  const samples = players.map((): number[] => []);
  for (let turn = 0; turn < rounds * players.length && now() <= end; turn++) {
    const i = (turn + Math.floor(turn / players.length)) % players.length;
    const [ms, seconds] = time(players[i], times[i]);
    samples[i].push((1000 * ms) / seconds);
  }
  return samples.map((list, i) => {
    const { ms, seconds } = once[i];
    if (seconds === 0) return null;
    if (list.length === 0) list.push((1000 * ms) / seconds);
    list.sort((a, b) => a - b);
    return { minimum: list[0], high: list[Math.floor(0.75 * list.length)], rounds: list.length };
  });
}

/**
 * Lets players play in turns until none gets faster any more, so that code which they share is optimised for all of them before
 * anything counts, and code of only one of them has had its time, too.
 * @param until - by the clock, ms: what is not warm by the first is measured as it is, what has not played by the second does not
 * @returns the least time of one play for each, ms, and what it simulates, s; 0 for those that have not played
 */
function warmUp(
  players: readonly Player[],
  time: (player: Player, times: number) => readonly [ms: number, seconds: number],
  now: () => number,
  [until, end]: readonly [until: number, end: number],
  sample: number,
): { readonly ms: number; readonly seconds: number }[] {
  const least = players.map(() => Number.POSITIVE_INFINITY);
  const simulated = players.map(() => 0);
  const plays = players.map(() => 1);
  const calm = players.map(() => 0);
  const isFirst = players.map(({ code }, i) => players.findIndex((other) => other.code === code) === i);
  let warming = [...players.keys()];
  for (let turn = 1; warming.length > 0; turn++) {
    for (const i of warming) {
      if (i > 0 && now() > end) break;
      const before = least[i];
      for (let spent = 0; spent < WARM_SAMPLES * sample; ) {
        const [ms, seconds] = time(players[i], plays[i]);
        simulated[i] = seconds / plays[i];
        // a coarse clock, as in pages that are not isolated, cannot time one play: as many as it can time
        if (ms < sample && plays[i] < MOST_PLAYS) plays[i] *= 2;
        else least[i] = Math.min(least[i], ms / plays[i]);
        // a clock that stands still ends the turn, too
        spent += Math.max(ms, plays[i] < MOST_PLAYS ? 1e-3 : sample);
      }
      calm[i] = least[i] < FASTER * before ? 0 : calm[i] + 1;
    }
    if (now() > until) break;
    warming = warming.filter((i) => calm[i] < CALM_TURNS || (isFirst[i] && turn < LEAST_TURNS));
  }
  return least.map((ms, i) => ({ ms: Number.isFinite(ms) ? ms : sample, seconds: simulated[i] }));
}

/** A player that plays holds on levels at one setting, one after the other. */
export function playerOf(
  runs: readonly { readonly level: Level; readonly holds: readonly Hold[] }[],
  accuracy: Accuracy,
  maxTicks: number,
): Player {
  const made = runs.map(({ level, holds }) => ({
    simulation: createSimulation(compile(level, accuracy)),
    script: joinHolds(holds),
  }));
  return {
    code: accuracy.integrator,
    play: () => made.reduce((seconds, { simulation, script }) => seconds + secondsOf(simulation, script, maxTicks), 0),
  };
}

/** Plays a script from the start; returns the seconds that it simulated. */
function secondsOf(simulation: Simulation, script: ReturnType<typeof joinHolds>, maxTicks: number): number {
  simulation.reset();
  playScript(simulation, script, maxTicks);
  return simulation.ending?.time ?? simulation.tick * TICK;
}

/** What an effect takes of a run's time. */
export interface EffectTime {
  /** Name of the effect. */
  readonly name: string;
  /** Microseconds per simulated second; null: the time for measuring was used up before. */
  readonly time: number | null;
}

/** How long effects are timed, and a sample of them, ms. */
export const EFFECT_TIMING: CostOptions = { budget: 2000, most: 4000, sample: 2 };

/** What an effect does is repeated so many times, so that its cost stands out from the noise of the clock. */
const MORE = 8;

/**
 * Measures what each effect of a run costs: how much longer the run takes when all that the effect looks for is looked for
 * twice, and all bodies that it moves are moved twice. That changes no result by more than rounding. What remains is her own
 * motion. The run must be known to end.
 *
 * @param scene - the scene
 * @param holds - half-open intervals [press, release) in ticks of 1/60 s; overlapping ones are joined
 * @param now - a clock, ms
 * @param options - how long to measure
 * @returns the time of the whole run, and of each simulated effect; null under `arcade`, whose frames examine everything
 */
export function timeByEffect(
  scene: Scene,
  holds: readonly Hold[],
  now: () => number,
  options: CostOptions,
): { readonly whole: Cost; readonly effects: readonly EffectTime[] } | null {
  if (scene.accuracy.integrator === 'arcade') return null;
  const script = joinHolds(holds);
  const maxTicks = maxTicksOf(scene.terms);
  const names = scene.effects.simulated.map(({ name }) => name);
  // the same for all, so that they differ in how often they look, and in nothing else
  const players = [null, ...names].map((repeated): Player => {
    const method = methodWith((effect) => lookedFor(effect, effect.name === repeated ? 1 + MORE : 1));
    const simulation = new ContinuousSimulation(method, scene, null, unlimited());
    return { code: 'any', play: () => secondsOf(simulation, script, maxTicks) };
  });
  const [first, ...others] = measureCosts(players, now, options);
  const whole = first as Cost;
  const more = others.map((cost) => cost && Math.max(0, (cost.minimum - whole.minimum) / MORE));
  return { whole, effects: names.map((name, i) => ({ name, time: more[i] })) };
}

/** An effect that looks for its events, and expands what follows her, so many times. For tests. */
export function lookedFor(effect: Effect, times: number): Effect {
  const again = <A extends unknown[]>(look: ((m: Motion, ...rest: A) => void) | null) =>
    look === null
      ? null
      : (m: Motion, ...rest: A) => {
          for (let n = 0; n < times; n++) look(m, ...rest);
        };
  const { events, following } = effect;
  return {
    ...effect,
    events: events?.map((rule: EventRule) => ({
      ...rule,
      guard: again(rule.guard),
      first: again(rule.first),
      always: again(rule.always),
    })),
    following: following && {
      ...following,
      expand(m, longest) {
        for (let n = 1; n < times; n++) following.expand(m, longest);
        return following.expand(m, longest);
      },
    },
  };
}

/**
 * A quantile by linear interpolation between the closest ranks; `p` is from 0 to 1.
 * @throws {RangeError} if there are no values
 */
export function quantile(values: readonly number[], p: number): number {
  if (values.length === 0) throw new RangeError('expected at least one value, found none');
  const sorted = [...values].sort((a, b) => a - b);
  const place = p * (sorted.length - 1);
  const low = Math.floor(place);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
}
