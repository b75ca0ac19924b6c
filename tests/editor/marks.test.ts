import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { packedLevel } from '../../check/pack/index.ts';
import {
  copyObjects,
  createEditedLevel,
  createSelection,
  deleteObjects,
  duplicateObjects,
  enteredGroup,
  freeGroupName,
  grabbableIn,
  groupsIn,
  hiddenIn,
  lockedIn,
  MARK_KEYS,
  type Mark,
  marksOf,
  objectsOf,
  pasteObjects,
  readClipping,
  renameGroup,
  setMark,
  unitOf,
  unlocked,
  visibleIn,
  withGroups,
} from '../../editor/core/document/index.ts';
import { createProver } from '../../editor/core/proof/index.ts';
import { ACCURACIES, compile, DEFAULT_TERMS, simulate } from '../../engine/index.ts';
import { levelHash } from '../../game/index.ts';
import { formatLevel, type LevelFile, readLevel, resolveLevel } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

/** What may stand under the key of a mark: a mark, or a value of another program. */
const value = fc.oneof(
  fc.constantFrom<unknown>(true, false, null, 0, '', ' ', 'Gate', 'ring', 'x'.repeat(60), 'x'.repeat(61)),
  fc.record({ by: fc.string() }),
  fc.array(fc.integer(), { maxLength: 2 }),
);
const marks = fc.dictionary(fc.constantFrom(...Object.values(MARK_KEYS)), value, { maxKeys: 4 });

/** A file with something under the keys of marks, and the same file without. */
const markedFile = fc.tuple(arbitraryFile, fc.array(marks, { minLength: 12, maxLength: 12 })).map(([file, all]) => {
  let next = 0;
  const mark = (object: object) => ({ ...object, ...all[next++ % all.length] });
  const lists = Object.entries(file).map(([key, list]) => [
    key,
    Array.isArray(list) && key !== 'runs' ? list.map((object) => mark(object as object)) : list,
  ]);
  const marked = { ...Object.fromEntries(lists), astronaut: mark(file.astronaut), blackHole: mark(file.blackHole) };
  return { file, marked: marked as LevelFile };
});

const ring = (): LevelFile => {
  const file = {
    version: 1 as const,
    name: 'Ring',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 400, y: 0 },
    asteroids: [
      { id: 'aa', x: 100, y: 0, radius: 16, 'x-group': 'ring' },
      { id: 'bb', x: 200, y: 0, radius: 16, 'x-group': 'ring', 'x-locked': true },
      { id: 'cc', x: 300, y: 0, radius: 16, 'x-group': 'ring' },
      { id: 'dd', x: 350, y: 90, radius: 16, 'x-hidden': true },
    ],
    novae: [{ id: 'ee', x: 0, y: 300, radius: 16, 'x-group': { by: 'another' } }],
  };
  // keys of other programs are not part of the type
  return file as LevelFile;
};

describe('marks of objects', () => {
  it('change neither the hash for plays, nor what is proved, nor packs', () => {
    fc.assert(
      fc.property(markedFile, ({ file, marked }) => {
        const reading = readLevel(formatLevel(marked));
        expect(reading.ok).toBe(true);
        expect(levelHash(resolveLevel(marked))).toBe(levelHash(resolveLevel(file)));
        const options = { rules: {}, withRuns: true, found: null };
        expect(packedLevel(marked, options)).toEqual(packedLevel(file, options));
        expect(JSON.stringify(packedLevel(marked, options))).not.toContain('"x-');
      }),
      { numRuns: 40 },
    );
  });

  it('change nothing of a run or of what is said of it: what is hidden is met all the same', () => {
    const [without, nova] = [
      { ...ring(), novae: [] },
      { ...ring(), novae: [{ id: 'ee', x: 60, y: 0, radius: 16 }] },
    ];
    const hidden = { ...nova, novae: [{ ...nova.novae[0], 'x-hidden': true, 'x-name': 'Gate', 'x-locked': true }] };
    const run = { runs: [{ name: 'solution', holds: [[0, 600]] as [number, number][] }] };
    const proofOf = (file: object) =>
      createProver().prove({ file: createEditedLevel({ ...file, ...run } as LevelFile).file(), run: null, terms: DEFAULT_TERMS });
    const hashOf = (file: object) =>
      simulate(compile(resolveLevel({ ...file, ...run } as LevelFile), ACCURACIES.precise), run.runs[0].holds).hash;
    const [seen, unseen, free] = [nova, hidden, without].map(proofOf);
    expect(unseen.verdict).toEqual(seen.verdict);
    expect(unseen.problems).toEqual(seen.problems);
    expect(hashOf(hidden)).toBe(hashOf(nova));
    // and the nova matters: she dies of it
    expect(free.verdict).not.toEqual(seen.verdict);
    expect(hashOf(without)).not.toBe(hashOf(nova));
  });

  it('count only in their own form, and values of other programs stay whatever is set', () => {
    fc.assert(
      fc.property(
        markedFile,
        fc.constantFrom<Mark>('name', 'isLocked', 'isHidden', 'group'),
        fc.boolean(),
        ({ marked }, mark, on) => {
          const level = createEditedLevel(marked);
          const before = objectsOf(level.file());
          for (const found of before.values()) {
            const { name, isLocked, isHidden, group } = marksOf(found);
            const raw = found.object as unknown as Record<string, unknown>;
            expect(name === null || (name === raw['x-name'] && name.trim() !== '' && name.length <= 60)).toBe(true);
            expect(group === null || group === raw['x-group']).toBe(true);
            expect([isLocked, isHidden]).toEqual([
              raw['x-locked'] === true,
              raw['x-hidden'] === true && found.kind !== 'astronaut',
            ]);
          }
          const wanted = mark === 'name' || mark === 'group' ? (on ? 'new' : null) : on;
          level.change('mark', setMark(before.keys(), mark, wanted as never));
          for (const [key, { object }] of before) {
            const raw = (object as unknown as Record<string, unknown>)[MARK_KEYS[mark]];
            const now = ({ ...objectsOf(level.file()).get(key)?.object } as Record<string, unknown>)[MARK_KEYS[mark]];
            const isText = typeof raw === 'string' && raw.trim() !== '' && raw.length <= 60;
            const isOurs = raw === undefined || (mark === 'name' || mark === 'group' ? isText : raw === true);
            const isNever = mark === 'isHidden' && key === '@astronaut';
            if (!isOurs || isNever) expect(now).toEqual(raw);
            else expect(now).toEqual(on ? wanted : undefined);
          }
          level.undo();
          expect(level.file()).toEqual(createEditedLevel(marked).file());
        },
      ),
      { numRuns: 60 },
    );
  });

  it('keep locked and hidden objects from the canvas, and a text of blanks removes a name', () => {
    const level = createEditedLevel(ring());
    const file = level.file();
    expect([...lockedIn(file)]).toEqual(['bb']);
    expect([...hiddenIn(file)]).toEqual(['dd']);
    expect([...visibleIn(file).keys()]).toEqual(['@astronaut', '@blackHole', 'aa', 'bb', 'cc', 'ee']);
    expect([...grabbableIn(file).keys()]).toEqual(['@astronaut', '@blackHole', 'aa', 'cc', 'ee']);
    expect(unlocked(file, ['aa', 'bb', 'dd'])).toEqual(['aa', 'dd']);
    const selection = createSelection(level);
    selection.selectAll();
    expect(selection.keys()).toEqual(['@astronaut', '@blackHole', 'aa', 'cc', 'ee']);
    level.change('name', setMark(['aa'], 'name', 'Gate'));
    level.change('name', setMark(['aa'], 'name', '  '));
    expect(level.file().asteroids?.[0]).toEqual(ring().asteroids?.[0]);
    selection.close();
  });
});

