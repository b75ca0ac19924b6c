import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { copyId, copyName } from '../../editor/core/levels/level-files.ts';
import { LEVEL_ID_PART } from '../../schema/index.ts';

const entries = (...ids: readonly string[]) => ids.map((id) => ({ id }));
const names = (...all: readonly string[]) => all.map((name) => ({ name }));

describe('a copy of a level', () => {
  it('gets a file name with a new number if the name of the level has one', () => {
    expect(copyId(entries('01-pull', '02-swing'), '01-pull')).toBe('03-pull-copy');
    expect(copyId(entries('01-pull', '02-swing', '03-pull-copy'), '03-pull-copy')).toBe('04-pull-copy');
    expect(copyId(entries('w/09 pull', 'w/swing', '12-a'), 'w/09 pull')).toBe('w/10 pull-copy');
    expect(copyId(entries('pull', '02-swing'), 'pull')).toBe('pull-copy');
    expect(copyId(entries('pull', 'PULL-copy'), 'pull')).toBe('pull-copy-2');
  });

  it('gets a unique name', () => {
    expect(copyName(names('Pull'), 'Pull')).toBe('Pull copy');
    expect(copyName(names('Pull', 'Pull copy'), 'Pull copy')).toBe('Pull copy 2');
    expect(copyName(names('a'.repeat(120)), 'a'.repeat(120))).toBe(`${'a'.repeat(115)} copy`);
  });

  it('gets both names for any level', () => {
    const stem = fc.stringMatching(/^\d{0,3}[- ]?[a-z0-9][a-z0-9 _-]{0,70}[a-z0-9]$/);
    fc.assert(
      fc.property(fc.array(stem, { minLength: 1, maxLength: 6 }), (stems) => {
        const levels = stems.filter((one) => LEVEL_ID_PART.test(one)).map((id) => ({ id, name: id }));
        for (const { id, name } of levels) {
          const copied = copyId(levels, id);
          expect(copied).toMatch(LEVEL_ID_PART);
          expect(levels.map((level) => level.id)).not.toContain(copied);
          expect(levels.map((level) => level.name)).not.toContain(copyName(levels, name));
        }
      }),
    );
  });
});
