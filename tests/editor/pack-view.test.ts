import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { effectsToMeet, moveEntries } from '../../check/pack/index.ts';
import { findPack } from '../../cli/build/pack.ts';
import { noConfiguration } from '../../cli/config/configuration.ts';
import { findLevelFiles } from '../../cli/find/index.ts';
import { checkPackFile } from '../../cli/pack-file/index.ts';
import { openLevelFolder } from '../../cli/serve/level-folder.ts';
import { folderPackIn, inOrderOfPack } from '../../editor/core/files/folder-list.ts';
import { moveByKey, spotAfter } from '../../editor/features/pack/card-order.ts';
import { curveOf, heightOf } from '../../editor/features/pack/PackCurve.tsx';
import {
  type Card,
  effectsOf,
  isFiltered,
  modelOf,
  NO_FILTER,
  passes,
  type ShownGrade,
} from '../../editor/features/pack/pack-model.ts';
import type { LevelFacts } from '../../editor/workers/index.ts';
import { thumbnailWork } from '../../editor/workers/jobs/thumbnail.ts';
import { DEFAULT_TERMS } from '../../engine/index.ts';
import { formatPack, type LevelEntry, type ListResponse, type PackFile, readLevel } from '../../schema/index.ts';
import { makeFolder } from '../server/running.ts';

const packOf = (...levels: PackFile['levels']): PackFile => ({ version: 1, name: 'Test', levels });
const level = (name: string, more: object = {}): string =>
  JSON.stringify({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 170, y: 0 }, ...more });

/** Levels by their id, each with other effects; one is no level. */
const LEVELS: Readonly<Record<string, string>> = {
  a: level('A'),
  b: level('B', { minerals: [{ x: 60, y: 0 }] }),
  c: level('C', { novae: [{ x: 100, y: 90, radius: 9 }], rules: { recoil: 10 }, asteroids: [{ x: 9, y: 99, radius: 9 }] }),
  '10-d': level('D', { minerals: [{ x: 60, y: 0 }], repulsors: [{ x: 100, y: 90, radius: 9 }] }),
  '2-e': '{ "version": 1 }',
  'w/f': level('F', { aliens: [{ x: 300, y: 300 }] }),
};

/** Runs a job to its end. */
function factsOf(text: string): LevelFacts | null {
  const job = thumbnailWork.steps({ text, terms: DEFAULT_TERMS, width: 144, theme: 'dark' }, () => 0);
  let step = job.next();
  while (!step.done) step = job.next();
  return step.value.facts;
}
const FACTS = new Map(Object.entries(LEVELS).map(([id, text]) => [id, factsOf(text)]));

/** What the view of a folder shows, as the page has it from the server. */
function shown(list: ListResponse, grades: ReadonlyMap<string, ShownGrade> = new Map()) {
  const ordered = inOrderOfPack(list, new Map());
  return modelOf({
    levels: ordered.levels,
    pack: folderPackIn({ list: ordered }),
    factsOf: (entry) => (entry.status === 'valid' ? FACTS.get(entry.id) : null),
    gradeOf: (entry) => grades.get(entry.id) ?? null,
  });
}

async function inFolder<T>(
  ids: readonly string[],
  pack: PackFile | null,
  act: (folder: string, list: ListResponse) => Promise<T> | T,
) {
  const { folder, remove } = makeFolder({});
  for (const id of ids) {
    const path = join(folder, `${id}.level.json`);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, LEVELS[id]);
  }
  if (pack !== null) writeFileSync(join(folder, 'pack.json'), formatPack(pack));
  const levels = openLevelFolder(folder, folder);
  try {
    return await act(folder, levels.known.list());
  } finally {
    levels.end();
    remove();
  }
}

const some = fc.subarray(Object.keys(LEVELS), { minLength: 1 });
const entry = fc.oneof(
  { weight: 5, arbitrary: fc.constantFrom(...Object.keys(LEVELS), 'gone') },
  fc.constant({ chapter: 'C' }),
  fc.record({
    level: fc.constantFrom('b', 'c', 'w/f'),
    introduces: fc.subarray(['novae', 'recoil', 'minerals'], { minLength: 1 }),
  }),
);
const pack = fc.array(entry, { maxLength: 9 }).map((levels) => packOf(...levels));

