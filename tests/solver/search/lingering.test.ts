import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, DEFAULT_MAX_TICKS, simulate } from '../../../engine/index.ts';
import { type Level, type LevelFile, resolveLevel } from '../../../schema/index.ts';
import { createSearch, proveImpossible } from '../../../solver/index.ts';
import { Lingering } from '../../../solver/search/explore/lingering.ts';
import { Reports } from '../../../solver/search/explore/records.ts';
import { type Candidate, createReplay } from '../../../solver/verified-run.ts';
import { real } from '../../real.ts';

interface Parts {
  readonly centre: number;
  readonly range: number;
  readonly radius: number;
  /** How far recoil has to carry the end of the range until she touches the black hole, px. */
  readonly carried: number;
  /** Direction of the line, rad. */
  readonly turn: number;
  readonly behind?: boolean;
}

/** Half her side along the line, and the radius of the black hole, px. */
const TOUCH = 10 + 18;

/** She rests before the only asteroid; the black hole lies on the same line, beyond the end of the range. */
function levelOf({ centre, range, radius, carried, turn, behind = false }: Parts, more: Partial<LevelFile> = {}): Level {
  const on = (along: number) => ({ x: along * Math.cos(turn), y: along * Math.sin(turn) });
  const hole = behind ? centre - range - TOUCH - carried : centre + range + TOUCH + carried;
  return resolveLevel({
    version: 1,
    name: 'carried range',
    astronaut: { x: 0, y: 0 },
    blackHole: { ...on(hole), radius: 18 },
    range,
    recoil: true,
    asteroids: [{ ...on(centre), radius }],
    ...more,
  });
}

/** The runs that lingering finds. */
function found(level: Level, maxTicks = DEFAULT_MAX_TICKS): readonly Candidate[] {
  const scene = compile(level, 'precise');
  const reports = new Reports(createReplay(scene, { minerals: 'any' }, maxTicks));
  const lingering = Lingering.of(scene, maxTicks, reports);
  while (lingering?.step());
  return reports.solutions;
}

const someParts = fc.record({
  centre: real(20, 70),
  range: real(80, 250),
  radius: fc.constantFrom(8, 16, 24),
  carried: real(1, 8),
  turn: real(0, 2 * Math.PI),
  behind: fc.boolean(),
});

describe('lingering at the end of the range', () => {
  it('lets recoil carry the range to a black hole that lies beyond', () => {
    fc.assert(
      fc.property(someParts, (parts) => {
        const level = levelOf(parts);
        expect(proveImpossible({ ...level, recoil: false }, { accuracy: 'precise' })).not.toBeNull();
        const [{ holds }] = found(level);
        expect(simulate(compile(level, 'precise'), holds).outcome).toBe('completed');
        expect(simulate(compile({ ...level, recoil: false }, 'precise'), holds).outcome).not.toBe('completed');
      }),
      { numRuns: 25 },
    );
  });

  it('finds nothing that is proved impossible, and carries an asteroid most of the way that is possible', () => {
    let farthest = 0;
    for (let carried = 4; carried < 60; carried += 4) {
      const level = levelOf({ centre: 30, range: 80, radius: 16, carried, turn: 0 });
      const isFound = found(level).length > 0;
      if (isFound) farthest = carried;
      if (proveImpossible(level, { accuracy: 'precise', maxTime: 60 }) !== null) expect(isFound).toBe(false);
    }
    // If the gun pulled the asteroid the same way all the time, it would move 56 px.
    expect(farthest).toBeGreaterThanOrEqual(36);
  });

  it.each(['arcade', 'precise'] as const)('is part of a search: %s', (accuracy) => {
    const level = levelOf({ centre: 80, range: 100, radius: 16, carried: 16, turn: 0.3 });
    const search = createSearch(compile(level, accuracy), { seed: 1 });
    search.advance(500_000);
    expect(search.solutions).toEqual([]);
    search.advance(50_000);
    const [{ holds }] = search.solutions;
    expect(holds.length).toBeLessThan(30);
    expect(simulate(compile(level, accuracy), holds).outcome).toBe('completed');
  });

  it('gives the same result however the search is split', () => {
    const scene = compile(levelOf({ centre: 80, range: 100, radius: 16, carried: 16, turn: 0.3 }), 'precise');
    const whole = createSearch(scene);
    whole.advance(530_000);
    const split = createSearch(scene);
    for (const ticks of [499_000, 1, 3000, 700, 20_000, 7299]) split.advance(ticks);
    expect(split.solutions).toEqual(whole.solutions);
    expect(split.effort).toEqual(whole.effort);
    expect(whole.solutions.length).toBeGreaterThan(0);
  });

  it('is not tried where it leads nowhere', () => {
    const parts = { centre: 80, range: 100, radius: 16, carried: 10, turn: 0 };
    const isTried = (level: Level): boolean => {
      const scene = compile(level, 'precise');
      return Lingering.of(scene, DEFAULT_MAX_TICKS, new Reports(createReplay(scene, { minerals: 'any' }))) !== null;
    };
    expect(isTried(levelOf(parts))).toBe(true);
    expect(isTried(levelOf(parts, { recoil: false }))).toBe(false);
    expect(isTried(levelOf(parts, { astronaut: { x: 0, y: 0, vx: 0, vy: 1 } }))).toBe(false);
    expect(isTried(levelOf(parts, { asteroids: [] }))).toBe(false);
    expect(isTried(levelOf(parts, { astronaut: { x: 80, y: 0 } }))).toBe(false);
    expect(isTried(levelOf(parts, { blackHole: { x: 200, y: 60, radius: 18 } }))).toBe(false);
    expect(isTried(levelOf({ ...parts, carried: 80 }))).toBe(false);
  });

  it('goes on to the next play where she starts in a hazard', () => {
    const level = levelOf({ centre: 80, range: 100, radius: 16, carried: 10, turn: 0 }, { novae: [{ x: 0, y: 0, radius: 16 }] });
    expect(found(level)).toEqual([]);
  });
});
