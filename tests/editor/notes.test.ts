import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { packedLevel } from '../../check/pack/index.ts';
import { addNote, createEditedLevel, deleteNote, editNote, noteProblem, notesIn } from '../../editor/document/index.ts';
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
        for (const [x, y, words] of wanted) level.change('Add', addNote(x, y, words));
        expect(notesIn(level.file()).map(({ x, y, text: words }) => [x, y, words])).toEqual(wanted);
        expect(new Set(notesIn(level.file()).map(({ id }) => id)).size).toBe(wanted.length);
        expect(levelHash(resolveLevel(level.file()))).toBe(levelHash(resolveLevel(before)));
        const options = { rules: {}, withRuns: true, found: null };
        expect(packedLevel(level.file(), options)).toEqual(packedLevel(before, options));
        const [{ id }] = notesIn(level.file());
        level.change('Move', editNote(id, { x: 7, y: 8 }));
        level.change('Edit', editNote(id, { text: 'new' }));
        expect(notesIn(level.file())[0]).toEqual({ id, x: 7, y: 8, text: 'new' });
        for (const note of notesIn(level.file())) level.change('Delete', deleteNote(note.id));
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
      expect(notesIn(level.file())).toEqual([]);
      expect(noteProblem(level.file())).toContain('another program');
      level.change('Add', addNote(1, 2, 'hello'));
      expect((level.file() as unknown as Record<string, unknown>)['x-notes']).toEqual(value);
    }
    const mixed = {
      mine: { x: 1, y: 2, text: 'hi', by: 'Ann' },
      other: { x: 'far' },
      long: { x: 0, y: 0, text: 'x'.repeat(501) },
    };
    const level = foreign(mixed);
    expect(notesIn(level.file())).toEqual([{ id: 'mine', x: 1, y: 2, text: 'hi' }]);
    level.change('Edit', editNote('mine', { text: 'ho' }));
    level.change('Edit', editNote('other', { text: 'ho' }));
    level.change('Delete', deleteNote('long'));
    expect((level.file() as unknown as Record<string, unknown>)['x-notes']).toEqual({
      ...mixed,
      mine: { ...mixed.mine, text: 'ho' },
    });
  });
});