describe('check, build and editor', () => {
  it('have the same order, whatever the pack lists', async () => {
    await fc.assert(
      fc.asyncProperty(some, pack, async (ids, wanted) => {
        // build refuses a list with errors
        const there = wanted.levels.filter((one) => typeof one !== 'string' || ids.includes(one));
        const once = there.filter((one, i) => typeof one === 'object' || there.indexOf(one) === i);
        const fine = packOf(...once.filter((one) => typeof one === 'string' || 'chapter' in one), ids[0]);
        const good = packOf(...fine.levels.filter((one, i) => typeof one === 'object' || fine.levels.indexOf(one) === i));
        await inFolder(ids, good, async (folder, list) => {
          const idOf = (file: string): string => file.slice(folder.length + 1).replace('.level.json', '');
          const checked = (await findLevelFiles([folder])).files.map(idOf);
          const built = await findPack([folder], noConfiguration());
          const edited = inOrderOfPack(list, new Map()).levels.map(({ id }) => id);
          expect(edited).toEqual(checked);
          expect([...built.files.map(({ id }) => id), ...built.leftOut]).toEqual(checked);
          expect(shown(list).cards.map(({ id }) => id)).toEqual(checked);
        });
      }),
      { numRuns: 40 },
    );
  });

  it('find the same problems of a pack, word for word and place for place', async () => {
    await fc.assert(
      fc.asyncProperty(some, pack, async (ids, wanted) => {
        await inFolder(ids, wanted, async (folder, list) => {
          const { files, packs } = await findLevelFiles([folder]);
          const { problems } = checkPackFile(packs[0], new Set(files), { rules: {}, severity: {} });
          expect(problems.map(({ frame: _, ...problem }) => problem)).toEqual(shown(list).problems);
        });
      }),
      { numRuns: 60 },
    );
  });
});

describe('the cards', () => {
  it('have a number each, what they introduce and their jumps; unlisted levels come last', async () => {
    const wanted = packOf('a', { chapter: 'One' }, 'b', '10-d', 'gone', 'b');
    await inFolder(['a', 'b', '10-d', 'c'], wanted, (_, list) => {
      const grade = (value: number): ShownGrade => ({ value, word: 'easy', isOld: false });
      const grades = new Map([
        ['a', grade(1)],
        ['10-d', grade(3.4)],
        ['c', grade(9)],
      ]);
      const { cards, chapters } = shown(list, grades);
      expect(cards.map(({ number, place, id, isListed }) => [number, place, id, isListed])).toEqual([
        [1, 0, 'a', true],
        [2, 2, 'b', true],
        [3, 3, '10-d', true],
        [4, 4, 'gone', true],
        [5, 5, 'b', true],
        [6, 6, 'c', false],
      ]);
      expect(cards.map(({ introduces }) => introduces)).toEqual([[], ['minerals'], ['repulsor'], [], [], []]);
      // a level that is not listed is on no curve
      expect(cards.map(({ jump }) => jump)).toEqual([null, null, 2.4, null, null, null]);
      expect(new Set(cards.map(({ key }) => key)).size).toBe(cards.length);
      expect(chapters.map(({ name, isUnlisted, cards: own }) => [name, isUnlisted, own.map(({ id }) => id)])).toEqual([
        [null, false, ['a']],
        ['One', false, ['b', '10-d', 'gone', 'b']],
        [null, true, ['c']],
      ]);
    });
  });

  it('say of a level what the engine says: its effects are those that it calls for', () => {
    for (const [id, text] of Object.entries(LEVELS)) {
      const reading = readLevel(text);
      expect(FACTS.get(id)?.effects ?? null, id).toEqual(reading.ok ? effectsToMeet(reading.level) : null);
    }
  });
});

const cardOf = (id: string, more: Partial<Card> = {}): Card => ({
  ...{ key: id, place: 0, number: 1, id, isListed: true, facts: null, grade: null, introduces: [], jump: null },
  entry: { id, file: id, etag: null, status: 'valid', name: id, problems: [], readOnly: null } satisfies LevelEntry,
  ...more,
});

