import { expect, it } from 'vitest';
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
}
