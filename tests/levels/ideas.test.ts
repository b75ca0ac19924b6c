import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, createSimulation, type RunEvent, simulate } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { proveImpossible } from '../../solver/index.ts';
import { accuracyNames, holdsOf, play, shipped } from './shipped-pack.ts';

// Each level has an idea. These tests check that its solution uses it, so that a changed level can't lose its point unnoticed.

type EventOf<T extends RunEvent['type']> = Extract<RunEvent, { type: T }>;

function eventsOf<T extends RunEvent['type']>(level: Level, type: T, accuracy: AccuracyName): EventOf<T>[] {
  return play(level, 'solution', accuracy).events.filter((event): event is EventOf<T> => event.type === type);
}

describe.each(accuracyNames)('under %s', (accuracy) => {
  it.each(['let-it-sleep', 'blind-date', 'watchdog', 'grand-tour'])('%s: an alien wakes', (slug) => {
    expect(eventsOf(shipped(slug).level, 'wake', accuracy)).not.toEqual([]);
  });

  it.each(['blind-date', 'grand-tour'])('%s: two aliens are lured into each other', (slug) => {
    expect(eventsOf(shipped(slug).level, 'explosion', accuracy)).toHaveLength(1);
  });

  it.each(['soft-landing', 'bumper-alley', 'run-up', 'watchdog', 'grand-tour'])('%s: a repulsor is entered', (slug) => {
    expect(eventsOf(shipped(slug).level, 'enter', accuracy)).not.toEqual([]);
  });

  it('soft-landing: the repulsor stops her and sends her back', () => {
    const { level } = shipped('soft-landing');
    const run = play(level, 'solution', accuracy);
    const entered = run.events.find((event) => event.type === 'enter');
    const state = new Float64Array(6);
    run.trajectory.at(entered?.time ?? 0, state);
    expect(state[2]).toBeGreaterThan(0);
    expect(run.final.vx).toBeLessThan(0);
  });

  it.each(['hot-rock', 'firewalk', 'grand-tour'])('%s: a hot asteroid is the target', (slug) => {
    const { level } = shipped(slug);
    const hot = eventsOf(level, 'target', accuracy).filter((event) => level.asteroids[event.index].hot);
    expect(hot).not.toEqual([]);
  });

  it.each(['three-swings', 'firewalk', 'grand-tour'])('%s: three asteroids pull', (slug) => {
    const targets = new Set(eventsOf(shipped(slug).level, 'target', accuracy).map((event) => event.index));
    expect(targets.size).toBeGreaterThanOrEqual(3);
  });

  it.each([
    ['tailwind', 'winds', 'enter'],
    ['headwind', 'winds', 'enter'],
    ['short-cut', 'wormholes', 'jump'],
    ['vault', 'wormholes', 'jump'],
  ] as const)('%s: the solution needs its %s', (slug, things, what) => {
    const { level } = shipped(slug);
    expect(level[things]).not.toEqual([]);
    const acted = eventsOf(level, 'effect', accuracy).filter((event) => event.effect === things && event.what === what);
    expect(new Set(acted.map((event) => event.index)).size).toBe(level[things].length);
    for (const run of level.runs) {
      expect(simulate(compile({ ...level, [things]: [] }, accuracy), run.holds).outcome).not.toBe('completed');
    }
  });

  it('headwind: without a second pull she is blown back', () => {
    const { level } = shipped('headwind');
    const [first] = holdsOf(level, 'solution');
    const run = simulate(compile(level, accuracy), [first]);
    expect(run.outcome).toBe('lost');
    expect(run.final.vx).toBeLessThan(0);
  });

  it('pebbles: without recoil the solution misses', () => {
    const { level } = shipped('pebbles');
    expect(level.recoil).toBe(true);
    const rigid = compile({ ...level, recoil: false }, accuracy);
    expect(simulate(rigid, holdsOf(level, 'solution')).outcome).not.toBe('completed');
  });
});

it('first-swing, running-start: she starts with a velocity', () => {
  for (const slug of ['first-swing', 'running-start']) {
    const { vx, vy } = shipped(slug).level.astronaut;
    expect(vx * vx + vy * vy).toBeGreaterThan(0);
  }
});

it('vault: nobody gets in without the wormhole', () => {
  const { level } = shipped('vault');
  expect(proveImpossible({ ...level, wormholes: [] })?.code).toBe('enclosed');
});

it('detour: the quick path collects no mineral', () => {
  expect(play(shipped('detour').level, 'solution', 'precise').minerals).toEqual([]);
});

/** Ticks between tried presses, and between tried releases. */
const GRID = 10;
const LATEST = 1000;

/** The number of single holds [press, release) on the grid that complete the level within 25 s of drifting. */
function singleHoldsThatComplete(level: Level): number {
  const simulation = createSimulation(compile(level, 'arcade'));
  const isOver = (): boolean => simulation.ending !== null;
  let count = 0;
  for (let press = 0; press < LATEST && !isOver(); press += GRID) {
    const atPress = simulation.snapshot();
    for (let release = press + GRID; release <= LATEST && !isOver(); release += GRID) {
      simulation.advance(GRID, true);
      const atRelease = simulation.snapshot();
      simulation.advance(1500 - simulation.tick, false);
      if (simulation.ending?.outcome === 'completed') count++;
      simulation.restore(atRelease);
    }
    simulation.restore(atPress);
    simulation.advance(GRID, false);
  }
  return count;
}

describe('a single hold', () => {
  it.each(['three-swings', 'grand-tour', 'blind-date', 'watchdog'])('%s: does not complete the level', (slug) => {
    expect(singleHoldsThatComplete(shipped(slug).level)).toBe(0);
  });

  // negative control: the count finds single holds that work
  it.each(['first-pull', 'first-swing', 'detour', 'tailwind', 'short-cut'])('%s: completes the level', (slug) => {
    expect(singleHoldsThatComplete(shipped(slug).level)).toBeGreaterThan(0);
  });
});
