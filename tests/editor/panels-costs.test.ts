import { describe, expect, it } from 'vitest';
import { timeInTurns } from '../../editor/core/figures/index.ts';
import { createProver } from '../../editor/core/proof/index.ts';
import { drawSettings } from '../../editor/features/accuracy/measured-settings.ts';
import { otherEndOf } from '../../editor/features/accuracy/OtherAccuracy.tsx';
import { costOf, savingOf, withoutEffect } from '../../editor/features/effects/survey.ts';
import { compile, DEFAULT_TERMS, EFFECTS, simulate, termsOf } from '../../engine/index.ts';
import { METHODS } from '../../engine/work-precision/index.ts';
import { type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';

const FILE: LevelFile = {
  version: 1,
  name: 'all of it',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 600, y: 0 },
  recoil: true,
  asteroids: [
    { x: 200, y: 30, radius: 16 },
    { x: 420, y: -60, radius: 16, hot: true },
  ],
  novae: [{ x: 100, y: 400, radius: 16 }],
  repulsors: [{ x: 210, y: -80, radius: 48 }],
  aliens: [
    { x: -100, y: 300 },
    { x: -160, y: 340 },
  ],
  minerals: [{ x: 60, y: 9 }],
  winds: [{ x: -200, y: -200, radius: 40 }],
  wormholes: [{ x: -300, y: -100, toX: -300, toY: 100, radius: 20 }],
};
const LEVEL: Level = resolveLevel(FILE);
const HOLDS = [[10, 200]] as const;

describe('what an effect costs', () => {
  it('is measured in a level that does not call for the effect, and is otherwise the same', () => {
    const called = (level: Level) =>
      compile(level)
        .effects.simulated.map(({ name }) => name)
        .sort();
    const left = EFFECTS.map(({ name }) => name).filter((name) => withoutEffect(LEVEL, name) !== null);
    expect(left.sort()).toEqual([
      'alien-chase',
      'hot-asteroids',
      'minerals',
      'novae',
      'recoil',
      'repulsor',
      'winds',
      'wormholes',
    ]);
    for (const name of left) {
      const without = withoutEffect(LEVEL, name) as Level;
      const gone = name === 'alien-chase' ? [name, 'alien-explosion'] : [name];
      expect(called(without)).toEqual(called(LEVEL).filter((other) => !gone.includes(other)));
      expect(withoutEffect(without, name)).toEqual(without);
    }
  });

  it('is the saved work if her path is the same, and unknown if it differs', () => {
    const full = simulate(compile(LEVEL), HOLDS);
    const nova = costOf(LEVEL, DEFAULT_TERMS, HOLDS, full, 'novae');
    expect(nova.kind).toBe('same');
    const without = simulate(compile(withoutEffect(LEVEL, 'novae') as Level), HOLDS);
    if (nova.kind === 'same') expect(nova.saved.guards).toBe(full.work.guards - without.work.guards);
    expect(costOf(LEVEL, DEFAULT_TERMS, HOLDS, full, 'recoil').kind).toBe('other');
    expect(costOf(LEVEL, DEFAULT_TERMS, HOLDS, full, 'gun').kind).toBe('always');
  });

  it('is reported with its uncertainty', () => {
    const slow = (round: number) => (round % 5 === 0 ? 40 : 0);
    const base = Array.from({ length: 24 }, (_, i) => 12 + slow(i));
    const clear = savingOf(
      base,
      Array.from({ length: 24 }, (_, i) => 9 + slow(i + 2)),
    );
    expect(clear).toEqual({ all: 12, saved: 3, low: 3, high: 3 });
    // half of the rounds show a gain, the others a loss
    const noise = savingOf(
      base,
      Array.from({ length: 24 }, (_, i) => (i % 2 === 0 ? 11 : 13)),
    );
    expect(noise.low).toBeLessThan(0);
    expect(noise.high).toBeGreaterThan(0);
  });
});

