import { mkdirSync, readdirSync, readFileSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { contentKey, keyOf, openStore, type Store } from '../../cli/cache/index.ts';
import { makeFiles } from './gq.ts';

const { directory, remove } = makeFiles({});
afterAll(remove);

let made = 0;
const newFolder = (): string => join(directory, String(made++));

const key = (n: number): string => keyOf(n);
const text = fc.oneof(
  fc.json(),
  fc.string({ unit: 'binary' }).map((s) => JSON.stringify(s)),
);

async function filled(folder: string, texts: ReadonlyMap<string, string>): Promise<Store> {
  const store = openStore(folder);
  for (const [at, value] of texts) store.put(at, value);
  await store.save();
  return store;
}

describe('a key', () => {
  it('is the same for the same data in any order of keys, and another one for other data', () => {
    const value = fc.letrec((tie) => ({
      any: fc.oneof(
        { maxDepth: 3 },
        fc.double(),
        fc.string(),
        fc.boolean(),
        fc.constantFrom(null, undefined),
        tie('list'),
        tie('object'),
      ),
      list: fc.array(tie('any'), { maxLength: 3 }),
      object: fc.dictionary(fc.string({ maxLength: 2 }), tie('any'), { maxKeys: 3, noNullPrototype: true }),
    })).any;
    const turned = (data: unknown): unknown =>
      Array.isArray(data)
        ? data.map(turned)
        : typeof data === 'object' && data !== null
          ? Object.fromEntries(
              Object.entries(data)
                .reverse()
                .map(([k, v]) => [k, turned(v)]),
            )
          : data;
    const same = (a: unknown, b: unknown): boolean => {
      try {
        expect(a).toStrictEqual(b);
        return true;
      } catch {
        return false;
      }
    };
    fc.assert(
      fc.property(value, value, (a, b) => {
        expect(keyOf(turned(a))).toBe(keyOf(a));
        expect(keyOf(a) === keyOf(b)).toBe(same(a, b));
      }),
    );
    const alike = [
      0,
      -0,
      null,
      undefined,
      'null',
      '0',
      Number.NaN,
      Number.POSITIVE_INFINITY,
      [],
      {},
      [[]],
      [null],
      { a: undefined },
    ];
    expect(new Set(alike.map(keyOf)).size).toBe(alike.length);
    expect(() => keyOf(() => 0)).toThrow('expected plain data');
  });

  it('of a content depends on the content, and on the key of everything else', () => {
    const bytes = [new Uint8Array(), new Uint8Array([1]), new Uint8Array([1, 0])];
    expect(new Set([key(1), key(2)].flatMap((other) => bytes.map((b) => contentKey(other, b)))).size).toBe(6);
  });
});

describe('a store', () => {
  it('gives back what was put, in later processes and together with what was there', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(text, { minLength: 1, maxLength: 40 }), fc.nat(40), async (texts, cut) => {
        const folder = newFolder();
        const all = new Map(texts.map((value, i) => [key(i), value]));
        await filled(folder, new Map([...all].slice(0, cut)));
        await filled(folder, new Map([...all].slice(cut)));
        const store = openStore(folder);
        for (const [at, value] of all) expect(store.get(at)).toBe(value);
        expect(store.get(key(-1))).toBeNull();
        expect(store.isEmpty()).toBe(false);
      }),
      { numRuns: 20 },
    );
  });

  it('never gives a text that was not put, whatever has happened to its bytes', async () => {
    const texts = new Map(Array.from({ length: 30 }, (_, i) => [key(i), JSON.stringify({ i, text: 'x'.repeat(5 * i) })]));
    const folder = newFolder();
    await filled(folder, texts);
    const names = readdirSync(folder).filter((name) => name.startsWith('check-'));
    const whole = new Map(names.map((name) => [name, readFileSync(join(folder, name))]));
    const damage = fc.oneof(
      fc.record({ kind: fc.constant('flip'), at: fc.nat(), with: fc.integer({ min: 1, max: 255 }) }),
      fc.record({ kind: fc.constantFrom('cut', 'drop', 'double', 'swap'), at: fc.nat(), with: fc.nat(200) }),
      fc.record({ kind: fc.constantFrom('empty', 'other shard', 'noise'), at: fc.nat(), with: fc.nat() }),
    );
    fc.assert(
      fc.property(fc.array(fc.tuple(fc.constantFrom(...names), damage), { minLength: 1, maxLength: 4 }), (damages) => {
        const now = new Map(whole);
        for (const [name, { kind, at, with: amount }] of damages) {
          const bytes = Buffer.from(now.get(name)!);
          const place = bytes.length === 0 ? 0 : at % bytes.length;
          const [before, after] = [bytes.subarray(0, place), bytes.subarray(place)];
          const changed: Record<string, () => Uint8Array> = {
            flip: () => Buffer.concat([before, [bytes[place] ^ amount], after.subarray(1)].map((part) => Buffer.from(part))),
            cut: () => before,
            drop: () => Buffer.concat([before, after.subarray(amount)]),
            double: () => Buffer.concat([before, after.subarray(0, amount), after]),
            swap: () => Buffer.concat([after, before]),
            empty: () => Buffer.alloc(0),
            'other shard': () => whole.get(names[amount % names.length])!,
            noise: () => Buffer.from(Array.from({ length: 300 }, (_, i) => (i * i * amount) % 256)),
          };
          now.set(name, Buffer.from(changed[kind]()));
        }
        for (const name of new Set(damages.map(([name]) => name))) writeFileSync(join(folder, name), now.get(name)!);
        const store = openStore(folder);
        expect([...texts].filter(([at, value]) => ![value, null].includes(store.get(at)))).toEqual([]);
        for (const [name] of damages) writeFileSync(join(folder, name), whole.get(name)!);
      }),
      { numRuns: 150 },
    );
  });

  it('does not give a record under another key, even of the same shard', async () => {
    const folder = newFolder();
    const [mine, other] = ['a'.repeat(64), `a${'b'.repeat(63)}`];
    await filled(folder, new Map([[mine, '"mine"']]));
    const path = join(folder, 'check-a');
    writeFileSync(path, readFileSync(path, 'utf8').replace(mine, other));
    expect(openStore(folder).get(other)).toBeNull();
    // and makes the record anew in the same place
    await filled(folder, new Map([[other, '"other"']]));
    expect(openStore(folder).get(other)).toBe('"other"');
    expect(openStore(folder).get(mine)).toBeNull();
  });

  it('loses only the damaged record', async () => {
    const folder = newFolder();
    const keys = Array.from({ length: 3 }, (_, i) => `c${String(i).repeat(63)}`);
    await filled(folder, new Map(keys.map((k, i) => [k, `"text ${i}"`])));
    const path = join(folder, 'check-c');
    writeFileSync(path, readFileSync(path, 'utf8').replace('text 1', 'text 0'));
    const store = openStore(folder);
    expect(keys.map((k) => store.get(k))).toEqual(['"text 0"', null, '"text 2"']);
  });

  it('works without a folder, without records, and with something else in their place', async () => {
    const folder = newFolder();
    const records = new Map([[key(1), '1']]);
    const [digit] = key(1);
    expect(openStore(folder).isEmpty()).toBe(true);
    mkdirSync(join(folder, `check-${digit}`), { recursive: true });
    expect(openStore(folder).isEmpty()).toBe(true);
    // an empty folder gives way
    expect((await filled(folder, records)).get(key(1))).toBe('1');
    expect(openStore(folder).get(key(1))).toBe('1');

    const full = newFolder();
    mkdirSync(join(full, `check-${digit}`, 'kept'), { recursive: true });
    await filled(full, records);
    expect(openStore(full).get(key(1))).toBeNull();
    expect(readdirSync(join(full, `check-${digit}`))).toEqual(['kept']);

    const file = newFolder();
    writeFileSync(file, 'a file');
    await filled(file, records);
    await filled(join(file, 'below'), records);
    expect(readFileSync(file, 'utf8')).toBe('a file');
  });

  it('stays within its size: records that were used last stay, the others go', async () => {
    const folder = newFolder();
    const keys = Array.from({ length: 100 }, (_, i) => `d${String(i).padStart(63, '0')}`);
    const size = 10_000;
    for (const [i, at] of keys.entries()) {
      const store = openStore(folder, size);
      // the first one is used in every run
      if (i > 0) expect(store.get(keys[0])).toBe('"0"'.padEnd(500));
      store.put(at, `"${i}"`.padEnd(500));
      await store.save();
      expect(statSync(join(folder, 'check-d')).size).toBeLessThan(size + 1000);
    }
    const store = openStore(folder, size);
    const kept = keys.filter((at) => store.get(at) !== null);
    expect(kept).toEqual([keys[0], ...keys.slice(-kept.length + 1)]);
    expect(kept.length).toBeGreaterThan(10);
    // what one run has used stays together, whatever its size
    const all = openStore(folder, size);
    for (const at of keys) all.put(at, '"x"'.padEnd(500));
    await all.save();
    expect(keys.every((at) => openStore(folder, size).get(at) !== null)).toBe(true);
  });

  it('keeps no text that is too long for it', async () => {
    const folder = newFolder();
    await filled(folder, new Map([[key(1), `"${'x'.repeat(2 ** 20)}"`]]));
    expect(openStore(folder).isEmpty()).toBe(true);
  });

  it('marks its folder, and removes what killed processes have left there long ago', async () => {
    const folder = newFolder();
    await filled(folder, new Map([[key(1), '1']]));
    expect(readFileSync(join(folder, '.gitignore'), 'utf8')).toBe('*\n');
    expect(readFileSync(join(folder, 'CACHEDIR.TAG'), 'utf8')).toMatch(/^Signature: 8a477f597d28d172789f06886806bc55\n/);
    const [old, young] = ['0', '1'].map((digit) => `.gq-edit-${digit.repeat(16)}.tmp`);
    for (const name of [old, young, 'foreign']) writeFileSync(join(folder, name), '');
    for (const name of [old, 'foreign']) utimesSync(join(folder, name), 1, 1);
    await filled(folder, new Map([[key(2), '2']]));
    const left = readdirSync(folder);
    expect(left).not.toContain(old);
    expect(left).toEqual(expect.arrayContaining([young, 'foreign']));
  });
});
