import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { repairedFile } from '../../check/index.ts';
import { ACCURACIES, compile, simulate } from '../../engine/index.ts';
import { formatLevel, type Level, type LevelFile, readLevel, resolveLevel } from '../../schema/index.ts';
import {
  applyChange,
  type Change,
  changeEdits,
  changeSize,
  createRepair,
  type Proposal,
  proveImpossible,
  type RepairOptions,
} from '../../solver/index.ts';
import { isDeep } from '../depth.ts';
import { pack } from '../levels/shipped-pack.ts';
import { real } from '../real.ts';
import { LEVELS } from './impossible-levels.ts';

const { precise } = ACCURACIES;

function repaired(level: Level, options: RepairOptions = {}, ticks = 2_500_000) {
  const proof = options.proof ?? proveImpossible(level, { accuracy: 'precise' });
  const repair = createRepair(level, precise, { proof, ...options });
  while (!repair.finished && repair.effort.ticks < ticks) repair.advance(Math.min(100_000, ticks - repair.effort.ticks));
  return repair;
}

const isCompletable = (level: Level): boolean =>
  level.runs.some(({ holds }) => simulate(compile(level), holds, { record: false }).outcome === 'completed');

/** Reads the file of a proposal again as it would be written, and plays its run there. */
function replayed(file: LevelFile, proposal: Proposal) {
  const read = readLevel(formatLevel(repairedFile(file, proposal, 'new run')));
  if (!read.ok) throw new Error(read.problems.map(({ message }) => message).join('; '));
  return { level: read.level, run: simulate(compile(read.level), proposal.run.holds) };
}

/** One slip of a designer: the file after it, and the size of the change that takes it back. */
interface Slip {
  readonly file: LevelFile;
  readonly size: number;
}

const shift = real(-70, 70);
const arbitrarySlip = fc
  .record({ entry: fc.constantFrom(...pack), dx: shift, dy: shift, part: real(0, 1), kind: fc.nat(4), n: fc.nat(50) })
  .map(({ entry: { file, level }, dx, dy, part, kind, n }): Slip => {
    switch (kind) {
      case 0: {
        const vx = level.astronaut.vx + dx / 2;
        const vy = level.astronaut.vy + dy / 2;
        return { file: { ...file, astronaut: { ...file.astronaut, vx, vy } }, size: Math.hypot(dx, dy) / 2 };
      }
      case 1: {
        const range = level.range * (1 - 0.4 * part);
        return { file: { ...file, range }, size: level.range - range };
      }
      case 2: {
        const radius = level.blackHole.radius * (1 - 0.7 * part);
        return { file: { ...file, blackHole: { ...file.blackHole, radius } }, size: level.blackHole.radius - radius };
      }
      case 3: {
        const run = simulate(compile(level), level.runs[0].holds);
        const at = new Float64Array(6);
        run.trajectory.at(run.time * (0.2 + 0.7 * part), at);
        return { file: { ...file, novae: [...(file.novae ?? []), { x: at[0], y: at[1], radius: 16 }] }, size: 32 };
      }
      default: {
        const lists = ['asteroids', 'novae', 'repulsors', 'aliens'] as const;
        const objects = lists.flatMap((list) => (file[list] ?? []).map((_, i) => [list, i] as const));
        const [list, index] = objects[n % objects.length];
        const moved = { ...file, [list]: file[list]?.map((o, i) => (i === index ? { ...o, x: o.x + dx, y: o.y + dy } : o)) };
        return { file: moved, size: Math.hypot(dx, dy) };
      }
    }
  })
  .filter(({ file }) => !isCompletable(resolveLevel(file)));

describe('a shipped level that one slip has broken', () => {
  it('is completable after every proposal, and the smallest is hardly larger than what takes the slip back', () => {
    fc.assert(
      fc.property(arbitrarySlip, ({ file, size }) => {
        const level = resolveLevel(file);
        const { proposals, completing } = repaired(level);
        expect(completing).toBeNull();
        expect(proposals.length).toBeGreaterThan(0);
        for (const [i, proposal] of proposals.entries()) {
          const { level: after, run } = replayed(file, proposal);
          expect(run.outcome).toBe('completed');
          expect(run.time).toBe(proposal.run.time);
          expect(isCompletable(after)).toBe(true);
          expect(proposal.size).toBeGreaterThanOrEqual(i === 0 ? 0 : proposals[i - 1].size);
          if (proposal.change !== null) expect(proposal.size).toBe(changeSize(proposal.change));
        }
        // the search is no exhaustive one: it may miss the way back, and find another change that is a little larger
        const least = Math.min(...proposals.filter(({ change }) => change !== null).map((p) => p.size));
        expect(least).toBeLessThanOrEqual(3 * size + 1);
      }),
      { numRuns: 5 },
    );
  });
});

