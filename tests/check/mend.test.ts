import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createMend, type Mend } from '../../check/index.ts';
import { mendedInWords, takenBack, unitsOf } from '../../check/mend/index.ts';
import { compile, DEFAULT_TERMS, joinHolds, simulate } from '../../engine/index.ts';
import { formatLevel, type LevelFile, readLevel, resolveLevel, withIds } from '../../schema/index.ts';
import { findSlack } from '../../solver/index.ts';
import { arbitraryFile } from '../editor/arbitrary-file.ts';
import '../fast-check.ts';
import { itQuick } from '../depth.ts';
import { shippedFile } from './shipped-file.ts';

const NO_RULES = {};

function outcomeOf(file: LevelFile, name: string) {
  const reading = readLevel(formatLevel(file));
  if (!reading.ok) throw new Error(reading.problems[0].message);
  const run = reading.level.runs.find((one) => one.name === name);
  if (run === undefined) throw new Error(name);
  return simulate(compile(reading.level), run.holds);
}

function finish(mend: Mend): Mend {
  while (!mend.finished) mend.advance(1_000_000);
  return mend;
}

const mendOf = (before: LevelFile, after: LevelFile, run = 'solution'): Mend =>
  createMend({ before, after, terms: DEFAULT_TERMS, run, newRun: 'found' });

/** She falls through an asteroid into the black hole behind it; beside her way is a nova. */
const FALL: LevelFile = {
  version: 1,
  name: 'Fall',
  astronaut: { x: 200, y: 304 },
  blackHole: { x: 704, y: 304 },
  asteroids: [{ id: 'rock', x: 448, y: 304, radius: 16 }],
  novae: [
    { id: 'aa', x: 448, y: 420, radius: 32 },
    { id: 'bb', x: 560, y: 420, radius: 32 },
  ],
  runs: [{ name: 'solution', holds: [[0, 600]] }],
};

const novaeAt = (first: number, second = 420): LevelFile => ({
  ...FALL,
  novae: [
    { id: 'aa', x: 448, y: first, radius: 32 },
    { id: 'bb', x: 560, y: second, radius: 32 },
  ],
});

