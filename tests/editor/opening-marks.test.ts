import { describe, expect, it } from 'vitest';
import { createOpeningMarks as createMarks, tabName } from '../../editor/core/files/opening-marks.ts';

/** Marks of the pages of one tab, one after the other. */
const createOpeningMarks = (storage: Parameters<typeof createMarks>[0]) => createMarks(storage, 'tab');

function keeper() {
  const kept = new Map<string, string>();
  return {
    kept,
    storage: {
      getItem: (name: string) => kept.get(name) ?? null,
      setItem: (name: string, value: string) => void kept.set(name, value),
    },
  };
}

describe('marks of levels that are being opened', () => {
  it('tell the next page which level made the previous one hang', () => {
    const { storage } = keeper();
    const hung = createOpeningMarks(storage);
    hung.set('folder/07');
    hung.set('folder/08');
    hung.clear('folder/08');
    // the page's own mark does not count
    expect(hung.has('folder/07')).toBe(false);
    const next = createOpeningMarks(storage);
    expect(next.has('folder/07')).toBe(true);
    expect(next.has('folder/08')).toBe(false);
    next.set('folder/07');
    next.clear('folder/07');
    expect(createOpeningMarks(storage).has('folder/07')).toBe(false);
  });

  it('are removed if a page is left while it opens a level, but not those of other pages', () => {
    const { storage } = keeper();
    createOpeningMarks(storage).set('folder/01');
    const left = createOpeningMarks(storage);
    left.set('folder/02');
    left.leave();
    const next = createOpeningMarks(storage);
    expect([next.has('folder/01'), next.has('folder/02')]).toEqual([true, false]);
  });

  it('are ignored if nothing or something else is stored', () => {
    const { storage, kept } = keeper();
    for (const junk of ['', '{', '{"a":1}', 'null', '[1, null, "x"]', '[{"place":"a"}]', '[{"place":"a","tab":1,"at":0}]']) {
      kept.set('gravity-quest-editor-opening', junk);
      const marks = createOpeningMarks(storage);
      expect(marks.has('a')).toBe(false);
      marks.set('a');
      expect(createOpeningMarks(storage).has('a')).toBe(true);
    }
    const full = createOpeningMarks({
      getItem: () => null,
      setItem() {
        throw new DOMException('full', 'QuotaExceededError');
      },
    });
    full.set('a');
    full.clear('a');
    expect(createOpeningMarks(null).has('a')).toBe(false);
  });

  it('of another tab that is just opening the level do not count, unless that takes so long that it hangs', () => {
    const { storage } = keeper();
    let now = 1_000_000;
    const tab = (name: string) => createMarks(storage, name, () => now);
    const first = tab('first');
    first.set('folder/07');
    now += 2000;
    const second = tab('second');
    expect(second.has('folder/07')).toBe(false);
    second.set('folder/07');
    second.clear('folder/07');
    // that of the first is still there: its tab is reloaded
    expect(tab('first').has('folder/07')).toBe(true);
    now += 9000;
    expect(tab('second').has('folder/07')).toBe(true);
    // the user has decided to open it
    tab('second').clear('folder/07');
    expect(tab('first').has('folder/07')).toBe(false);
    first.set('folder/08');
    // the clock was set back
    now -= 3_600_000;
    expect(tab('second').has('folder/08')).toBe(true);
  });

  it('stored by an earlier version count', () => {
    const { storage, kept } = keeper();
    kept.set('gravity-quest-editor-opening', '["folder/07"]');
    const marks = createOpeningMarks(storage);
    expect([marks.has('folder/07'), marks.has('folder/08')]).toEqual([true, false]);
    marks.clear('folder/07');
    expect(marks.has('folder/07')).toBe(false);
  });

  it('know a tab by a name that a reload keeps', () => {
    const { storage } = keeper();
    const name = tabName(storage);
    expect(name).not.toBe('');
    expect(tabName(storage)).toBe(name);
    expect(tabName(keeper().storage)).not.toBe(name);
    expect(tabName(null)).not.toBe(tabName(null));
  });

  it('stay few', () => {
    const { storage, kept } = keeper();
    for (let i = 0; i < 1000; i++) createOpeningMarks(storage).set(`level ${i}`);
    expect(kept.get('gravity-quest-editor-opening')?.length).toBeLessThan(4000);
    expect(createOpeningMarks(storage).has('level 999')).toBe(true);
    expect(createOpeningMarks(storage).has('level 950')).toBe(true);
    expect(createOpeningMarks(storage).has('level 949')).toBe(false);
    // marking one level again and again removes no other mark
    for (let i = 0; i < 100; i++) createOpeningMarks(storage).set('level 999');
    expect(createOpeningMarks(storage).has('level 950')).toBe(true);
  });
});
