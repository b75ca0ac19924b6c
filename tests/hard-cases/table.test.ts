import { describe, expect, it } from 'vitest';
import {
  type AccuracyName,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  type Run,
  STATE_SIZE,
  simulate,
} from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';
import { accuracyNames } from '../engine/accuracies.ts';
import { CASE_SECONDS, type HardCase, hardCases } from './cases.ts';
import { effectCases } from './effect-cases.ts';

/** The error of places (px) and times (s) that each accuracy promises at sensitivity 1; `arcade` moves by frames. */
const PROMISES: Record<Exclude<AccuracyName, 'arcade'>, { px: number; s: number }> = {
  precise: { px: 1e-9, s: 1e-9 },
  standard: { px: 1e-3, s: 1e-5 },
  fast: { px: 0.5, s: 1e-3 },
};
const continuous = Object.keys(PROMISES) as (keyof typeof PROMISES)[];
/** The relative change of energy and angular momentum over a run, for the bounds above. */
const DRIFT = { precise: 2e-12, standard: 1e-5, fast: 1e-2 };

const cases = hardCases();
const all: readonly Omit<HardCase, 'truth'>[] = [...cases, ...effectCases()];
const seconds = (c: Omit<HardCase, 'truth'>) => c.maxTime ?? CASE_SECONDS;
const play = (c: Omit<HardCase, 'truth'>, accuracy: AccuracyName): Run =>
  simulate(compile(c.level, accuracy), c.holds, { maxTime: seconds(c) });

/** All events except presses, releases and the end, in words. */
const happenings = (run: Run) =>
  run.events.flatMap((e) => {
    if ('aliens' in e) return [{ what: `${e.type} ${e.aliens.join(' ')}`, time: e.time }];
    return 'index' in e ? [{ what: `${e.type} ${e.index}`, time: e.time }] : [];
  });

function invariants(level: HardCase['level'], asteroid: number, [x, y, vx, vy]: Float64Array): [number, number] {
  const { range, asteroids } = level;
  const [dx, dy] = [x - asteroids[asteroid].x, y - asteroids[asteroid].y];
  const d = Math.hypot(dx, dy);
  return [(vx * vx + vy * vy) / 2 + DEFAULT_RULES.pull * (d - (d * d) / (2 * range)), dx * vy - dy * vx];
}

it('every case has a unique name and says why it is hard', () => {
  expect(new Set(all.map((c) => c.name)).size).toBe(all.length);
  expect(all.filter((c) => c.why === '')).toEqual([]);
});

describe.each(continuous)('hard cases against their truth: %s', (accuracy) => {
  it.each(cases)('$name: $why', (c) => {
    const { truth, sensitivity = 1 } = c;
    const { px, s } = PROMISES[accuracy];
    const run = play(c, accuracy);
    const wrong: string[] = [];
    const near = (what: string, is: number, want: number, within: number) => {
      if (!(Math.abs(is - want) <= within)) wrong.push(`${what} ${is}, not ${want}: off by ${is - want}, allowed ${within}`);
    };

    expect([run.outcome, run.with]).toEqual([truth.outcome, truth.with ?? null]);
    if (truth.time !== undefined) near('time', run.time, truth.time, s * sensitivity);
    if (truth.events !== undefined) {
      const found = happenings(run);
      expect(found.map((e) => e.what)).toEqual(truth.events.map((e) => e.what));
      for (const [i, { what, time }] of truth.events.entries()) {
        if (time !== undefined) near(`time of ${what}`, found[i].time, time, s * sensitivity);
      }
    }
    const state = new Float64Array(STATE_SIZE);
    for (const { time, x, y } of truth.places ?? []) {
      run.trajectory.at(time, state);
      near(`x at ${time} s`, state[0], x, px * sensitivity);
      near(`y at ${time} s`, state[1], y, px * sensitivity);
    }
    if (truth.conserved !== undefined) {
      const { asteroid, from } = truth.conserved;
      run.trajectory.at(from, state);
      const [energy, momentum] = invariants(c.level, asteroid, state);
      run.trajectory.at(run.time, state);
      const [energyThen, momentumThen] = invariants(c.level, asteroid, state);
      near('energy', energyThen / energy, 1, DRIFT[accuracy]);
      // an error of a place, times the speed, is an error of the momentum
      near('angular momentum', momentumThen, momentum, DRIFT[accuracy] * Math.abs(momentum) + 100 * px);
    }
    expect(wrong).toEqual([]);
  });
});

describe.each(accuracyNames)('hard cases keep the rules: %s', (accuracy) => {
  it.each(all)('$name', (c) => {
    const run = play(c, accuracy);
    const { x, y, vx, vy, cos, sin } = run.final;
    expect([x, y, vx, vy, cos, sin, run.time].every(Number.isFinite)).toBe(true);
    expect(Math.abs(cos * cos + sin * sin - 1)).toBeLessThan(1e-12);
    const times = run.events.map((e) => e.time);
    expect(times).toEqual([...times].sort((a, b) => a - b));

    // without recording, at once and tick by tick: the same bits
    const scene = compile(c.level, accuracy);
    const state = new Float64Array(STATE_SIZE);
    const whole = createSimulation(scene);
    playScript(whole, joinHolds(c.holds), 60 * seconds(c));
    whole.readState(state);
    expect([...state]).toEqual([x, y, vx, vy, cos, sin]);
    const byTick = createSimulation(scene);
    for (let tick = 0; tick < 60 * seconds(c) && byTick.ending === null; tick++) {
      byTick.advance(
        1,
        c.holds.some(([press, release]) => press <= tick && tick < release),
      );
    }
    byTick.readState(state);
    expect([...state]).toEqual([x, y, vx, vy, cos, sin]);
    expect(byTick.ending).toEqual(whole.ending);
  });
});