describe('what mends a change', () => {
  itQuick('takes an object back as little as is enough, in the direction from which it came', () => {
    const after = novaeAt(320);
    const mend = mendOf(FALL, after);
    while (mend.found.length === 0) mend.advance(1000);
    const [first] = mend.found;
    expect(first.how.kind).toBe('back');
    const y = first.file.novae?.[0].y ?? 0;
    expect(first.file).toEqual({ ...after, novae: [{ id: 'aa', x: 448, y, radius: 32 }, after.novae?.[1]] });
    expect(mendedInWords(first, after)).toBe(`Move nova 1 back by ${Math.round((y - 320) * 10) / 10} px.`);
    expect(outcomeOf(first.file, 'solution').outcome).toBe('completed');
    // a px less is not enough
    expect(outcomeOf(novaeAt(y - 1), 'solution').outcome).toBe('collided');
  });

  itQuick('takes one of several changes back where that is enough, and all of them by the same share', () => {
    const after = novaeAt(330, 400);
    const words = finish(mendOf(FALL, after))
      .found.filter(({ how }) => how.kind === 'back')
      .map((one) => mendedInWords(one, after));
    expect(words).toHaveLength(2);
    expect(words[0]).toMatch(/^Move nova 1 back by [\d.]+ px\.$/);
    expect(words[1]).toMatch(/^Move 2 objects back by [\d.]+ to [\d.]+ px\.$/);
  });

  it('takes back what was added, removed, resized, or set', () => {
    const cases: [LevelFile, RegExp][] = [
      [{ ...FALL, novae: [...(FALL.novae ?? []), { id: 'cc', x: 600, y: 304, radius: 16 }] }, /^Remove nova 3 again\.$/],
      [{ ...FALL, asteroids: [] }, /^Put asteroid 1 back\.$/],
      [
        { ...FALL, novae: [{ id: 'aa', x: 448, y: 420, radius: 110 }, (FALL.novae ?? [])[1]] },
        /^Make nova 1 smaller again by [\d.]+ px\.$/,
      ],
      [{ ...FALL, range: 60 }, /^Make the range larger again by [\d.]+ px\.$/],
      [{ ...FALL, astronaut: { x: 200, y: 304, vx: 0, vy: 40 } }, /^Set vy of the start back to [\d.]+, from 40\.$/],
      [{ ...FALL, rules: { pull: 2 } }, /^Set pull back to [\d.]+ px\/s2, from 2\.$/],
      [{ ...FALL, asteroids: [{ id: 'rock', x: 448, y: 304, radius: 16, hot: true }] }, /^Switch hot of hot asteroid 1 back\.$/],
    ];
    for (const [after, words] of cases) {
      expect(outcomeOf(after, 'solution').outcome, String(words)).not.toBe('completed');
      const mend = mendOf(FALL, after);
      while (!mend.finished && mend.found.length === 0) mend.advance(1000);
      expect(mendedInWords(mend.found[0], after)).toMatch(words);
      expect(outcomeOf(mend.found[0].file, 'solution').outcome).toBe('completed');
    }
  });

  itQuick('shifts as few presses and releases as is enough, changes something else, or is another run', () => {
    const before = shippedFile('15-three-swings');
    const [run] = (before.runs ?? []).map(({ name }) => name);
    const [first, second, third] = before.asteroids ?? [];
    const after = { ...before, asteroids: [first, { ...second, x: second.x + 8, y: second.y + 8 }, third] };
    const { found } = finish(mendOf(before, after, run));
    expect(new Set(found.map(({ how }) => how.kind))).toEqual(new Set(['back', 'retime', 'change', 'run']));
    for (const one of found) {
      const played = outcomeOf(one.file, one.run);
      expect(played.outcome).toBe('completed');
      expect(one.time).toBe(played.time);
      const level = resolveLevel(one.file);
      const holds = joinHolds(level.runs.find(({ name }) => name === one.run)?.holds ?? []);
      const slack = findSlack(compile(level), holds, { minerals: 'any' }, 30);
      expect(one.slack).toBe(Math.min(...slack.flatMap(({ earlier, later }) => [earlier, later])));
    }
    const retimed = found.find(({ how }) => how.kind === 'retime');
    expect(retimed && mendedInWords(retimed, after)).toMatch(/^In run "[^"]+": (Press|Release|Move) .*ticks?/);
  });

  it('is the same however the work is split', () => {
    const after = novaeAt(320);
    const whole = mendOf(FALL, after);
    const parts = mendOf(FALL, after);
    whole.advance(300_000);
    for (let i = 0; i < 300; i++) parts.advance(1000);
    expect(parts.found).toEqual(whole.found);
    expect(parts.effort).toEqual(whole.effort);
  });
});

describe('the units of a change', () => {
  it('lead back to the former level, all of them taken back', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryFile, (one, other) => {
        const before = withIds(one);
        const after = withIds({ ...other, name: one.name });
        const back = takenBack(after, unitsOf(before, after, NO_RULES), 1);
        const game = (file: LevelFile) => {
          const { runs: _, name: __, description: ___, allow: ____, ...level } = resolveLevel(file);
          return level;
        };
        const sorted = (level: object) =>
          JSON.stringify(
            Object.entries(level).map(([key, value]) => [
              key,
              Array.isArray(value) ? [...value].sort((a, b) => (a.id < b.id ? -1 : 1)) : value,
            ]),
          );
        expect(sorted(game(back))).toBe(sorted(game(before)));
      }),
      { numRuns: 200 },
    );
  });

  it('are none where nothing is changed that a run could meet', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        expect(unitsOf(file, { ...structuredClone(file), runs: [], description: 'other' }, NO_RULES)).toEqual([]);
      }),
      { numRuns: 50 },
    );
  });
});
