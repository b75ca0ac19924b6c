import { expect, it } from 'vitest';
import { exportOriginal, formatLevel, formatOriginal, importOriginal, readLevel } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { importedLevels } from './imported-levels.ts';
import { hasTruth, NO_TRUTH, originalLevels } from './recordings.ts';

interface OriginalObject {
  readonly x: number;
  readonly y: number;
  readonly radius?: number | string;
  readonly enemy?: boolean;
}

interface OriginalLevel {
  readonly player?: OriginalObject & { readonly vx?: number; readonly vy?: number };
  readonly target: OriginalObject;
  readonly maxDistance: number;
  readonly asteroids?: readonly OriginalObject[];
  readonly novae?: readonly OriginalObject[];
  readonly antiForceFields?: readonly OriginalObject[];
  readonly aliens?: readonly OriginalObject[];
  readonly goodies?: readonly OriginalObject[];
}

const circles = (list: readonly OriginalObject[] | undefined, radius?: number) =>
  (list ?? []).map((o) => [o.x, o.y, o.radius === undefined ? radius : Number(o.radius)]);

const placed = (list: readonly { x: number; y: number; radius: number }[]) => list.map((o) => [o.x, o.y, o.radius]);

type Json = Record<string, unknown>;

/** Lists of things that the original no longer draws, and scenes that only it can play. */
const IGNORED = ['forceFields', 'enemies', 'intro', 'numIntroScenes', 'camera'];

/** An original level as it is written after it went through a level file: radii are numbers, lists that are empty may be missing. */
function normal(level: Json): Json {
  const object = (value: unknown): Json => {
    const { radius, enemy, ...rest } = value as Json;
    return { ...rest, ...(radius === undefined ? {} : { radius: Number(radius) }), ...(enemy === true ? { enemy } : {}) };
  };
  const entries = Object.entries(level).filter(([key]) => !IGNORED.includes(key));
  const parts = entries.map(([key, value]) => [
    key,
    Array.isArray(value) ? value.map(object) : typeof value === 'object' ? object(value) : value,
  ]);
  return Object.fromEntries(parts.filter(([, value]) => !Array.isArray(value) || value.length > 0));
}

/** Two of the original's aliens have no picture of their own, and are drawn with the one of all others. */
const withPicture = (level: Json): Json => {
  const aliens = level.aliens as Json[] | undefined;
  return aliens === undefined ? level : { ...level, aliens: aliens.map((alien) => ({ ...alien, key: 'alien' })) };
};

if (!hasTruth) {
  declareMissing('import of the original', NO_TRUTH);
} else {
  const originals: OriginalLevel[] = JSON.parse(originalLevels());
  const levels = importedLevels();
  const filled = [...originals.entries()].filter(([, o]) => o.player !== undefined);

  it('imports every level that is not a placeholder, and nothing else', () => {
    expect(filled.length).toBeGreaterThan(10);
    expect([...levels.keys()]).toEqual(filled.map(([number]) => number));
  });

  it.each(filled)('imports level %i without loss', (number, o) => {
    const level = levels.get(number);
    expect(level).toBeDefined();
    if (level === undefined) return;
    expect(level.recoil).toBe(true);
    expect(level.range).toBe(o.maxDistance);
    expect(level.astronaut).toEqual({ x: o.player?.x, y: o.player?.y, vx: o.player?.vx ?? 0, vy: o.player?.vy ?? 0 });
    expect([[level.blackHole.x, level.blackHole.y, level.blackHole.radius]]).toEqual(circles([o.target]));
    expect(placed(level.asteroids)).toEqual(circles(o.asteroids));
    expect(level.asteroids.map((a) => a.hot)).toEqual((o.asteroids ?? []).map((a) => a.enemy === true));
    expect(placed(level.novae)).toEqual(circles(o.novae));
    expect(placed(level.repulsors)).toEqual(circles(o.antiForceFields));
    expect(placed(level.aliens)).toEqual(circles(o.aliens, 25));
    expect(placed(level.minerals)).toEqual(circles(o.goodies, 7));
  });

  it.each(filled)('exports level %i as the original has it: every number, and every picture', (number, o) => {
    const imported = importOriginal(JSON.stringify(o), { recoil: true });
    if (!imported.ok) throw new Error('not imported');
    const read = readLevel(formatLevel(imported.levels[0].file));
    if (!read.ok) throw new Error(`level ${number} is not valid`);
    const { object, refused, differences } = exportOriginal(read.level, read.document);
    expect({ refused, differences }).toEqual({ refused: [], differences: [] });
    const [exported] = JSON.parse(formatOriginal([{ title: '', object }], 'json'));
    expect(normal(exported)).toEqual(withPicture(normal(o as unknown as Json)));
  });
}
