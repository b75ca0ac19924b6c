import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { firstDifferentEvent, partingsOf } from '../../check/runs/compare-runs.ts';
import {
  APART,
  AWAY,
  type ComparableRun,
  compareRuns,
  decidedInWords,
  pairInWords,
  partingsInWords,
  TOGETHER,
  waysApart,
} from '../../check/runs/index.ts';
import { compile, createSimulation, playScript, STATE_SIZE, simulate } from '../../engine/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';

const RUN: ComparableRun = { holds: [[60, 150]], outcome: 'completed', time: 5, minerals: 1, clearance: 10, slack: 4 };

const holds: fc.Arbitrary<Hold[]> = fc
  .array(fc.tuple(fc.integer({ min: 1, max: 60 }), fc.integer({ min: 1, max: 60 })), { maxLength: 5 })
  .map((gaps) => {
    let at = 0;
    return gaps.map(([wait, length]): Hold => {
      const press = at + wait;
      at = press + length;
      return [press, at];
    });
  });

describe('the difference of two runs', () => {
  it('says which does better: more of minerals, clearance and slack, less time where both complete', () => {
    const other: ComparableRun = { ...RUN, time: 6, minerals: 2, clearance: null, slack: 5 };
    const { outcome, time, minerals, clearance, slack } = compareRuns(RUN, other);
    expect([outcome, time, minerals, clearance, slack].map(({ better }) => better)).toEqual([
      null,
      'one',
      'other',
      null,
      'other',
    ]);
    const failed = compareRuns(RUN, { ...RUN, outcome: 'lost', time: 1 });
    expect([failed.outcome.better, failed.time.better]).toEqual(['one', null]);
    expect(compareRuns({ ...RUN, outcome: 'lost' }, { ...RUN, outcome: 'collided' }).outcome.better).toBe(null);
  });

  it('is the mirror image from the other side, has every hold once, and the shifts are those of the holds', () => {
    fc.assert(
      fc.property(holds, holds, (a, b) => {
        const there = compareRuns({ ...RUN, holds: a }, { ...RUN, holds: b, time: 4 });
        const back = compareRuns({ ...RUN, holds: b, time: 4 }, { ...RUN, holds: a });
        expect(back.from).toBe(there.from);
        expect(back.time.better).toBe('one');
        expect(there.time.better).toBe('other');
        expect(there.holds.flatMap(({ one }) => (one === null ? [] : [one]))).toEqual(a);
        expect(there.holds.flatMap(({ other }) => (other === null ? [] : [other]))).toEqual(b);
        for (const { one, other, press, release } of there.holds) {
          if (one === null || other === null) expect([press, release]).toEqual([null, null]);
          else expect([one[0] + (press ?? 0), one[1] + (release ?? 0)]).toEqual(other);
        }
      }),
    );
  });

  it('says pairs of holds in words', () => {
    const names = ['fast', 'slow'] as const;
    const words = (a: Hold[], b: Hold[]) =>
      compareRuns({ ...RUN, holds: a }, { ...RUN, holds: b }).holds.map((pair) => pairInWords(pair, names));
    expect(words([[60, 150]], [[60, 150]])).toEqual(['the same']);
    expect(words([[60, 150]], [[63, 153]])).toEqual(['3 ticks later as a whole']);
    expect(words([[60, 150]], [[59, 150]])).toEqual(['press 1 tick earlier, release at the same tick']);
    expect(
      words(
        [[60, 150]],
        [
          [60, 150],
          [400, 410],
        ],
      ),
    ).toEqual(['the same', 'only in slow']);
    expect(words([[60, 150]], [])).toEqual(['only in fast']);
  });
});

