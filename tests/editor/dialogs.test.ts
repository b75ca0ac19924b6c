import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { freeId, nextNumber } from '../../editor/core/levels/level-files.ts';
import { TEMPLATES } from '../../editor/core/templates/index.ts';
import { dropPlace, leavesBetween, parentOf, stepFrom, type TreeRow } from '../../editor/core/tree/tree-rows.ts';
import { diffLines, valueInWords } from '../../editor/features/conflicts/conflict-text.ts';
import { levelRows } from '../../editor/features/levels/level-rows.ts';
import { isSameRow, objectRows } from '../../editor/features/outliner/object-rows.ts';
import type { LevelEntry } from '../../schema/index.ts';

const entry = (id: string, name: string | null = id): LevelEntry => ({
  id,
  file: `levels/${id}.level.json`,
  etag: null,
  status: name === null ? 'invalid' : 'valid',
  name,
  problems: [],
  readOnly: null,
});

const row = (key: string, more: Partial<TreeRow> = {}): TreeRow => ({
  key,
  depth: 1,
  label: key,
  expanded: null,
  list: 'a',
  place: 0,
  siblings: 1,
  ...more,
});

const text = fc.array(fc.constantFrom('a', 'b', 'c', 'd'), { maxLength: 12 }).map((lines) => lines.join('\n'));

describe('differences between texts', () => {
  test('the lines that are not new make up the old text, and those that are not old the new one', () => {
    fc.assert(
      fc.property(text, text, (before, after) => {
        const lines = diffLines(before, after);
        const side = (gone: 'old' | 'new') => lines.filter(({ kind }) => kind !== gone).map((line) => line.text);
        expect(side('new').join('\n')).toBe(before);
        expect(side('old').join('\n')).toBe(after);
      }),
    );
  });

  test('an unchanged line is not both removed and added', () => {
    expect(diffLines('a\nb\nc', 'a\nx\nc').map(({ kind }) => kind)).toEqual(['same', 'old', 'new', 'same']);
    expect(diffLines('a\nb', 'a\nb').every(({ kind }) => kind === 'same')).toBe(true);
  });

  test('long texts that share little are replaced as a whole', () => {
    const before = Array.from({ length: 2000 }, (_, i) => `old ${i}`).join('\n');
    const after = Array.from({ length: 2000 }, (_, i) => `new ${i}`).join('\n');
    const lines = diffLines(before, after);
    expect(lines.filter(({ kind }) => kind !== 'new')).toHaveLength(2000);
    expect(lines.filter(({ kind }) => kind === 'new')).toHaveLength(2000);
  });
});

test('values of a conflict in words', () => {
  expect(valueInWords(undefined)).toBe('absent');
  expect(valueInWords({ x: 665, y: 848 })).toBe('x 665, y 848');
  expect(valueInWords([[150, 435]])).toBe('[150,435]');
  expect(valueInWords([])).toBe('none');
  expect(valueInWords('Let Go')).toBe('Let Go');
  expect(valueInWords(Array.from({ length: 100 }, () => [1, 2]))).toHaveLength(90);
});

describe('names of files', () => {
  test('a free name is free in any case of letters, and is the wanted one if that is free', () => {
    const levels = [entry('Loop'), entry('loop-2'), entry('world/loop')];
    expect(freeId(levels, '', 'loop')).toBe('loop-3');
    expect(freeId(levels, 'world', 'swing')).toBe('world/swing');
    fc.assert(
      fc.property(
        fc.uniqueArray(fc.constantFrom('a', 'a-2', 'a-3', 'A-4', 'b')),
        fc.constantFrom('a', 'b', 'c'),
        (ids, wanted) => {
          const found = freeId(
            ids.map((id) => ({ id })),
            '',
            wanted,
          ).toLowerCase();
          expect(ids.map((id) => id.toLowerCase())).not.toContain(found);
        },
      ),
    );
  });

  test('a new level continues the numbers of its folder, if all levels have one', () => {
    expect(nextNumber([entry('01-a'), entry('18-b')], '')).toBe('19-');
    expect(nextNumber([entry('007-a')], '')).toBe('008-');
    expect(nextNumber([entry('01-a'), entry('b')], '')).toBe('');
    expect(nextNumber([entry('01-a'), entry('w/02-b')], 'w')).toBe('03-');
    expect(nextNumber([], '')).toBe('');
  });
});

