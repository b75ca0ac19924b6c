import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Best, createPack, type PackStorage } from '../../game/index.ts';
import { pack as shippedPack } from '../levels/shipped-pack.ts';

const levels = shippedPack.slice(0, 5).map(({ slug, level }) => ({ id: slug, level }));
const ids = levels.map(({ id }) => id);
const KEY = 'gravity-quest-progress';

/** A storage that may refuse. */
function storageOf(texts: Record<string, string> = {}) {
  const items = new Map(Object.entries(texts));
  const refuses = { getItem: false, setItem: false };
  return {
    items,
    refuses,
    getItem(key: string): string | null {
      if (refuses.getItem) throw new DOMException('The operation is insecure.', 'SecurityError');
      return items.get(key) ?? null;
    },
    setItem(key: string, value: string): void {
      if (refuses.setItem) throw new DOMException('The quota has been exceeded.', 'QuotaExceededError');
      items.set(key, value);
    },
  };
}

const best = (tick: number, minerals: number, play: string | null = null): Best => ({ tick, minerals, play });
const order = ({ tick, minerals }: Best) => minerals * 1e6 - tick;

const arbitraryBest = fc.record({
  tick: fc.nat(5000),
  minerals: fc.nat(3),
  play: fc.option(fc.string({ maxLength: 8 })),
});

describe('a pack', () => {
  it('unlocks a level with the one before it, and knows what is next', () => {
    const pack = createPack(levels, storageOf());
    const unlocked = () => ids.filter((id) => pack.isUnlocked(id));
    expect([unlocked(), pack.next()]).toEqual([[ids[0]], ids[0]]);
    expect(pack.record(ids[0], best(300, 1))).toBe(true);
    expect([unlocked(), pack.next(), pack.next(ids[0]), pack.next(ids[4])]).toEqual([ids.slice(0, 2), ids[1], ids[1], null]);
    // a level that was reached by a link
    pack.record(ids[3], best(300, 1));
    expect([unlocked(), pack.next()]).toEqual([[ids[0], ids[1], ids[3], ids[4]], ids[1]]);
    for (const id of ids) pack.record(id, best(1, 0));
    expect([unlocked(), pack.next()]).toEqual([ids, null]);
  });

  it('keeps the play with most minerals, and of these the shortest, for the next page, too', () => {
    fc.assert(
      fc.property(fc.array(fc.tuple(fc.constantFrom(...ids), arbitraryBest), { maxLength: 30 }), (plays) => {
        const storage = storageOf();
        const pack = createPack(levels, storage);
        const kept = new Map<string, Best>();
        for (const [id, play] of plays) {
          const old = kept.get(id);
          const isBest = old === undefined || order(play) > order(old);
          if (isBest) kept.set(id, play);
          expect(pack.record(id, play)).toBe(isBest);
        }
        for (const one of [pack, createPack(levels, storage)]) {
          expect(ids.map((id) => one.best(id))).toEqual(ids.map((id) => kept.get(id) ?? null));
          expect(one.trouble).toBeNull();
        }
      }),
    );
  });

  it('loses nothing to another tab, nor to a page with other levels', () => {
    const play = fc.tuple(fc.nat(2), fc.constantFrom(...ids), arbitraryBest);
    fc.assert(
      fc.property(fc.array(play, { maxLength: 30 }), (plays) => {
        const storage = storageOf();
        // the third one has the levels in another order and lacks two
        const tabs = [levels, levels, levels.slice(0, 3).reverse()].map((of) => createPack(of, storage));
        const kept = new Map<string, Best>();
        for (const [tab, id, one] of plays) {
          if (!tabs[tab].levels.some((level) => level.id === id)) continue;
          tabs[tab].record(id, one);
          const old = kept.get(id);
          if (old === undefined || order(one) > order(old)) kept.set(id, one);
        }
        const later = createPack(levels, storage);
        for (const id of ids) {
          const [now, expected] = [later.best(id), kept.get(id)];
          expect(now === null ? null : order(now)).toBe(expected === undefined ? null : order(expected));
        }
      }),
    );
  });

  it('keeps aside what is not progress, in part or at all, and goes on', () => {
    const good = { tick: 10, minerals: 1, play: 'abc' };
    const odd = fc.oneof(
      fc.string(),
      fc.json(),
      fc.constantFrom('', 'null', '[]', '{}', '{"version":1}', '{"version":2,"levels":{}}', '{"version":1,"levels":[]}'),
      fc
        .constantFrom<unknown>(null, 1, {}, { tick: -1, minerals: 0, play: null }, { tick: 1.5, minerals: 0, play: null })
        .map((entry) => JSON.stringify({ version: 1, levels: { [ids[0]]: good, [ids[1]]: entry } })),
    );
    fc.assert(
      fc.property(odd, odd, (first, second) => {
        const storage = storageOf({ [KEY]: first });
        const kept = () => [...storage.items].filter(([key]) => key !== KEY).map(([, text]) => text);
        const pack = createPack(levels, storage);
        expect(pack.record(ids[2], best(7, 0))).toBe(true);
        expect(kept()).toEqual([first]);
        // something else writes there while the page is open
        storage.items.set(KEY, second);
        pack.record(ids[3], best(7, 0));
        expect(new Set(kept())).toEqual(new Set([first, second]));
        const later = createPack(levels, storage);
        expect([later.best(ids[2]), later.best(ids[3])]).toEqual([best(7, 0), best(7, 0)]);
        if (first.includes('abc')) expect(later.best(ids[0])).toEqual(good);
      }),
    );
  });

  it('takes no harm from ids that objects have by themselves', () => {
    const storage = storageOf();
    const strange = ['__proto__', 'constructor', 'toString'].map((id, i) => ({ id, level: levels[i].level }));
    const pack = createPack(strange, storage);
    expect(strange.map(({ id }) => pack.best(id))).toEqual([null, null, null]);
    for (const { id } of strange) pack.record(id, best(5, 2));
    const later = createPack(strange, storage);
    expect(strange.map(({ id }) => later.best(id))).toEqual([best(5, 2), best(5, 2), best(5, 2)]);
  });
});

