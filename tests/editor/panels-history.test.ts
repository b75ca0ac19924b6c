import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { OpenLevel } from '../../editor/core/context/index.ts';
import { createEditedLevel, moveObjects } from '../../editor/core/document/index.ts';
import type { Version } from '../../editor/core/versions/index.ts';
import { formatHistory, readHistory } from '../../editor/features/history/history-file.ts';
import { restoreVersion, takeBackParts } from '../../editor/features/history/restore.ts';
import { type Difference, differencesBetween } from '../../editor/features/history/use-comparison.ts';
import {
  agoInWords,
  clockTime,
  dayInWords,
  historyRows,
  momentInWords,
  stepsInWords,
} from '../../editor/features/history/version-rows.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { apply, arbitraryEdits } from '../review/arbitrary-edits.ts';
import { arbitraryFile } from './arbitrary-file.ts';

/** A local time, ms since 1970. */
const at = (day: number, hour: number, minute = 0): number => new Date(2026, 10, day, hour, minute).getTime();
const NOW = at(27, 14, 32);

describe('times in words', () => {
  it('name the day and the time of day of this machine', () => {
    expect([clockTime(NOW), clockTime(at(27, 9, 5))]).toEqual(['14:32', '09:05']);
    expect([at(27, 0), at(26, 23, 59), at(23, 12)].map((time) => dayInWords(time, NOW))).toEqual([
      'Today',
      'Yesterday',
      'Monday, 23 November 2026',
    ]);
    expect([at(27, 0), at(26, 23, 59), at(23, 12)].map((time) => momentInWords(time, NOW))).toEqual([
      '00:00',
      'yesterday 23:59',
      '23 November 2026, 12:00',
    ]);
    expect([0, 59_999, 60_000, 7_200_000, 172_800_000].map((ms) => agoInWords(NOW - ms, NOW))).toEqual([
      'just now',
      'just now',
      '1 minute ago',
      '2 hours ago',
      '2 days ago',
    ]);
    // the clock was set back
    expect(agoInWords(NOW + 5000, NOW)).toBe('just now');
  });

  it('name yesterday on the days around a change of the clocks', () => {
    for (let day = 1; day < 366; day++) {
      const [now, before] = [new Date(2026, 0, day, 0, 30), new Date(2026, 0, day - 1, 23, 45)];
      expect(dayInWords(before.getTime(), now.getTime())).toBe('Yesterday');
    }
  });
});

const version = (number: number, time: number, more: Partial<Version> = {}): Version => ({
  ...{ number, time, by: 'page', labels: ['Move'], more: 0, changes: '', name: null, check: `${number}`, base: 1, size: 1 },
  ...more,
});

describe('the rows of the history', () => {
  const versions = [version(1, at(23, 9)), version(2, at(27, 9)), version(3, at(27, 10)), version(4, at(26, 8), { name: 'x' })];

  it('are versions by day, the newest first, whatever their numbers', () => {
    const rows = historyRows(versions, NOW, new Set());
    expect(rows.map(({ version: of, day }) => of?.number ?? day)).toEqual([
      'Today',
      3,
      2,
      'Yesterday',
      4,
      'Monday, 23 November 2026',
      1,
    ]);
    expect(rows.map(({ place, siblings }) => `${place}/${siblings}`)).toEqual(['0/3', '0/2', '1/2', '1/3', '0/1', '2/3', '0/1']);
    const folded = historyRows(versions, NOW, new Set(['Today']));
    expect(folded.map(({ version: of, day }) => of?.number ?? day).slice(0, 2)).toEqual(['Today', 'Yesterday']);
    expect(folded[0].count).toBe(2);
  });

  it('say which steps led to a version', () => {
    expect(stepsInWords(version(1, 0, { labels: ['Nudge', 'Nudge', 'Add hold', 'Nudge'] }))).toBe('Nudge ×2, Add hold, Nudge');
    expect(stepsInWords(version(1, 0, { labels: ['Nudge'], more: 4 }))).toBe('4 earlier steps, Nudge');
    expect(stepsInWords(version(1, 0, { labels: [], by: 'other' }))).toBe('Changed by another program');
    expect(stepsInWords(version(1, 0, { labels: [], by: 'found' }))).toBe('Found when the level was opened');
  });
});

