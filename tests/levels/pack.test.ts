import { describe, expect, it } from 'vitest';
import { compile, findWarnings } from '../../engine/index.ts';
import { formatLevel, OBJECT_LISTS } from '../../schema/index.ts';
import { pack } from './shipped-pack.ts';

// the files themselves: what a reader of the folder and of a diff may rely on

describe('the pack', () => {
  it('is numbered without a gap from 01', () => {
    expect(pack.length).toBeGreaterThanOrEqual(16);
    expect(pack.map((entry) => entry.slug.slice(0, 2))).toEqual(pack.map((_, i) => String(i + 1).padStart(2, '0')));
  });

  it('has no name and no slug twice', () => {
    expect(new Set(pack.map((entry) => entry.level.name)).size).toBe(pack.length);
    expect(new Set(pack.map((entry) => entry.slug.slice(3))).size).toBe(pack.length);
  });

  it('calls for every effect of the game', () => {
    const called = new Set(pack.flatMap((entry) => compile(entry.level).effects.simulated.map((effect) => effect.name)));
    const idle = new Set(pack.flatMap((entry) => compile(entry.level).effects.notCalledFor.map((effect) => effect.name)));
    expect([...idle].filter((name) => !called.has(name))).toEqual([]);
    // negative control: the first level is simple enough to do without most of them
    expect(compile(pack[0].level).effects.notCalledFor.length).toBeGreaterThan(5);
  });
});

describe.each(pack)('$slug', ({ text, file, level }) => {
  it('is in canonical layout and names its schema', () => {
    expect(text).toBe(formatLevel(file));
    expect(file.$schema).toBe('../schema/level.schema.json');
  });

  it('has an id for every object, none twice', () => {
    const ids = OBJECT_LISTS.flatMap((list) => level[list].map((object) => object.id));
    expect(ids).not.toContain(null);
    expect(new Set(ids).size).toBe(ids.length);
  });

  it('gives no warning', () => {
    expect(findWarnings(level)).toEqual([]);
  });

  it('says what it teaches, and has the runs that a player of it would expect', () => {
    expect(level.description.length).toBeGreaterThan(20);
    expect(level.runs.map((run) => run.name)).toEqual(level.minerals.length > 0 ? ['solution', 'all-minerals'] : ['solution']);
  });
});
