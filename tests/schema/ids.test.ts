import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { formatLevel, type LevelFile, readLevel, withIds } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const objectsOf = (file: LevelFile) =>
  [file.asteroids, file.novae, file.repulsors, file.aliens, file.minerals].flatMap((list): { id?: string }[] => list ?? []);

const rock = (x: number) => ({ x, y: 5, radius: 16 });

const level = (asteroids: LevelFile['asteroids']): LevelFile => ({
  version: 1,
  name: 'a',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 0, y: 0 },
  asteroids,
});

describe('ids', () => {
  test('are given to every object without one, and nothing else changes', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        const before = formatLevel(file);
        const named = withIds(file);
        expect(formatLevel(file)).toBe(before);
        expect(readLevel(formatLevel(named)).ok).toBe(true);
        const [old, now] = [objectsOf(file), objectsOf(named)];
        for (let i = 0; i < now.length; i++) {
          expect(now[i]).toEqual({ ...old[i], id: old[i].id ?? now[i].id });
          expect(now[i].id).toMatch(/^[a-z0-9]{2,16}$/);
        }
        expect(formatLevel(withIds(named))).toBe(formatLevel(named));
      }),
    );
  });

  test('are the same in every version of the toolkit, so that two users do not give one object different ids', () => {
    const { asteroids, novae, minerals } = withIds({
      ...level([rock(3), rock(3)]),
      novae: [rock(3)],
      minerals: [{ x: -1.5, y: 1e9 }],
    });
    const ids = [asteroids, novae, minerals].flatMap((list) => list?.map(({ id }) => id));
    expect(ids).toEqual(['7kptlv', 'ww813j', '6psvun', '2rfc1q']);
  });

  test('do not depend on other objects in the list', () => {
    const [alone] = withIds(level([rock(3)])).asteroids!;
    const among = withIds(level([rock(1), rock(2), rock(3)])).asteroids!;
    expect(among[2]).toEqual(alone);
    expect(new Set(among.map(({ id }) => id)).size).toBe(3);
  });

  test('are different for 20,000 equal objects', () => {
    const named = withIds(level(Array.from({ length: 20_000 }, () => rock(1)))).asteroids!;
    expect(new Set(named.map(({ id }) => id)).size).toBe(20_000);
  });

  test('avoid an id that a later object has', () => {
    const [{ id }] = withIds(level([rock(3)])).asteroids!;
    const named = withIds(level([rock(3), { id, ...rock(4) }])).asteroids!;
    expect(named[1].id).toBe(id);
    expect(named[0].id).not.toBe(id);
  });

  test('avoid any number of taken ids', () => {
    const ids = withIds(level([rock(3), rock(3), rock(3), rock(3)])).asteroids!.map(({ id }) => id);
    const taken = ids.slice(0, 3).map((id, i) => ({ id, ...rock(100 + i) }));
    const [first, second] = withIds(level([rock(3), rock(3), ...taken])).asteroids!;
    expect(first.id).toBe(ids[3]);
    expect([...ids, undefined]).not.toContain(second.id);
  });
});
