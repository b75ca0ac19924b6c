import { describe, expect, it } from 'vitest';
import { type AccuracyName, accuracyOf, compile, createSimulation, type Run, STATE_SIZE, simulate } from '../../engine/index.ts';
import { largestDistance, pathOf } from '../../engine/work-precision/index.ts';
import { apart, gauss, type Method, type Played, play, taylor, toNumber } from '../../engine/work-precision/reference/index.ts';
import { itQuick, someOf } from '../depth.ts';
import { type EffectCase, effectCases } from './effect-cases.ts';

/** What `precise` promises, px and s, times the sensitivity of the case. */
const PROMISE = 1e-9;
/** A change of the start from which the sensitivity is measured, px and px/s. */
const NUDGE = 1e-10;
/** From this error on somebody who watches sees that something is wrong, px. */
const VISIBLE = 1;
/** How engines of games are usually made: semi-implicit Euler, and contacts are tested once a frame. */
const NAIVE = accuracyOf({ integrator: 'euler', rate: 60, tolerance: null, contact: 'frame' });

const cases = effectCases();
const ticks = ({ maxTime }: EffectCase) => Math.round(60 * maxTime);
const from = (c: EffectCase, method: Method, nudge: readonly [number, number, number, number] = [0, 0, 0, 0]): Played =>
  play(c.level, c.holds, { method, maxTicks: ticks(c), every: 1, nudge, mostWork: 20_000_000 });

const truths = new Map<string, Played>();
const truthOf = (c: EffectCase): Played => {
  const known = truths.get(c.name) ?? from(c, taylor);
  truths.set(c.name, known);
  return known;
};

const simulated = ({ level, holds, maxTime }: EffectCase, accuracy: AccuracyName): Run =>
  simulate(compile(level, accuracy), holds, { maxTime });

/** What happens in a run, in the words of the references, which do not tell what a jump leaves and enters. */
function happenings({ events }: Run): string[] {
  const jumps = new Set(events.flatMap((e) => (e.type === 'effect' && e.what === 'jump' ? [e.time] : [])));
  return events.flatMap((e) => {
    if (e.type === 'effect' && e.what === 'jump') return [`jump ${e.index}`];
    if (e.type === 'effect' && e.effect === 'winds') return jumps.has(e.time) ? [] : [`wind ${e.index}`];
    if (e.type === 'enter' || e.type === 'leave') return jumps.has(e.time) ? [] : [`field ${e.index}`];
    if (e.type === 'wake' || e.type === 'sleep') return [`sight ${e.index}`];
    if (e.type === 'explosion') return [`explosion ${e.aliens.join(' ')}`];
    return e.type === 'mineral' ? [`mineral ${e.index}`] : [];
  });
}

/** The same of a reference, which counts mouths and not wormholes. */
const told = ({ story }: Played): string[] =>
  story
    .filter((what) => /^(wind|jump|field|sight|explosion|mineral) /.test(what))
    .map((what) => what.replace(/^jump (\d+)$/, (_, mouth) => `jump ${Math.floor(mouth / 2)}`));

itQuick.each(cases)('precise plays as the reference says, to 1e-9 px and 1e-9 s: $name, $why', (c) => {
  const truth = truthOf(c);
  const run = simulated(c, 'precise');
  expect([run.outcome, run.with]).toEqual([truth.outcome, truth.with]);
  expect(happenings(run)).toEqual(told(truth));
  const wrong: string[] = [];
  const near = (what: string, is: number, want: number) => {
    if (!(Math.abs(is - want) <= PROMISE * c.sensitivity)) wrong.push(`${what} ${is}, not ${want}: off by ${is - want}`);
  };
  near('time', run.time, toNumber(truth.end.time));
  expect(run.minerals.map(({ index }) => index)).toEqual(truth.minerals.map(({ index }) => index));
  for (const [i, { time }] of truth.minerals.entries()) near(`time of mineral ${i}`, run.minerals[i].time, toNumber(time));
  const state = new Float64Array(STATE_SIZE);
  for (const [tick, { at, time }] of truth.samples.entries()) {
    run.trajectory.at(toNumber(time), state);
    near(`x at tick ${tick}`, state[0], toNumber(at.x));
    near(`y at tick ${tick}`, state[1], toNumber(at.y));
  }
  expect(wrong).toEqual([]);
});

itQuick.each(cases)('standard ends as the reference does, fast as it is known to: $name', (c) => {
  const { outcome, with: touched } = truthOf(c);
  const standard = simulated(c, 'standard');
  expect([standard.outcome, standard.with]).toEqual([outcome, touched]);
  expect(simulated(c, 'fast').outcome).toBe(c.fast ?? outcome);
});

itQuick.each(cases)('a naive engine is visibly wrong: $name', (c) => {
  const { samples, outcome } = truthOf(c);
  const path = pathOf(createSimulation(compile(c.level, NAIVE)), c.holds, ticks(c));
  const [x, y] = (['x', 'y'] as const).map((axis) => Float64Array.from(samples, ({ at }) => toNumber(at[axis])));
  const error = largestDistance(path, { count: x.length, x, y, ending: null });
  if ((path.ending?.outcome ?? 'timeout') === outcome) expect(error).toBeGreaterThan(VISIBLE);
});

describe('the reference', () => {
  it.each(someOf(cases, 12))('is the same by another method, to 22 digits: $name', (c) => {
    const [a, b] = [truthOf(c), from(c, gauss)];
    expect([b.outcome, b.with, b.story]).toEqual([a.outcome, a.with, a.story]);
    expect(apart(a, b)).toBeLessThan(1e-22);
    expect(Math.abs(toNumber(a.end.time) - toNumber(b.end.time))).toBeLessThan(1e-15);
  });

  it.each(someOf(cases, 12))('multiplies a small error as the case says: $name', (c) => {
    const truth = truthOf(c);
    const factors = [0, 1, 2, 3].flatMap((i) => {
      const nudge = [0, 1, 2, 3].map((k) => (k === i ? NUDGE : 0)) as unknown as readonly [number, number, number, number];
      const played = from(c, taylor, nudge);
      // what is decided by exactly 0 is decided otherwise then, which says nothing about this run
      const isSame = played.outcome === truth.outcome && told(played).join() === told(truth).join();
      return isSame
        ? [Math.max(apart(played, truth), Math.abs(toNumber(played.end.time) - toNumber(truth.end.time))) / NUDGE]
        : [];
    });
    const largest = Math.max(...factors);
    expect(largest).toBeLessThanOrEqual(c.sensitivity);
    expect(largest).toBeGreaterThan(c.sensitivity / 10);
  });
});
