import { describe, expect, it } from 'vitest';
import { createEditedLevel } from '../../editor/core/document/index.ts';
import { mergeLevels, resolveConflicts, type Side, withConflicts } from '../../review/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { FILE } from './stage.ts';

const marked: LevelFile = withConflicts(
  mergeLevels(
    FILE,
    { ...FILE, name: 'ours', asteroids: [] },
    { ...FILE, name: 'theirs', asteroids: [{ id: 'aa', x: 99, y: 20, radius: 16 }] },
  ),
);

describe('a level with conflicts in the editor', () => {
  it('keeps them through every change, and can decide them in one step that can be undone', () => {
    const level = createEditedLevel(marked);
    level.change('Move', (draft) => {
      draft.blackHole.x = 400;
    });
    expect(level.file().conflicts).toEqual(marked.conflicts);
    const choices = new Map(marked.conflicts?.map(({ key }): [string, Side] => [key, 'theirs']));
    expect(level.replace('Decide conflicts', resolveConflicts(level.file(), choices)).ok).toBe(true);
    expect(level.file()).toEqual({
      ...FILE,
      name: 'theirs',
      blackHole: { x: 400, y: 0 },
      asteroids: [{ id: 'aa', x: 99, y: 20, radius: 16 }],
    });
    level.undo();
    expect(level.file()).toEqual({ ...marked, blackHole: { x: 400, y: 0 } });
  });

  it('refuses a choice that is no valid level, and stays as it is', () => {
    const level = createEditedLevel({ ...FILE, conflicts: [{ what: 'name', key: 'name', ours: 'base', theirs: 3 }] });
    const before = level.file();
    expect(level.replace('Decide conflicts', resolveConflicts(before, new Map([['name', 'theirs']]))).ok).toBe(false);
    expect(level.file()).toBe(before);
  });
});
