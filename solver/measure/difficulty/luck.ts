import { type Circles, createSimulation, EFFECTS, type Scene, type Simulation, STATE_SIZE, TICK } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { createRandom, type Random } from '../../random.ts';
import { type Goal, mineralsNeeded } from '../../verified-run.ts';
import { wilsonInterval } from '../robustness/index.ts';

// What wins without skill: games that are played at random, and single presses, all of which are tried.

/** How often a player wins who presses at random. */
export interface RandomPlay {
  /** The share of games that meet the goal, 0 to 1. */
  readonly share: number;
  /** Lower end of the 95 % confidence interval (Wilson's score interval), 0 to 1. */
  readonly low: number;
  /** Upper end of the 95 % confidence interval, 0 to 1. */
  readonly high: number;
  /** How many games were played. */
  readonly samples: number;
}

/** A random player waits and holds for 1 to this many ticks (two seconds), all lengths equally likely. */
const RANDOM_PLAY_LONGEST = 120;

/**
 * Plays one random game from the start. It begins with a pause or a hold, equally likely. Pauses and holds alternate, each from
 * 1 to {@link RANDOM_PLAY_LONGEST} ticks long, until the run ends or `maxTicks` have passed.
 * @returns the holds that were played
 */
export function playGameAtRandom(simulation: Simulation, random: Random, maxTicks: number): Hold[] {
  simulation.reset();
  const holds: Hold[] = [];
  let held = random.below(2) === 1;
  while (simulation.ending === null && simulation.tick < maxTicks) {
    const from = simulation.tick;
    const length = Math.min(1 + random.below(RANDOM_PLAY_LONGEST), maxTicks - from);
    simulation.advance(length, held);
    if (held) holds.push([from, from + length]);
    held = !held;
  }
  return holds;
}

/** Measures the share of random games that meet a goal. */
export function playAtRandom(scene: Scene, goal: Goal, options: { samples: number; seed: number; maxTicks: number }): RandomPlay {
  const { samples, seed, maxTicks } = options;
  const needed = mineralsNeeded(goal, scene.minerals.count);
  const random = createRandom(seed);
  const simulation = createSimulation(scene);
  let won = 0;
  for (let sample = 0; sample < samples; sample++) {
    playGameAtRandom(simulation, random, maxTicks);
    if (wins(simulation, needed)) won++;
  }
  return { share: samples === 0 ? 0 : won / samples, ...wilsonInterval(won, samples), samples };
}

/** Whether a simulation has ended in the black hole with at least `needed` different minerals. */
function wins(simulation: Simulation, needed: number): boolean {
  if (simulation.ending?.outcome !== 'completed') return false;
  if (needed === 0) return true;
  let collected = 0;
  for (let i = 0; i < simulation.scene.minerals.count; i++) if (simulation.isCollected(i)) collected++;
  return collected >= needed;
}

/** What all single presses achieve. */
export interface OnePressCount {
  /** Pairs of press and release that meet the goal. */
  readonly count: number;
  /** Pairs tried: every 0 <= press < release <= length at multiples of the stride. */
  readonly tried: number;
  /** The winning pair that is easiest to play, from the middle of the longest row of winning releases; null when none wins. */
  readonly example: readonly Hold[] | null;
  /** Ticks simulated. */
  readonly ticks: number;
}

/**
 * Tries every single press: 0 <= press < release <= `length` (ticks), then drifting on to `maxTicks`. Runs with the same press
 * share the simulation up to the release, and drifting is simulated only where {@link CoastingFilter} cannot rule it out.
 * @param stride only multiples of this many ticks are tried: 1 is exhaustive, more is a sample
 */
