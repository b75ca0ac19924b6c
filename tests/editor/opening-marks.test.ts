import { describe, expect, it } from 'vitest';
import { createOpeningMarks } from '../../editor/files/opening-marks.ts';

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
    for (const junk of ['', '{', '{"a":1}', 'null', '[1, null, "x"]']) {
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

  it('stay few', () => {
    const { storage, kept } = keeper();
    for (let i = 0; i < 1000; i++) createOpeningMarks(storage).set(`level ${i}`);
    expect(kept.get('gravity-quest-editor-opening')?.length).toBeLessThan(2000);
    expect(createOpeningMarks(storage).has('level 999')).toBe(true);
    expect(createOpeningMarks(storage).has('level 950')).toBe(true);
    expect(createOpeningMarks(storage).has('level 949')).toBe(false);
    // marking one level again and again removes no other mark
    for (let i = 0; i < 100; i++) createOpeningMarks(storage).set('level 999');
    expect(createOpeningMarks(storage).has('level 950')).toBe(true);
  });
});
