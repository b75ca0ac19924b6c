import type { LevelFile } from '../../schema/index.ts';

/** Distance between objects of the field, px. */
const SPACING = 72;
/** Free distance around her path, px: nothing in it may draw the gun or end the run. */
const LANE = 520;

/** An asteroid on her path, which the benchmark drags; the whole run depends on it. */
export const DRAGGED = { id: 'lead', x: 200, y: 0 } as const;

const KINDS = ['asteroids', 'asteroids', 'novae', 'minerals', 'repulsors', 'aliens'] as const;
const RADII = { asteroids: 16, novae: 16, minerals: 7, repulsors: 24, aliens: 14 } as const;

/**
 * A level of a given number of objects that has a completing run: she falls through one asteroid into the black hole behind it.
 * The others stand in a field above and below, of all kinds, in a fixed order.
 */
export function playableLevel(objects: number): LevelFile {
  const others = objects - 3;
  const columns = Math.ceil(Math.sqrt(others));
  const lists: Record<(typeof KINDS)[number], { id: string; x: number; y: number; radius: number }[]> = {
    asteroids: [{ ...DRAGGED, radius: 16 }],
    novae: [],
    minerals: [],
    repulsors: [],
    aliens: [],
  };
  for (let k = 0; k < others; k++) {
    const kind = KINDS[k % KINDS.length];
    const row = Math.floor(k / columns);
    // rows alternate above and below
    const away = LANE + SPACING * Math.floor(row / 2);
    const x = SPACING * ((k % columns) - columns / 2) + 210;
    lists[kind].push({ id: `o${k}`.padEnd(2, '0'), x, y: row % 2 === 0 ? away : -away, radius: RADII[kind] });
  }
  return {
    version: 1,
    name: `Field of ${objects}`,
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 420, y: 0, radius: 18 },
    range: 300,
    ...lists,
    runs: [
      {
        name: 'solution',
        holds: [
          [0, 30],
          [36, 66],
          [72, 102],
          [108, 600],
        ],
      },
    ],
  };
}