describe('where two runs part and meet', () => {
  it('is found from the distances: it parts once, meets only after it was away, at the nearest tick', () => {
    const distance = fc.oneof(fc.constantFrom(0, 0.5, 1, 1.5, 7, 8, 9, 16, 17, 30), fc.double({ min: 0, max: 40, noNaN: true }));
    fc.assert(
      fc.property(fc.array(distance, { maxLength: 40 }), (list) => {
        const { parts, meets } = partingsOf(list);
        const first = list.findIndex((one) => one > APART);
        expect(parts).toBe(first < 0 ? null : first);
        let before = 0;
        for (const { tick, distance: at } of meets) {
          expect(list[tick]).toBe(at);
          expect(at).toBeLessThanOrEqual(TOGETHER);
          // it was away since the last meeting
          expect(list.slice(before, tick).some((one) => one > AWAY)).toBe(true);
          before = tick;
        }
        // nothing is left out: between two times away, whatever comes near enough has a meeting at its lowest point
        const away = list.flatMap((one, tick) => (one > AWAY ? [tick] : []));
        const stretches = away.map((tick, i) => list.slice(tick + 1, away[i + 1] ?? list.length));
        expect(meets.map(({ distance: at }) => at)).toEqual(
          stretches.map((stretch) => Math.min(...stretch)).filter((least) => least <= TOGETHER),
        );
      }),
      { numRuns: 1000 },
    );
  });

  it('is true of runs of a level: before the scripts differ, they are at the same place to the last bit', () => {
    const file: LevelFile = {
      version: 1,
      name: 'two ways',
      astronaut: { x: 100, y: 300 },
      blackHole: { x: 380, y: 300 },
      asteroids: [{ x: 240, y: 260, radius: 24 }],
    };
    const scene = compile(resolveLevel(file), 'precise');
    const pointsOf = (script: readonly Hold[]): number[] => {
      const simulation = createSimulation(scene);
      const state = new Float64Array(STATE_SIZE);
      const points: number[] = [];
      for (let tick = 0; tick < 400; tick++) {
        simulation.readState(state);
        points.push(state[0], state[1]);
        if (simulation.ending !== null) break;
        playScript(simulation, script, tick + 1);
      }
      return points;
    };
    fc.assert(
      fc.property(holds, holds, (a, b) => {
        const { distances, partings } = waysApart({ points: pointsOf(a), events: [] }, { points: pointsOf(b), events: [] });
        const { from } = compareRuns({ ...RUN, holds: a }, { ...RUN, holds: b });
        const until = Math.min(distances.length, (from ?? Number.POSITIVE_INFINITY) + 1);
        expect([...distances.slice(0, until)].every((one) => one === 0)).toBe(true);
        const { parts } = partings;
        if (parts !== null) expect(parts).toBeGreaterThan(from ?? Number.POSITIVE_INFINITY);
      }),
      { numRuns: 40 },
    );
    expect(simulate(scene, []).outcome).not.toBe('completed');
  });

  it('is said in words', () => {
    const near = partingsOf([0, 2, 20, 3, 20, 5]);
    expect(partingsInWords({ from: 0 }, near)).toBe(
      'Their holds differ from tick 0 (0.00 s) on. They are more than 1 px apart from tick 1 (0.02 s) on, and come near each other again: 3.0 px at tick 3 (0.05 s), 5.0 px at tick 5 (0.08 s).',
    );
    expect(partingsInWords({ from: null }, partingsOf([0, 0]))).toBe('Both press and release at the same ticks.');
    expect(partingsInWords({ from: null }, near)).toMatch(
      /^Both press and release at the same ticks\. They are more than 1 px apart from tick 1 \(0\.02 s\) on, and come near/,
    );
    expect(partingsInWords({ from: 60 }, partingsOf([0, 0]))).toContain('never more than 1 px apart');
    expect(partingsInWords({ from: 60 }, null)).toBe('Their holds differ from tick 60 (1.00 s) on.');
  });
});

describe('what decides between two runs of the same holds', () => {
  const target = (time: number, index: number) => ({ time, type: 'target', index }) as const;
  const mineral = (time: number, index: number) => ({ time, type: 'mineral', index }) as const;

  it('is the first contact or switch that only one of them has, whenever it is', () => {
    const press = { time: 0, type: 'press' } as const;
    const one = [press, target(0, 0), mineral(1, 2), target(2, 1)];
    expect(firstDifferentEvent(one, [target(0, 0), mineral(1.01, 2), target(2.2, 1)])).toBeNull();
    expect(firstDifferentEvent(one, [target(0, 0), target(2, 1)])).toEqual({ one: mineral(1, 2), other: target(2, 1) });
    expect(firstDifferentEvent(one, [target(0, 0), mineral(1, 2)])).toEqual({ one: target(2, 1), other: undefined });
    // of both ways at once, whose last points are no ticks
    const points = [0, 0, 1, 0, 5, 5];
    const apart = waysApart({ points, events: one }, { points: [0, 0, 4, 4, 9, 9, 9, 9], events: one.slice(0, 3) });
    expect([...apart.distances]).toEqual([0, 5]);
    expect([apart.partings.parts, apart.decided]).toEqual([1, { one: target(2, 1), other: undefined }]);
    expect(decidedInWords({ one: target(2, 1), other: undefined }, 'precise')).toBe(
      'first otherwise: nothing more, at precise target: asteroid 2 at 2.00 s',
    );
  });
});
