import { mkdirSync, renameSync, rmSync, statSync, symlinkSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import fc from 'fast-check';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { inOrderOfPlay } from '../../cli/io/level-names.ts';
import { createKnownLevels } from '../../cli/serve/known-levels.ts';
import { findLevel, findLevels, findLike, hasFolder, joinId, splitId } from '../../cli/serve/level-files.ts';
import { createEntryReader } from '../../cli/serve/read-entry.ts';
import { findTrash, makeStampFolder, moveToTrash } from '../../cli/serve/trash.ts';
import type { EditEvent } from '../../schema/index.ts';
import { everythingIn, levelText, makeFolder, put } from './running.ts';

let made: ReturnType<typeof makeFolder>;
beforeEach(() => {
  made = makeFolder({});
});
afterEach(() => {
  vi.restoreAllMocks();
  made.remove();
});
const path = (name: string) => join(made.folder, name);
const level = (name: string, text = name) => put(made.folder, `${name}.level.json`, levelText(text));

describe('the levels below a folder', () => {
  beforeEach(() => {
    for (const id of ['a', 'A b', 'w/b', 'w/v/c', 'w/10', 'w/9']) level(id);
    for (const name of [
      '.level.json',
      'x.json',
      'y.level.json.bak',
      '.hidden/h.level.json',
      'node_modules/n.level.json',
      'w/.git/g.level.json',
    ])
      put(made.folder, name, levelText('x'));
    mkdirSync(path('d.level.json'));
    symlinkSync('a.level.json', path('link.level.json'));
    symlinkSync('w', path('way'));
  });

  it('are all but hidden ones, those behind links and files with other names; a link is listed as one', () => {
    const { files, folders, troubles } = findLevels(made.folder);
    expect([...files.values()].map(({ id, isLink }) => (isLink ? `${id}, a link` : id))).toEqual([
      'a',
      'A b',
      'link, a link',
      'w/9',
      'w/10',
      'w/b',
      'w/v/c',
    ]);
    expect([folders, troubles]).toEqual([['', 'd.level.json', 'w', 'w/v'], []]);
    for (const [id, found] of files) {
      expect(found.path).toBe(path(`${id}.level.json`));
      expect(findLevel(made.folder, id)).toEqual(found);
    }
  });

  it('are found one by one by their exact name only', () => {
    const others = [
      '',
      'A',
      'x',
      'y',
      'd',
      'W/b',
      'w',
      'w/',
      '/a',
      './a',
      'w//b',
      'way/b',
      '.hidden/h',
      'node_modules/n',
      'w/../a',
      '../a',
      'a.level.json',
      'link/x',
    ];
    for (const id of others) expect([id, findLevel(made.folder, id)]).toEqual([id, undefined]);
    const folders = ['', 'w', 'w/v', 'd.level.json'];
    for (const folder of [
      ...folders,
      'W',
      'way',
      '.hidden',
      'node_modules',
      'w/.git',
      'nowhere',
      'a.level.json',
      '/',
      'w/',
      'w//v',
    ])
      expect([folder, hasFolder(made.folder, folder)]).toEqual([folder, folders.includes(folder)]);
  });

  it.runIf(process.platform === 'linux')('are similar to others that differ only in case in any part of their path', () => {
    level('W2/x');
    level('w2/X');
    expect(findLike(made.folder, 'w2/x').sort()).toEqual(['W2/x', 'w2/X']);
    expect([
      findLike(made.folder, 'A'),
      findLike(made.folder, 'a b'),
      findLike(made.folder, 'b'),
      findLike(made.folder, 'WAY/b'),
    ]).toEqual([['a'], ['A b'], [], []]);
  });

  it('have ids that consist of a folder and a name', () => {
    expect(['a', 'w/b', 'w/v/c', ''].map(splitId)).toEqual([
      { folder: '', name: 'a' },
      { folder: 'w', name: 'b' },
      { folder: 'w/v', name: 'c' },
      { folder: '', name: '' },
    ]);
    for (const id of ['a', 'w/b', 'w/v/c']) expect(joinId(splitId(id).folder, splitId(id).name)).toBe(id);
  });

  it('are sorted by their parts, with numbers by value, and are equal only if they are the same', () => {
    const part = fc.constantFrom('1', '01', '2', '10', 'a', 'A', 'ä', 'b', '2-b', '10-a', '');
    const id = fc.array(part, { minLength: 1, maxLength: 3 }).map((parts) => parts.join('/'));
    fc.assert(
      fc.property(id, id, id, (a, b, c) => {
        expect(Math.sign(inOrderOfPlay(a, b))).toBe(-Math.sign(inOrderOfPlay(b, a)) + 0);
        expect(inOrderOfPlay(a, b) === 0).toBe(a === b);
        if (inOrderOfPlay(a, b) < 0 && inOrderOfPlay(b, c) < 0) expect(inOrderOfPlay(a, c)).toBeLessThan(0);
      }),
      { numRuns: 1000 },
    );
    expect(['b', 'a/z', '10-a', '2-b', 'a'].sort(inOrderOfPlay)).toEqual(['2-b', '10-a', 'a', 'a/z', 'b']);
  });
});

describe('the entry of a file', () => {
  const reader = () => createEntryReader((id) => `shown/${id}`);
  const found = (id: string) => {
    const file = findLevels(made.folder).files.get(id);
    if (file === undefined) throw new Error(`${id} is not there`);
    return file;
  };
  const later = (ms: number) => vi.spyOn(Date, 'now').mockReturnValue(statSync(path('a.level.json')).ctimeMs + ms);

  it('is the same object in every list while the file is unchanged, once it is 2 s old', () => {
    level('a');
    const known = reader();
    for (const [age, isSame] of [
      [0, false],
      [1900, false],
      [-1900, false],
      [2100, true],
      [1e6, true],
    ] as const) {
      later(age);
      const first = known.entry(found('a'));
      expect([age, known.entry(found('a')) === first]).toEqual([age, isSame]);
      expect(known.entry(found('a'))).toEqual(first);
    }
    later(1e9);
    const before = known.entry(found('a'));
    expect(before).toMatchObject({ id: 'a', file: 'shown/a', name: 'a', status: 'valid' });
    level('a', 'new');
    utimesSync(path('a.level.json'), 1, 1);
    later(1e9);
    expect(known.entry(found('a')).name).toBe('new');
    const again = known.entry(found('a'));
    known.keepOnly([again]);
    expect(known.entry(found('a'))).toBe(again);
    known.keepOnly([]);
    expect(known.entry(found('a'))).not.toBe(again);
    expect(known.entry(found('a'))).toEqual(again);
    // while a change could go unnoticed, it is read each time, and also right after that
    later(0);
    known.entry(found('a'));
    later(1e9);
    const fresh = known.entry(found('a'));
    expect(known.entry(found('a'))).toBe(fresh);
  });

  it('is read again, with its text, before every change', () => {
    level('a');
    const known = reader();
    later(1e9);
    known.entry(found('a'));
    expect(known.read(found('a'))).toMatchObject({ id: 'a', text: levelText('a') });
    expect(known.entry(found('a'))).not.toHaveProperty('text');
  });

  it('contains the reason why the file can not be read', () => {
    level('a');
    symlinkSync('a.level.json', path('link.level.json'));
    writeFileSync(path('large.level.json'), Buffer.alloc(8 * 1024 * 1024 + 1));
    writeFileSync(path('largest.level.json'), Buffer.alloc(8 * 1024 * 1024, 32));
    const known = reader();
    const gone = found('a');
    rmSync(path('a.level.json'));
    for (const [file, code, why] of [
      [found('link'), 'unreadable-file', /symbolic link/],
      [found('large'), 'file-too-large', /larger than 8 MiB/],
      [gone, 'unreadable-file', /can't be read/],
    ] as const) {
      const entry = known.entry(file);
      expect(entry).toMatchObject({ status: 'unreadable', etag: null, name: null, readOnly: expect.stringMatching(why) });
      expect(entry.problems).toMatchObject([{ code, message: expect.stringMatching(why), severity: 'error', line: null }]);
      expect(known.read(file)).toEqual({ ...entry, text: null });
    }
    expect(known.entry(found('largest'))).toMatchObject({ status: 'invalid', problems: [{ code: 'empty-file' }] });
  });
});

describe('the trash', () => {
  const now = new Date('2026-01-31T12:00:00.000Z');
  const file = (id: string) => {
    const found = findLevel(made.folder, id);
    if (found === undefined) throw new Error(`${id} is not there`);
    return found;
  };

  it('contains a folder for each deletion, and lists the last one first', () => {
    expect(findTrash(made.folder)).toEqual([]);
    level('w/a');
    const first = moveToTrash(made.folder, file('w/a'), now);
    level('w/a', 'second');
    const second = moveToTrash(made.folder, file('w/a'), now);
    level('b');
    const third = moveToTrash(made.folder, file('b'), new Date(now.getTime() + 1));
    expect([first, second, third].map(({ trash, id, deleted }) => [trash, id, deleted])).toEqual([
      ['2026-01-31T12-00-00.000Z/w/a', 'w/a', '2026-01-31T12:00:00.000Z'],
      ['2026-01-31T12-00-00.000Z_2/w/a', 'w/a', '2026-01-31T12:00:00.000Z'],
      ['2026-01-31T12-00-00.001Z/b', 'b', '2026-01-31T12:00:00.001Z'],
    ]);
    expect(findTrash(made.folder).map(({ entry }) => entry)).toEqual([third, second, first]);
    expect(findLevels(made.folder).files.size).toBe(0);
    expect(everythingIn(made.folder)).toMatchObject({
      '.gq-trash/.gitignore': '*\n',
      '.gq-trash/2026-01-31T12-00-00.000Z_2/w/a.level.json': levelText('second'),
    });
    // a file that the user has changed stays
    put(made.folder, '.gq-trash/.gitignore', 'mine');
    expect(makeStampFolder(made.folder, now)).toBe('2026-01-31T12-00-00.000Z_3');
    expect(everythingIn(made.folder)['.gq-trash/.gitignore']).toBe('mine');
  });

  it('contains nothing outside its folders, and no links or files behind links', () => {
    level('a');
    moveToTrash(made.folder, file('a'), now);
    const stamp = path('.gq-trash/2026-01-31T12-00-00.000Z');
    symlinkSync('a.level.json', join(stamp, 'link.level.json'));
    for (const name of [
      'notes',
      '2026-01-31',
      'x2026-01-31T12-00-00.000Z',
      '2026-01-31T12-00-00.000Zx',
      '2026-01-31T12-00-00.000Z_',
    ])
      put(made.folder, `.gq-trash/${name}/b.level.json`, levelText('b'));
    put(made.folder, '.gq-trash/2026-01-31T12-00-01.000Z', 'a file');
    symlinkSync('2026-01-31T12-00-00.000Z', path('.gq-trash/2026-01-31T12-00-02.000Z'));
    expect(findTrash(made.folder).map(({ entry }) => entry.trash)).toEqual(['2026-01-31T12-00-00.000Z/a']);
    renameSync(path('.gq-trash'), path('away'));
    symlinkSync('away', path('.gq-trash'));
    expect(findTrash(made.folder)).toEqual([]);
    expect(() => makeStampFolder(made.folder, now)).toThrow(/\.gq-trash is not a folder/);
    rmSync(path('.gq-trash'));
    writeFileSync(path('.gq-trash'), 'a file');
    expect(findTrash(made.folder)).toEqual([]);
    expect(() => makeStampFolder(made.folder, now)).toThrow(/\.gq-trash is not a folder/);
    rmSync(path('.gq-trash'));
    symlinkSync('nowhere', path('.gq-trash'));
    expect(() => makeStampFolder(made.folder, now)).toThrow(/\.gq-trash is not a folder/);
  });
});

describe('the reported state of a folder', () => {
  const open = () => {
    const known = createKnownLevels(
      made.folder,
      'shown',
      createEntryReader((id) => id),
    );
    const events: EditEvent[] = [];
    known.listen((event) => events.push(event));
    const ids = () => known.list().levels.map(({ id }) => id);
    return { known, events, ids };
  };
  const words = (events: readonly EditEvent[]) =>
    events.map((event) =>
      event.type === 'renamed'
        ? `${event.from} to ${event.entry.id}`
        : event.type === 'changed'
          ? `${event.entry.id} by ${event.by}`
          : event.type === 'removed'
            ? `${event.id} gone`
            : event.type,
    );

  it('is that of the disk at the last refresh, in order of play', async () => {
    for (const id of ['1', '10', '2']) level(id);
    const { known, events, ids } = open();
    expect([ids(), known.list().unread, known.list().folder.path]).toEqual([['1', '2', '10'], 0, 'shown']);
    for (const id of ['3', '0', '11']) level(id);
    rmSync(path('1.level.json'));
    expect(ids()).toEqual(['1', '2', '10']);
    expect((await known.refresh()).levels.map(({ id }) => id)).toEqual(['0', '2', '3', '10', '11']);
    expect(words(events)).toEqual(['1 gone', '0 by null', '3 by null', '11 by null']);
    await known.refresh();
    expect(events).toHaveLength(4);
  });

  it('contains announced levels at their places, and each event occurs once with the client', () => {
    for (const id of ['1', '3', '5']) level(id);
    const { known, events, ids } = open();
    for (const id of ['0', '2', '4', '6']) level(id);
    level('3', 'new');
    rmSync(path('5.level.json'));
    known.announce(['6', '0', '0', '4', '2', '3', '5', '1', 'nowhere'], 'me');
    expect(ids()).toEqual(['0', '1', '2', '3', '4', '6']);
    expect(words(events).sort()).toEqual(['0 by me', '2 by me', '3 by me', '4 by me', '5 gone', '6 by me']);
    events.length = 0;
    renameSync(path('1.level.json'), path('9.level.json'));
    known.announce(['1', '9'], null);
    expect([ids(), words(events)]).toEqual([['0', '2', '3', '4', '6', '9'], ['1 to 9']]);
  });

  it('contains a new level between the last two, and a changed last level at its place', () => {
    for (const id of ['1', '3']) level(id);
    const { known, ids } = open();
    level('2');
    known.announce(['2'], 'me');
    expect(ids()).toEqual(['1', '2', '3']);
    level('3', 'new');
    known.announce(['3'], 'me');
    expect(known.list().levels.map(({ id, name }) => [id, name])).toEqual([
      ['1', '1'],
      ['2', '2'],
      ['3', 'new'],
    ]);
    level('2', 'new');
    known.announce(['2'], 'me');
    expect(ids()).toEqual(['1', '2', '3']);
  });

  it('is the same if few levels are announced or so many that the whole folder is listed', () => {
    const all = Array.from({ length: 30 }, (_, i) => `${i}`);
    const { known, events, ids } = open();
    for (const count of [20, 21, 30]) {
      for (const id of all.slice(0, count)) level(id, `${count}`);
      known.announce(all.slice(0, count), null);
      expect(ids()).toEqual(all.slice(0, count));
      for (const id of all.slice(0, count)) rmSync(path(`${id}.level.json`));
      known.announce(all.slice(0, count), null);
      expect(ids()).toEqual([]);
    }
    expect(events).toHaveLength(2 * (20 + 21 + 30));
  });

  it('keeps what is announced while the whole folder is being read', async () => {
    level('a');
    const { known, ids } = open();
    const looking = known.refresh();
    level('b');
    known.announce(['b'], 'me');
    await looking;
    expect(ids()).toEqual(['a', 'b']);
    // a refresh that is requested during another one begins after the request
    const first = known.refresh();
    level('c');
    const second = known.refresh();
    await first;
    expect((await second).levels.map(({ id }) => id)).toEqual(['a', 'b', 'c']);
  });

  it('is reported until a listener stops or fails; a trouble is reported once', () => {
    const { known, events } = open();
    let times = 0;
    const stop = known.listen(() => times++);
    known.listen(() => {
      times += 100;
      throw new Error('gone');
    });
    known.addTrouble('no watch');
    known.addTrouble('no watch');
    expect([times, known.list().troubles, words(events)]).toEqual([101, ['no watch'], ['list']]);
    known.addTrouble('other');
    stop();
    known.addTrouble('third');
    expect([times, known.list().troubles]).toEqual([102, ['no watch', 'other', 'third']]);
  });
});
