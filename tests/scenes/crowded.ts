import type { LevelFile, ObjectList } from '../../schema/index.ts';

type Place = (i: number, n: number) => { x: number; y: number };

const MOST = 20_000;

/** The lists of a level. */
const LISTS: readonly ObjectList[] = ['asteroids', 'novae', 'repulsors', 'aliens', 'minerals', 'winds', 'wormholes'];

/** Bytes that a level file may have, less a margin. */
const MOST_BYTES = 8 * 1024 * 1024 - 4096;

/**
 * Makes a valid level in which up to 20,000 objects of one or several kinds are in one place, in almost one place, on a line or
 * about her, with radii from the least to the largest: all overlap all, and many cover her start. Nothing is taken away so that she
 * may live: proofs and warnings have to deal with what kills her at once.
 * @param random uniform in [0, 1)
 */
export function crowded(random: () => number, name: string): LevelFile {
  const pick = <T>(...of: readonly T[]): T => of[Math.floor(random() * of.length)];
  const chance = (p: number): boolean => random() < p;

  const places = (): Place => {
    const far = pick(0, 30, 200, 2000, 1e5);
    const x = far * (2 * random() - 1);
    const y = far * (2 * random() - 1);
    const apart = pick(0, 1e-9, 1e-3, 1, 100);
    const width = pick(300, 1000, 1000, 5000);
    const spread = (): { x: number; y: number } => ({ x: width * (2 * random() - 1), y: width * (2 * random() - 1) });
    return pick<Place>(
      () => ({ x, y }),
      (i) => ({ x: x + apart * i, y }),
      (i) => ({ x: x + apart * i, y: y + 0.37 * apart * i }),
      () => ({ x: x + apart * random(), y: y + apart * random() }),
      spread,
      spread,
      spread,
      // around her, where aliens see her
      (i, n) => {
        const at = pick(1, 1, 0.9999) * 150 * Math.sqrt((i + 1) / n);
        return { x: at * Math.cos(2.4 * i), y: at * Math.sin(2.4 * i) };
      },
    );
  };
  const radii = (): (() => number) => {
    const least = pick(1e-3, 1, 25, 400, 1e4, 1e6, 1e6, 1e6);
    const same = chance(0.5);
    return () => Math.min(1e6, least * (same ? 1 : 1 + random()));
  };
  const list = (kind: ObjectList): object[] => {
    const place = places();
    const radius = radii();
    const count = Math.ceil(pick(300, 5000, MOST, MOST) * (0.8 + 0.2 * random()));
    const hot = pick(0, 0.5, 1);
    const exit = places();
    const more = (i: number, n: number): object => {
      if (kind === 'asteroids') return random() < hot ? { hot: true } : {};
      if (kind === 'winds') return { ax: 200 * random() - 100, ay: 200 * random() - 100 };
      const { x, y } = exit(i, n);
      return kind === 'wormholes' ? { toX: x, toY: y } : {};
    };
    return Array.from({ length: count }, (_, i) => ({ ...rounded(place(i, count)), radius: radius(), ...more(i, count) }));
  };
  const main = pick('aliens' as const, 'aliens' as const, ...LISTS);
  const level: LevelFile = {
    version: 1,
    name,
    astronaut: { x: 0, y: 0, vx: pick(0, 0, 3, 1000), vy: pick(0, 1, 40) },
    blackHole: { x: pick(60, 300, 1e5), y: pick(0, 17), radius: pick(1e-3, 18, 1e6) },
    range: pick(150, 1000, 1e6),
    recoil: chance(0.5),
    rules: chance(0.3) ? { alienSight: pick(0, 1000, 10_000), alienPull: pick(0, 30, 1000) } : {},
    asteroids: [{ x: 100, y: 100, radius: pick(1e-3, 10) }],
  };
  const filled: LevelFile = Object.fromEntries([
    ...Object.entries(level),
    ...LISTS.filter((kind) => kind === main || chance(0.12)).map((kind) => [kind, list(kind)]),
  ]) as LevelFile;
  const runs = pick(0, 0, 1, 20);
  const end = pick(100, 3600, 216_000);
  const full: LevelFile = {
    ...filled,
    runs: Array.from({ length: runs }, (_, i) => ({ name: `run ${i}`, holds: [[i, i + end - 20]] as [number, number][] })),
  };
  return JSON.stringify(full).length <= MOST_BYTES ? full : { ...level, [main]: full[main] };
}

const rounded = ({ x, y }: { readonly x: number; readonly y: number }): { x: number; y: number } => ({
  x: Number(x.toPrecision(12)),
  y: Number(y.toPrecision(12)),
});