export function countOnePress(scene: Scene, goal: Goal, length: number, maxTicks: number, stride = 1): OnePressCount {
  const needed = mineralsNeeded(goal, scene.minerals.count);
  const filter = coastingFilter(scene);
  const coast = createSimulation(scene);
  const held = createSimulation(scene);
  const probe = createSimulation(scene);
  const branch = coast.snapshot();
  const released = coast.snapshot();
  const steps = Math.floor(length / stride);
  let count = 0;
  let ticks = 0;
  let longest = 0;
  let example: readonly Hold[] | null = null;

  for (let press = 0; press < steps; press++) {
    if (coast.ending !== null) {
      // The run ends before these presses, so they change nothing.
      const left = steps - press;
      if (wins(coast, needed)) {
        count += (left * (left + 1)) / 2;
        example ??= [[press * stride, length]];
      }
      break;
    }
    held.restore(coast.snapshot(branch));
    let row = 0;
    const closeRow = (last: number) => {
      if (row > longest) {
        longest = row;
        example = [[press * stride, (last - Math.floor(row / 2)) * stride]];
      }
      row = 0;
    };
    let release = press + 1;
    for (; release <= steps; release++) {
      ticks += held.advance(stride, true);
      if (held.ending !== null) break;
      let won = false;
      if (filter.mayReach(held)) {
        probe.restore(held.snapshot(released));
        ticks += coastOn(probe, filter, maxTicks);
        won = wins(probe, needed);
      }
      if (won) {
        count++;
        row++;
      } else closeRow(release - 1);
    }
    if (held.ending !== null && wins(held, needed)) {
      // She arrives while the button is held, so every later release wins, too.
      count += steps - release + 1;
      row += steps - release + 1;
      release = steps + 1;
    }
    closeRow(release - 1);
    ticks += coast.advance(stride, false);
  }
  return { count, tried: (steps * (steps + 1)) / 2, example, ticks };
}

// Ticks after which the filter is asked again, because a field may have turned her away for good.
const LOOK_AGAIN = 60;

/**
 * Drifts on until the run ends or the black hole is ruled out.
 * @returns ticks advanced
 */
function coastOn(probe: Simulation, filter: CoastingFilter, maxTicks: number): number {
  const from = probe.tick;
  while (probe.ending === null && probe.tick < maxTicks && filter.mayReach(probe)) {
    probe.advance(Math.min(LOOK_AGAIN, maxTicks - probe.tick), false);
  }
  return probe.tick - from;
}

// px; more than the error of any accuracy along a straight line, so that a contact is never ruled out.
const MARGIN = 0.5;

/**
 * Tells without a simulation that drifting on cannot reach the black hole. She flies on a straight line until she meets a
 * disc in which an effect acts on her.
 */
interface CoastingFilter {
  /**
   * Whether drifting on from the state of a simulation may reach the black hole. `false` is certain; `true` means that it has to be
   * simulated.
   */
  mayReach(simulation: Simulation): boolean;
}

/**
 * Creates the filter for a scene. In `arcade` the pull acts for one more frame after a release, so the line becomes a narrow
 * cone.
 */
function coastingFilter(scene: Scene): CoastingFilter {
  const { blackHole } = scene.level;
  const { rules, box } = scene;
  const discs = turningDiscs(scene);
  const drift = scene.accuracy.integrator === 'arcade' ? rules.pull * TICK : 0;
  const state = new Float64Array(STATE_SIZE);
  const meets = (x: number, y: number, reach: number): boolean => {
    const [px, py, vx, vy] = state;
    return meetsDisc(px - x, py - y, vx, vy, reach + MARGIN, drift);
  };
  return {
    mayReach(simulation) {
      simulation.readState(state);
      if (meets(blackHole.x, blackHole.y, blackHole.radius + box.halfDiagonal)) return true;
      for (const { count, x, y, r } of discs) for (let i = 0; i < count; i++) if (meets(x[i], y[i], r[i])) return true;
      return false;
    },
  };
}

/** Discs in which something other than the gun may turn or move her. */
function turningDiscs(scene: Scene): Circles[] {
  const frames = EFFECTS.flatMap((effect) => (effect.frame && effect.calledFor(scene.level).called ? [effect.frame] : []));
  return frames.map((frame) => frame.discs(scene));
}

/** Whether |d + v t| <= reach + drift t for some t >= 0. */
function meetsDisc(dx: number, dy: number, vx: number, vy: number, reach: number, drift: number): boolean {
  const c = dx * dx + dy * dy - reach * reach;
  if (c <= 0) return true;
  const a = vx * vx + vy * vy - drift * drift;
  const b = dx * vx + dy * vy - reach * drift;
  if (a <= 0) return drift > 0;
  return b < 0 && b * b >= a * c;
}
