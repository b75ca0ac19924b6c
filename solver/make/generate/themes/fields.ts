import { boxOf } from '../../../../engine/index.ts';
import { type Disc, type Place, rulesOf } from '../../../../schema/basics/index.ts';
import { distance, takesOver, tryOften } from '../layout.ts';
import type { Flight } from './flight.ts';
import { COARSE, setOff, snap } from './site.ts';
import type { Theme } from './theme.ts';

const RADII = [48, 56, 64] as const;

const GAP = 16;

const NOVA = 16;

/** Rows of repulsors across the level that she has to pass, and novae that go on with the rows. */
export const fields: Theme = {
  measured: 'share of the time in fields',
  least: () => 0.12,
  symmetry: 'mirror',
  adjust: () => ({ asteroids: [2, 3], novae: 0 }),

  arrange(site) {
    const { width, height } = site.spec;
    const isUpright = width >= height * 1.1 || site.random.below(2) === 0;
    const [long, short] = isUpright ? [width, height] : [height, width];
    const place = (along: number, across: number): Place => (isUpright ? { x: along, y: across } : { x: across, y: along });
    site.start({ x: -1e4, y: -1e4 });
    const radius = RADII[site.random.below(RADII.length)];
    const step = COARSE * Math.ceil((2 * radius + GAP) / COARSE);
    const rows = long > 1000 ? 2 : 1;
    for (let row = 0; row < rows; row++) {
      const along = (long * (row + 1)) / (rows + 1) + site.between(0, 60) - 30;
      const middle = short / 2;
      const count = site.between(2, Math.min(4, Math.floor((short - 120) / step)));
      for (let i = 0; i < count; i++) {
        site.object('repulsors', { ...snap(place(along, middle + (i - (count - 1) / 2) * step), COARSE), radius });
      }
    }
    const placed = site.layout.placed.repulsors;
    if (placed.length < 2) return false;
    // the first two lie on either side of the row, so that her swing leads through a field
    const field = placed[site.random.below(placed.length)];
    const sign = site.random.below(2) === 0 ? 1 : -1;
    const beyond = (away: number, aside: number): Place =>
      isUpright ? { x: field.x + away, y: field.y + aside } : { x: field.x + aside, y: field.y + away };
    const aside = () => site.between(0, 120) - 60;
    const first = site.asteroid(() => beyond(-sign * site.between(radius + 50, radius + 90), aside()), 32);
    if (first === null) return false;
    const second = site.asteroid(() => beyond(sign * site.between(radius + 50, radius + 90), aside()), 24);
    if (second === null) return false;
    const isMoving = site.random.below(2) === 0;
    const start = tryOften(() => {
      const place = site.near(first, 90, 180);
      const isBehind = sign * (isUpright ? first.x - place.x : first.y - place.y) > 0;
      return isBehind && site.takesStart(place) && (isMoving || takesOver(place, first, second)) ? place : null;
    });
    if (start === null) return false;
    site.start(start);
    if (isMoving) setOff(site, first);
    for (let i = site.between(...site.spec.asteroids); i > 2; i--) {
      site.asteroid(() => beyond(sign * site.between(radius + 50, radius + 200), site.between(0, 360) - 180), 24);
    }
    return true;
  },

  rank(level, flight, spec) {
    const share = fields.measure(level, flight);
    return share < fields.least(spec) ? null : Math.min(1.5, 3 * share);
  },

  compose(site) {
    const { repulsors } = site.layout.placed;
    const [first] = repulsors;
    const isUpright = repulsors.some(({ x, y }) => x === first.x && y !== first.y);
    const reach = boxOf(rulesOf(site.layout)).halfDiagonal;
    const step = COARSE * Math.ceil((2 * NOVA + reach) / COARSE);
    const rows = new Map<number, Disc[]>();
    for (const field of repulsors) {
      const key = isUpright ? field.x : field.y;
      rows.set(key, [...(rows.get(key) ?? []), field]);
    }
    for (const row of rows.values()) {
      const across = row.map((field) => (isUpright ? field.y : field.x));
      for (const [end, sign] of [
        [Math.max(...across), 1],
        [Math.min(...across), -1],
      ]) {
        const from = end + sign * (row[0].radius + NOVA + GAP);
        for (let i = 0; i < 12; i++) {
          const at = from + sign * step * i;
          site.nova(isUpright ? { x: row[0].x, y: at } : { x: at, y: row[0].y }, NOVA);
        }
      }
    }
    for (let x = 32; x < site.spec.width; x += step)
      for (let y = 32; y < site.spec.height; y += step) site.slot(snap({ x, y }, COARSE), NOVA);
  },

  measure: ({ repulsors }, { places }: Flight) =>
    places.filter((place) => repulsors.some((field) => distance(field, place) < field.radius)).length /
    Math.max(1, places.length),
};