describe('rows of levels', () => {
  const levels = [entry('01-a', 'First Pull'), entry('02-b', null), entry('w/01-c', 'Hot Rock'), entry('w/02-d', 'Swing')];

  test('the levels of a folder are below it, and can be collapsed', () => {
    const keys = (folded: string[]) => levelRows(levels, new Set(folded), '').map(({ key }) => key);
    expect(keys([])).toEqual(['01-a', '02-b', 'w/', 'w/01-c', 'w/02-d']);
    expect(keys(['w'])).toEqual(['01-a', '02-b', 'w/']);
  });

  test('a search looks at names and files, expands folders, and disables moving', () => {
    const rows = levelRows(levels, new Set(['w']), 'rock w/');
    expect(rows.map(({ key }) => key)).toEqual(['w/', 'w/01-c']);
    expect(rows.every(({ list }) => list === null)).toBe(true);
  });

  test('an invalid level is marked', () => {
    expect(levelRows(levels, new Set(), '02-b')[0].label).toBe('02-b, invalid');
  });
});

describe('rows of a tree', () => {
  const rows = [row('a'), row('k', { expanded: true, list: null }), row('b', { depth: 2 }), row('c', { depth: 2 }), row('d')];

  test('steps stay within the rows', () => {
    expect(stepFrom(rows, 'a', -1)?.key).toBe('a');
    expect(stepFrom(rows, 'd', 9)?.key).toBe('d');
    expect(stepFrom(rows, null, 1)?.key).toBe('a');
    expect(stepFrom([], 'a', 1)).toBeNull();
  });

  test('parentOf finds the row above in the tree, and leavesBetween all leaves from one row to another', () => {
    expect(parentOf(rows, 'c')?.key).toBe('k');
    expect(parentOf(rows, 'd')).toBeNull();
    expect(leavesBetween(rows, 'd', 'a')).toEqual(['a', 'b', 'c', 'd']);
    expect(leavesBetween(rows, 'gone', 'b')).toEqual(['b']);
  });

  test('a row moves to where the line is drawn', () => {
    const list = ['p', 'q', 'r', 's', 't'];
    const index = fc.nat({ max: list.length - 1 });
    fc.assert(
      fc.property(index, index, fc.boolean(), (from, over, below) => {
        const at = (place: number) => row(list[place], { place, siblings: list.length });
        const place = dropPlace(at(from), at(over), below);
        const marked = list.map((key) => ({ key, moved: false }));
        marked.splice(over + (below ? 1 : 0), 0, { key: list[from], moved: true });
        const wanted = marked.filter(({ key, moved }) => moved || key !== list[from]).map(({ key }) => key);
        const moved = list.filter((_, i) => i !== from);
        moved.splice(place ?? from, 0, list[from]);
        expect(moved).toEqual(wanted);
      }),
    );
    expect(dropPlace(row('a', { list: 'x' }), row('b', { list: 'y' }), true)).toBeNull();
  });
});

test('a row of the outline counts as another when what it shows has changed, also its number', () => {
  const file = TEMPLATES[2].make('Thrown', 7);
  const rocks = (file.asteroids ?? []).map((rock, i) => ({ ...rock, 'x-name': `Rock ${i}` }));
  const rows = (asteroids: typeof rocks) => new Map(objectRows({ ...file, asteroids }, new Set()).map((row) => [row.key, row]));
  const changed = (asteroids: typeof rocks) => {
    const [before, after] = [rows(rocks), rows(asteroids)];
    return [...after].flatMap(([key, row]) => (isSameRow(before.get(key) ?? row, row) ? [] : [key]));
  };
  const keys = rocks.map(({ id }) => id);
  expect(changed([...rocks])).toEqual([]);
  expect(changed([...rocks].reverse()).sort()).toEqual([...keys.filter((_, i) => i !== 3), '@kind asteroid'].sort());
  expect(changed(rocks.map((rock, i) => (i === 2 ? { ...rock, x: rock.x + 1 } : rock)))).toEqual([keys[2]]);
});

test('the outline lists every object once, and none of a collapsed kind', () => {
  const file = TEMPLATES[2].make('Thrown', 7);
  const shown = objectRows(file, new Set()).filter(({ found }) => found !== null);
  expect(shown).toHaveLength(2 + 7 + 3);
  expect(new Set(shown.map(({ key }) => key)).size).toBe(12);
  const folded = objectRows(file, new Set(['@kind asteroid']));
  expect(folded.filter(({ found, kind }) => found !== null && kind === 'asteroid')).toHaveLength(0);
  expect(folded.find(({ kind }) => kind === 'asteroid')?.keys).toHaveLength(7);
});