describe('timing in turns', () => {
  const player = (clock: { time: number }, cost: number) => ({
    code: 'fake',
    play() {
      clock.time += cost;
      return 2;
    },
  });

  it('measures the time of each player per simulated second, independent of the others, also with a coarse clock', () => {
    const clock = { time: 0 };
    const timing = timeInTurns(
      [player(clock, 0.03), player(clock, 0.5), player(clock, 7)],
      () => Math.floor(10 * clock.time) / 10,
    );
    let step = timing.next();
    while (step.done !== true) step = timing.next();
    expect(step.value).toHaveLength(3);
    // ms a play / 2 s a play, in microseconds
    for (const [i, expected] of [15, 250, 3500].entries()) {
      expect(step.value[i].length).toBeGreaterThan(0);
      for (const sample of step.value[i]) expect(Math.abs(sample / expected - 1)).toBeLessThan(0.06);
    }
  });

  it('pauses after every sample, and samples are not much longer than necessary', () => {
    const clock = { time: 0 };
    let last = 0;
    let longest = 0;
    let pauses = 0;
    for (const _ of timeInTurns([player(clock, 0.3)], () => clock.time)) {
      longest = Math.max(longest, clock.time - last);
      last = clock.time;
      pauses++;
    }
    expect(longest).toBeLessThan(2.5);
    expect(pauses).toBe(27);
  });
});

describe('the named settings', () => {
  it('are points in the diagram, in the theme of the page, with a ring around the current one', () => {
    const settings = METHODS.map(({ name }, i) => ({
      name,
      error: 10 ** -(i % 9),
      cost: 1 + i,
      outcome: 'completed' as const,
      with: null,
      time: 1,
      sameVerdict: i !== 3,
    }));
    const draw = (current: 'fast' | 'precise', ground: 'dark' | 'light') =>
      drawSettings({ level: 'Level <1>', run: 'solution', settings, current }, ground);
    const svg = draw('fast', 'dark');
    expect(svg.match(/<circle[^>]*r="9"/g)).toHaveLength(1);
    expect(svg).not.toBe(draw('precise', 'dark'));
    expect(svg).not.toBe(draw('fast', 'light'));
    // no style element, which would affect the whole page
    expect(svg).not.toContain('<style');
    expect(svg).not.toContain('<1>');
  });
});

describe('what another accuracy would change', () => {
  const proof = (accuracy: 'arcade' | 'precise', msPerLook = 0, patience = Number.POSITIVE_INFINITY) => {
    let clock = 0;
    const now = () => {
      clock += msPerLook;
      return clock;
    };
    return createProver(now).prove({
      file: { ...FILE, runs: [{ name: 'swing', holds: [[10, 200]] }] },
      run: null,
      terms: termsOf(accuracy),
      patience,
    });
  };

  it('is the distance of the two paths, from either side', () => {
    const fromArcade = otherEndOf(proof('arcade'));
    const fromPrecise = otherEndOf(proof('precise'));
    expect(fromArcade).toEqual({ ...fromPrecise, name: 'precise' });
    expect(fromPrecise?.name).toBe('arcade');
    expect(fromArcade?.distance).toBeGreaterThan(0);
  });

  it('is compared however slow the machine was at that moment', () => {
    const slow = proof('arcade', 10_000);
    expect(slow.ms).toBeGreaterThan(1000);
    expect(otherEndOf(slow)).toEqual(otherEndOf(proof('arcade')));
    const cut = proof('arcade', 10_000, 60);
    expect(cut.limit).not.toBeNull();
    expect(otherEndOf(cut)).toEqual(otherEndOf(proof('arcade')));
  });

  it('is left out if it takes too much work, or if nothing is simulated', () => {
    expect(otherEndOf(proof('arcade'), 10)).toBeNull();
    expect(otherEndOf(proof('arcade', 0, 0))).toBeNull();
  });
});