describe('the filter', () => {
  const facts = { effects: ['alien-chase'], seconds: 3, minerals: 0, mineralCount: 0 };
  const card = cardOf('w/07-long-way', { facts });
  it.each([
    [NO_FILTER, true],
    [{ ...NO_FILTER, text: 'WAY long' }, true],
    [{ ...NO_FILTER, text: 'long short' }, false],
    [{ ...NO_FILTER, verdict: 'broken' }, true],
    [{ ...NO_FILTER, verdict: 'completable' }, false],
    [{ ...NO_FILTER, effect: 'alien-chase' }, true],
    [{ ...NO_FILTER, effect: 'novae' }, false],
  ])('%j', (filter, expected) => {
    expect(passes(card, 'broken', filter)).toBe(expected);
    expect(isFiltered(filter)).toBe(filter !== NO_FILTER);
  });
  it('offers the effects that there are', () => expect(effectsOf([card, cardOf('b')])).toEqual([['alien-chase', 'alien chase']]));
});

describe('keys', () => {
  const grid = Array.from({ length: 7 }, (_, i) => ({ left: 100 * (i % 3), top: 80 * Math.floor(i / 3) }));
  it.each([
    [0, 'ArrowRight', 1],
    [2, 'ArrowRight', 3],
    [6, 'ArrowRight', 6],
    [0, 'ArrowLeft', 0],
    [4, 'ArrowUp', 1],
    [4, 'ArrowDown', 6],
    [5, 'ArrowDown', 6],
    [1, 'ArrowUp', 1],
    [3, 'End', 6],
    [3, 'Home', 0],
  ])('from card %i, %s leads to card %i', (from, key, to) => expect(spotAfter(grid, from, key)).toBe(to));

  it('move a selection by one entry, gather it, and bring it to an end; the other way takes it back', () => {
    const entries = ['a', 'b', 'c', 'd', 'e', 'f'];
    fc.assert(
      fc.property(
        fc.subarray([0, 1, 2, 3, 4, 5], { minLength: 1 }),
        fc.constantFrom('ArrowUp', 'ArrowRight', 'Home', 'End'),
        (places, key) => {
          const move = moveByKey(places, key, entries.length);
          const ids = places.map((place) => entries[place]);
          const after = move === null ? entries : moveEntries(packOf(...entries), entries, move.moved, move.before).levels;
          const now = ids.map((id) => after.indexOf(id));
          const isTogether = now.every((place, i) => place === now[0] + i);
          expect(isTogether).toBe(true);
          const [first, last] = [places[0], places[places.length - 1]];
          if (key === 'Home') expect(now[0]).toBe(0);
          if (key === 'End') expect(now.at(-1)).toBe(5);
          if (key === 'ArrowUp') expect(now[0]).toBe(Math.max(0, first - 1));
          if (key === 'ArrowRight') expect(now.at(-1)).toBe(Math.min(5, last + 1));
          const rest = entries.filter((id) => !ids.includes(id));
          expect(after.filter((id) => !ids.includes(id as string))).toEqual(rest);
        },
      ),
    );
  });
});

describe('the curve', () => {
  it('has a point for each measured level in its place, and a gap where none is', () => {
    const grade = (value: number | null): ShownGrade | null => (value === null ? null : { value, word: '', isOld: false });
    const cards = [1, 3, null, 10, 5].map((value, i) => cardOf(String(i), { grade: grade(value) }));
    const { points, lines } = curveOf([...cards, cardOf('x', { isListed: false, grade: grade(7) })], 436, 132);
    expect(points.map(({ card, x }) => [card.id, Math.round(x)])).toEqual([
      ['0', 26],
      ['1', 126],
      ['3', 326],
      ['4', 426],
    ]);
    expect(points[0].y).toBeGreaterThan(points[1].y);
    expect(points[2].y).toBe(heightOf(10, 132));
    expect(lines).toHaveLength(2);
    expect(curveOf([], 400, 132)).toEqual({ points: [], lines: [] });
    expect(curveOf([cardOf('a', { grade: grade(4) })], 400, 132).points).toHaveLength(1);
  });
});
