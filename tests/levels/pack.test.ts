import { describe, expect, it } from 'vitest';
import { compile, findWarnings } from '../../engine/index.ts';
import { formatLevel, OBJECT_LISTS } from '../../schema/index.ts';
import { pack } from './shipped-pack.ts';

// the files themselves: properties that a reader of the folder and of a diff relies on

describe('the pack', () => {
  it('is numbered without a gap from 01', () => {
    expect(pack.length).toBeGreaterThanOrEqual(16);
    expect(pack.map((entry) => entry.slug.slice(0, 2))).toEqual(pack.map((_, i) => String(i + 1).padStart(2, '0')));
  });

  it('has unique names and slugs', () => {
    expect(new Set(pack.map((entry) => entry.level.name)).size).toBe(pack.length);
    expect(new Set(pack.map((entry) => entry.slug.slice(3))).size).toBe(pack.length);
  });

  it('calls for every effect of the game', () => {
    const called = new Set(pack.flatMap((entry) => compile(entry.level).effects.simulated.map((effect) => effect.name)));
    const idle = new Set(pack.flatMap((entry) => compile(entry.level).effects.notCalledFor.map((effect) => effect.name)));
    expect([...idle].filter((name) => !called.has(name))).toEqual([]);
    // negative control: the first level does not call for most of them
    expect(compile(pack[0].level).effects.notCalledFor.length).toBeGreaterThan(5);
  });
});

describe.each(pack)('$slug', ({ text, file, level }) => {
  it('is in canonical layout and names its schema', () => {
    expect(text).toBe(formatLevel(file));
    expect(file.$schema).toBe('../schema/level.schema.json');
  });

  it('has a unique id for every object', () => {
    const ids = OBJECT_LISTS.flatMap((list) => level[list].map((object) => object.id));
    expect(ids).not.toContain(null);
    expect(new Set(ids).size).toBe(ids.length);
  });

  it('has no warnings', () => {
    expect(findWarnings(level)).toEqual([]);
  });

  it('says what it teaches, and has the expected runs', () => {
    expect(level.description.length).toBeGreaterThan(20);
    expect(level.runs.map((run) => run.name)).toEqual(level.minerals.length > 0 ? ['solution', 'all-minerals'] : ['solution']);
  });
});
