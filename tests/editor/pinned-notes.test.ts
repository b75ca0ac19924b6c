import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { packedLevel } from '../../check/pack/index.ts';
import {
  createEditedLevel,
  editPinnedNote,
  pinNote,
  pinnedNotesIn,
  pinProblem,
  unpinNote,
} from '../../editor/core/document/index.ts';
import { levelHash } from '../../game/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const place = fc.integer({ min: -5000, max: 5000 });
const text = fc.string({ minLength: 1, maxLength: 40 });

describe('notes of a level', () => {
  it('are added, moved, edited and deleted, a step each; neither the hash nor packs change', () => {
    fc.assert(
      fc.property(arbitraryFile, fc.array(fc.tuple(place, place, text), { minLength: 1, maxLength: 5 }), (file, wanted) => {
        const level = createEditedLevel(file);
        const before = level.file();
        for (const [x, y, words] of wanted) level.change('Add', pinNote(x, y, words));
        expect(pinnedNotesIn(level.file()).map(({ x, y, text: words }) => [x, y, words])).toEqual(wanted);
        expect(new Set(pinnedNotesIn(level.file()).map(({ id }) => id)).size).toBe(wanted.length);
        expect(levelHash(resolveLevel(level.file()))).toBe(levelHash(resolveLevel(before)));
        const options = { rules: {}, withRuns: true, found: null };
        expect(packedLevel(level.file(), options)).toEqual(packedLevel(before, options));
        const [{ id }] = pinnedNotesIn(level.file());
        level.change('Move', editPinnedNote(id, { x: 7, y: 8 }));
        level.change('Edit', editPinnedNote(id, { text: 'new' }));
        expect(pinnedNotesIn(level.file())[0]).toEqual({ id, x: 7, y: 8, text: 'new' });
        for (const note of pinnedNotesIn(level.file())) level.change('Delete', unpinNote(note.id));
        // the key goes with the last note
        expect(level.file()).toEqual(before);
        while (level.undo());
        expect(level.file()).toEqual(before);
      }),
      { numRuns: 40 },
    );
  });

  it('leave what another program has written as it is', () => {
    const foreign = (value: unknown) =>
      createEditedLevel({
        version: 1,
        name: 'X',
        astronaut: { x: 0, y: 0 },
        blackHole: { x: 9, y: 0 },
        'x-notes': value,
      } as LevelFile);
    for (const value of ['text', 3, ['a'], null, true]) {
      const level = foreign(value);
      expect(pinnedNotesIn(level.file())).toEqual([]);
      expect(pinProblem(level.file())).toContain('another program');
      level.change('Add', pinNote(1, 2, 'hello'));
      expect((level.file() as unknown as Record<string, unknown>)['x-notes']).toEqual(value);
    }
    const mixed = {
      mine: { x: 1, y: 2, text: 'hi', by: 'Ann' },
      other: { x: 'far' },
      long: { x: 0, y: 0, text: 'x'.repeat(501) },
    };
    const level = foreign(mixed);
    expect(pinnedNotesIn(level.file())).toEqual([{ id: 'mine', x: 1, y: 2, text: 'hi' }]);
    level.change('Edit', editPinnedNote('mine', { text: 'ho' }));
    level.change('Edit', editPinnedNote('other', { text: 'ho' }));
    level.change('Delete', unpinNote('long'));
    expect((level.file() as unknown as Record<string, unknown>)['x-notes']).toEqual({
      ...mixed,
      mine: { ...mixed.mine, text: 'ho' },
    });
  });
});