describe('a pack without a storage that works', () => {
  it.each<[string, PackStorage | null, RegExp | null]>([
    ['none', null, null],
    [
      'one that is full',
      Object.assign(storageOf(), { refuses: null, setItem: () => expect.unreachable('full') }),
      /takes nothing more: .*full/,
    ],
    [
      'one that refuses',
      Object.assign(storageOf(), { getItem: () => expect.unreachable('insecure') }),
      /can't be read.*insecure/,
    ],
  ])('%s: it is played all the same, and says what is wrong', (_, storage, trouble) => {
    const pack = createPack(levels, storage);
    expect(pack.record(ids[0], best(10, 1))).toBe(true);
    expect(pack.record(ids[0], best(11, 1))).toBe(false);
    expect([pack.best(ids[0]), pack.isUnlocked(ids[1])]).toEqual([best(10, 1), true]);
    if (trouble === null) expect(pack.trouble).toBeNull();
    else expect(pack.trouble).toMatch(trouble);
  });

  it('overwrites nothing that it could not keep aside', () => {
    const storage = storageOf({ [KEY]: 'somebody’s' });
    storage.refuses.setItem = true;
    const pack = createPack(levels, storage);
    pack.record(ids[0], best(10, 1));
    storage.refuses.setItem = false;
    expect(storage.items.get(KEY)).toBe('somebody’s');
    pack.record(ids[1], best(10, 1));
    expect([...storage.items.values()]).toContain('somebody’s');
    expect(createPack(levels, storage).best(ids[0])).toEqual(best(10, 1));
    expect(pack.trouble).toBeNull();
  });

  it('is full of what others wrote, and says so', () => {
    const storage = storageOf();
    const pack = createPack(levels, storage);
    for (let i = 0; i < 25; i++) {
      storage.items.set(KEY, `no progress ${i}`);
      pack.record(ids[0], best(100 - i, 0));
    }
    expect(pack.trouble).toMatch(/time and again/);
    expect(storage.items.get(KEY)).toBe('no progress 24');
    expect(pack.best(ids[0])).toEqual(best(76, 0));
  });
});

describe('bad input of a pack', () => {
  it('two levels of one id, and an id of no level, are named', () => {
    expect(() => createPack([levels[0], levels[1], levels[0]])).toThrow(/found "01-first-pull" for levels 1 and 3/);
    const pack = createPack(levels);
    for (const call of [
      () => pack.best('x'),
      () => pack.isUnlocked('x'),
      () => pack.next('x'),
      () => pack.record('x', best(1, 1)),
    ]) {
      expect(call).toThrow(/expected the id of a level in this pack, found "x"/);
    }
  });

  it.each([best(-1, 0), best(1.5, 0), best(1, Number.NaN), { tick: 1, minerals: 1 } as Best])(
    'a play like %j is refused',
    (play) => {
      expect(() => createPack(levels).record(ids[0], play)).toThrow(/expected the tick/);
    },
  );

  it('no levels are an empty pack', () => {
    expect([createPack([]).next(), createPack([]).levels]).toEqual([null, []]);
  });
});