const FILE: LevelFile = {
  version: 1,
  name: 'base',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [
    { id: 'aa', x: 10, y: 20, radius: 16 },
    { id: 'bb', x: 50, y: 20, radius: 16 },
  ],
  runs: [{ name: 'solution', holds: [[1, 50]] }],
};

/** An open level as far as restoring needs it. */
function openOf(file: LevelFile, role: 'writer' | 'reader' = 'writer') {
  const document = createEditedLevel(file);
  const noted: LevelFile[] = [];
  const versions = { note: (left: LevelFile) => void noted.push(left) };
  const opened = { lock: { store: { getState: () => role } }, versions };
  return { document, level: { document, opened } as unknown as OpenLevel, noted };
}

const wordsOf = (differences: readonly Difference[]) =>
  differences.map(({ title, parts }) => [title, ...parts.map(({ words }) => words)]);

describe('differences', () => {
  it('are grouped by object, with a part for each property', () => {
    const after: LevelFile = {
      ...FILE,
      name: 'new',
      rules: { pull: 45 },
      asteroids: [{ id: 'aa', x: 22, y: 20, radius: 20, 'x-own': 1 } as never],
      minerals: [{ id: 'mm', x: 1, y: 2 }],
      runs: [{ name: 'solution', holds: [[1, 60]] }],
    };
    expect(wordsOf(differencesBetween(FILE, after))).toEqual([
      [null, 'Renamed "base" -> "new"'],
      [null, 'Rule pull 45 px/s2 added'],
      [null, 'Asteroid 2 removed at (50, 20)'],
      ['Asteroid 1', 'Asteroid 1 moved 12 px right', 'Asteroid 1: radius 16 -> 20 px', 'Asteroid 1: x-own 1 added'],
      [null, 'Mineral 1 added at (1, 2)'],
      [null, 'Run "solution": release 1 is 10 ticks later'],
    ]);
  });

  it('have words and keys of their own, and taking all of them back gives the version, as one step', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryEdits(20), (file, edits) => {
        const { document, level } = openOf(file);
        const before = document.file();
        const next = structuredClone(before) as LevelFile;
        for (const edit of edits) apply(next, edit);
        if (!document.replace('Edit', next).ok) return;
        const after = document.file();
        const parts = differencesBetween(before, after).flatMap((difference) => difference.parts);
        expect(new Set(parts.map(({ key }) => key)).size).toBe(parts.length);
        for (const { words } of parts) expect(words).not.toBe('');
        const { done } = document.store.getState();
        const result = takeBackParts(level, before, after, parts);
        expect(result).toEqual({ ok: true });
        expect(formatLevel(document.file())).toBe(formatLevel(before));
        if (parts.length === 0) return;
        expect(document.store.getState().done).toBe(done + 1);
        document.undo();
        expect(formatLevel(document.file())).toBe(formatLevel(after));
      }),
      { numRuns: 100 },
    );
  });
});