/** She falls along the x axis with her box upright, so the black hole is 60 - 16 - 18 = 26 px from her way. */
const aside = resolveLevel({
  version: 1,
  name: 'Aside',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 170, y: 60 },
  asteroids: [{ x: 100, y: 0, radius: 16 }],
  runs: [{ name: 'hold', holds: [[0, 600]] }],
});

describe('the smallest change that is found', () => {
  const { proposals } = repaired(aside, { count: 12 });
  const of = (what: Change['what'], kind: string) =>
    proposals.find(({ change }) => change?.what === what && (!('object' in change) || change.object.kind === kind));

  it('is the least that there is, where that is known', () => {
    for (const found of [of('move', 'blackHole'), of('resize', 'blackHole')]) {
      expect(found?.size).toBeGreaterThan(26);
      expect(found?.size).toBeLessThan(26.2);
    }
  });

  it('comes first, and no two are of the same kind', () => {
    const sizes = proposals.map(({ size }) => size);
    expect(sizes).toEqual([...sizes].sort((a, b) => a - b));
    const kinds = proposals.map(({ change, origin }) =>
      change === null ? origin.from : `${change.what} ${'object' in change ? change.object.kind : ''}`,
    );
    expect(new Set(kinds).size).toBe(kinds.length);
  });

  it('is no end at the start: a run that is over at once completes nothing', () => {
    for (const { run } of proposals) expect(run.time).toBeGreaterThan(0);
  });
});

describe('an impossible level', () => {
  // to mend the others takes seconds each
  const names = isDeep ? Object.keys(LEVELS) : ['enclosed', 'out-of-range', 'starts-in-hazard'];

  it.each(names)('%s becomes completable, although its proof was right', (name) => {
    const level = LEVELS[name];
    const proof = proveImpossible(level, { accuracy: 'precise' });
    expect(proof).not.toBeNull();
    const { proposals } = repaired(level, { proof }, 1_700_000);
    expect(proposals.length).toBeGreaterThan(0);
    for (const { change, run } of proposals) {
      expect(change).not.toBeNull();
      if (change === null) continue;
      const after = applyChange(level, change);
      expect(simulate(compile(after), run.holds).outcome).toBe('completed');
      expect(proveImpossible(after, { accuracy: 'precise' })).toBeNull();
    }
  });
});

describe('the work', () => {
  it('gives the same however it is split into calls', () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 1, max: 60_000 }), { maxLength: 12 }), fc.nat(3), (calls, seed) => {
        const total = 150_000;
        const whole = createRepair(aside, precise, { seed });
        whole.advance(total);
        const split = createRepair(aside, precise, { seed });
        let left = total;
        for (const ticks of calls) {
          split.advance(Math.min(ticks, left));
          left -= Math.min(ticks, left);
        }
        split.advance(left);
        expect([split.effort, split.proposals, split.finished]).toEqual([whole.effort, whole.proposals, whole.finished]);
      }),
      { numRuns: 6 },
    );
  });

  it('ends at once where a run completes the level', () => {
    const [{ level }] = pack;
    const repair = repaired(level);
    expect(repair).toMatchObject({ completing: 0, proposals: [], finished: true });
  });
});

describe('a change', () => {
  const [{ file }] = pack;

  it('makes the same level of a level and of its file, and keeps everything else', () => {
    const { x, y } = file.blackHole;
    const change: Change = { what: 'move', object: { kind: 'blackHole', index: 0 }, from: { x, y }, to: { x: x + 3, y } };
    const after = applyChange({ ...file, 'x-mine': [1] }, change);
    expect(after).toEqual({ ...file, 'x-mine': [1], blackHole: { ...file.blackHole, x: x + 3 } });
    expect(resolveLevel(applyChange(file, change))).toEqual(applyChange(resolveLevel(file), change));
    expect(changeEdits(change)).toEqual([{ path: ['blackHole', 'x'], value: x + 3 }]);
    expect(changeSize(change)).toBe(3);
  });

  it('removes one object and no other', () => {
    const level = { ...aside, novae: [1, 2, 3].map((x) => ({ id: null, x, y: 0, radius: x })) };
    const change: Change = { what: 'drop', object: { kind: 'nova', index: 1 }, radius: 2 };
    expect(applyChange(level, change)).toEqual({ ...level, novae: [level.novae[0], level.novae[2]] });
    expect(changeSize(change)).toBe(4);
  });
});