describe('groups', () => {
  it('are selected as a whole, without what is locked, until the user works inside', () => {
    const file = ring();
    expect(unitOf(file, 'aa', [])).toEqual(['aa', 'cc']);
    expect(unitOf(file, 'ee', [])).toEqual(['ee']);
    expect(enteredGroup(file, ['aa', 'cc'])).toBe(null);
    expect(enteredGroup(file, ['aa'])).toBe('ring');
    expect(enteredGroup(file, ['aa', 'dd'])).toBe(null);
    expect(enteredGroup(file, [])).toBe(null);
    // inside, a click selects another member alone
    expect(unitOf(file, 'cc', ['aa'])).toEqual(['cc']);
    expect(withGroups(file, ['cc', 'dd'])).toEqual(['aa', 'cc', 'dd']);
  });

  it('have names of their own: copies of a whole group form a group, copies of a part stay in it', () => {
    const level = createEditedLevel(ring());
    const copy = level.change('Duplicate', duplicateObjects(['aa', 'bb', 'cc', 'dd'], 0, 50));
    expect([...groupsIn(level.file())].map(([name, keys]) => [name, keys.length])).toEqual([
      ['ring', 3],
      ['ring 2', 3],
    ]);
    // copies are neither locked nor hidden
    expect([lockedIn(level.file()).size, hiddenIn(level.file()).size]).toEqual([1, 1]);
    level.change('Duplicate', duplicateObjects(['aa'], 0, 90));
    expect(groupsIn(level.file()).get('ring')).toHaveLength(4);
    if (!copy.ok) throw new Error('refused');
    const reading = readClipping(copyObjects(level.file(), copy.added) ?? '');
    if (!reading.ok) throw new Error('not read');
    level.change('Paste', pasteObjects(reading.clipping));
    expect(groupsIn(level.file()).get('ring 3')).toHaveLength(3);
    // in a level without such a group the name stays
    level.change(
      'Delete',
      deleteObjects([...(groupsIn(level.file()).get('ring 2') ?? []), ...(groupsIn(level.file()).get('ring 3') ?? [])]),
    );
    level.change('Paste', pasteObjects(reading.clipping));
    expect(groupsIn(level.file()).get('ring 2')).toHaveLength(3);
    level.change('Rename', renameGroup(level.file(), 'ring 2', 'arc'));
    expect([...groupsIn(level.file()).keys()]).toEqual(['ring', 'arc']);
  });

  it('find free names, however long the wanted one is', () => {
    const long = 'g'.repeat(60);
    const file = { ...ring(), asteroids: [{ id: 'aa', x: 0, y: 0, radius: 16, 'x-group': long } as never] };
    const name = freeGroupName(file, long);
    expect(name).not.toBe(long);
    expect(name.length).toBeLessThanOrEqual(60);
    expect(freeGroupName(ring(), 'ring', new Set(['ring 2', 'ring 3']))).toBe('ring 4');
    expect(freeGroupName(ring(), 'arc')).toBe('arc');
  });
});