describe('taking back and restoring', () => {
  it('never loses anything: after any edits, any choice of parts, and undo, the level is as before', () => {
    fc.assert(
      fc.property(
        arbitraryFile,
        arbitraryEdits(20),
        fc.array(fc.boolean(), { minLength: 30, maxLength: 30 }),
        fc.boolean(),
        (file, edits, dice, isWhole) => {
          const { document, level } = openOf(file);
          const before = document.file();
          const next = structuredClone(before) as LevelFile;
          for (const edit of edits) apply(next, edit);
          document.replace('Edit', next);
          const after = document.file();
          const { done } = document.store.getState();
          const parts = differencesBetween(before, after)
            .flatMap((difference) => difference.parts)
            .filter((_, i) => dice[i % dice.length]);
          const result = isWhole ? restoreVersion(level, before, '14:32') : takeBackParts(level, before, after, parts);
          if (!result.ok) expect(document.file()).toBe(after);
          if (isWhole) expect(formatLevel(document.file())).toBe(formatLevel(before));
          while (document.store.getState().done > done) document.undo();
          expect(formatLevel(document.file())).toBe(formatLevel(after));
        },
      ),
      { numRuns: 150 },
    );
  });

  it('is refused with a reason while another tab writes, while something is dragged, and when the level has changed', () => {
    const moved = { ...FILE, asteroids: FILE.asteroids?.slice(0, 1) } as LevelFile;
    const reader = openOf(moved, 'reader');
    expect(restoreVersion(reader.level, FILE, '14:32')).toEqual({ ok: false, why: expect.stringContaining('Another tab') });
    expect(reader.document.file()).toEqual(moved);

    const { document, level } = openOf(moved);
    const gesture = document.begin('Drag');
    gesture.set(moveObjects(['aa'], 5, 0));
    expect(restoreVersion(level, FILE, '14:32')).toEqual({ ok: false, why: expect.stringContaining('Let go') });
    expect(gesture.isLive).toBe(true);
    gesture.commit();
    const after = document.file();
    const [{ parts }] = differencesBetween(FILE, after);
    document.change('Move', moveObjects(['aa'], 5, 0));
    expect(takeBackParts(level, FILE, after, parts)).toEqual({ ok: false, why: expect.stringContaining('meantime') });
  });

  it('of an object whose id belongs to another one now is refused, unless that one goes', () => {
    const after = {
      ...FILE,
      asteroids: FILE.asteroids?.slice(0, 1),
      minerals: [{ id: 'bb', x: 1, y: 2 }],
    } as LevelFile;
    const { document, level } = openOf(after);
    const parts = differencesBetween(FILE, document.file()).flatMap((difference) => difference.parts);
    const back = parts.filter(({ words }) => words.startsWith('Asteroid'));
    expect(takeBackParts(level, FILE, document.file(), back)).toEqual({
      ok: false,
      why: "It can't come back: the id bb belongs to Mineral 1 now. Restore the whole version instead.",
    });
    expect(takeBackParts(level, FILE, document.file(), parts)).toEqual({ ok: true });
    expect(formatLevel(document.file())).toBe(formatLevel(FILE));
  });

  it('names its step, and keeps what it leaves', () => {
    const { document, level, noted } = openOf({ ...FILE, name: 'other' } as LevelFile);
    const left = document.file();
    restoreVersion(level, FILE, '14:32');
    // what is left is in the history
    expect(noted).toEqual([left]);
    expect(document.store.getState().undoLabel).toBe('Restore version of 14:32');
    document.undo();
    const [{ parts }] = differencesBetween(FILE, document.file());
    takeBackParts(level, FILE, document.file(), parts);
    expect(document.store.getState().undoLabel).toBe('Take back: Renamed "base" -> "other"');
  });
});

describe('a history in a file', () => {
  const past = { time: 5, by: 'page' as const, labels: ['Move'], more: 2, changes: 'Moved', name: 'x', text: formatLevel(FILE) };

  it('is read again as it was written', () => {
    expect(readHistory(formatHistory('01', [past]))).toEqual({ versions: [past], unread: 0 });
  });

  it('is refused or read as far as it can be, whatever is in it', () => {
    for (const text of ['', '7', 'null', '[]', '{}', '{"gravityQuestHistory":2,"versions":[]}', '{"gravityQuestHistory":1}'])
      expect(readHistory(text)).toBeNull();
    const wrong = [
      ...[
        { time: '5' },
        { time: 1e300 },
        { by: 'me' },
        { labels: 'Move' },
        { labels: [1] },
        { more: -1 },
        { more: 0.5 },
        { name: 7 },
      ],
      ...[{ text: 7 }, { text: '{}' }, { text: 'x' }],
    ].map((change) => ({ ...past, ...change }));
    expect(readHistory(formatHistory('01', [...wrong, past] as never))).toEqual({ versions: [past], unread: wrong.length });
    fc.assert(
      fc.property(fc.array(fc.json()), (values) => {
        const read = readHistory(JSON.stringify({ gravityQuestHistory: 1, versions: values.map((value) => JSON.parse(value)) }));
        expect(read).toEqual({ versions: [], unread: values.length });
      }),
    );
  });
});
