import { boxOf } from '../../../../engine/index.ts';
import { type Disc, type Place, rulesOf } from '../../../../schema/basics/index.ts';
import { distance } from '../layout.ts';
import { type Flight, headingAt, lengthOf } from './flight.ts';
import { placeChain } from './site.ts';
import type { Theme } from './theme.ts';

const BEAD = 12;

// px between the centres of two beads of a wall.
const SPACING = 38;

// px at both ends of the route without walls.
const ENDS = 60;

// px from her centre to the rim of a wall, at most, and px that a wall's bead reaches along her path.
const WIDEST = 72;
const REACH = 26;

// Length of the route, at least, of the side of a square as large as the level; and px between two stretches of it that have walls
// of their own.
const LEAST_LENGTH = 0.43;
const APART = 64;

/** Rows of novae along both sides of the route. */
export const corridors: Theme = {
  measured: 'share of the route between two walls',
  least: () => 0.5,
  symmetry: 'none',
  adjust: ({ room }) => ({ room: Math.min(room, 6), novae: 0 }),

  arrange(site) {
    const { width, height, asteroids } = site.spec;
    site.start({ x: site.between(80, width - 80), y: site.between(80, height - 80) });
    return placeChain(site, site.between(...asteroids), { first: [120, 200], next: [170, 280], radii: [32, () => 24] });
  },

  // long routes that do not come back to where they have been
  rank(_, { places }, { width, height }) {
    const length = lengthOf(places) / Math.sqrt(width * height);
    return length < LEAST_LENGTH || comesBack(places) ? null : Math.min(1.5, length);
  },

  compose(site, flight) {
    const room = boxOf(rulesOf(site.layout)).halfDiagonal + site.spec.room;
    let best: { readonly walls: readonly Place[]; readonly score: number } | null = null;
    for (let gap = room + BEAD + 1; gap <= WIDEST + BEAD; gap += 2) {
      const walls = [-1, 1].flatMap((side) => wallOf(flight.places, side * gap));
      const free = walls.filter((place) => site.takesNova({ ...place, radius: BEAD }));
      // a close wall that is nearly whole is better than a wide one without a hole
      const score = (free.length / Math.max(1, walls.length)) * (1 - gap / 300);
      if (best === null || score > best.score) best = { walls: free, score };
    }
    for (const place of best?.walls ?? []) site.nova(place, BEAD);
    for (const gap of [room + BEAD + 1, room + BEAD + 20, room + BEAD + 44]) {
      for (const side of [-1, 1]) for (const place of wallOf(flight.places, side * gap)) site.slot(place, BEAD);
    }
  },

  measure: ({ novae }, flight) => sheltered(novae, flight),
};

/** Whether a path comes close to a place where it has been before. */
function comesBack(places: readonly Place[]): boolean {
  const along = [0];
  for (let i = 1; i < places.length; i++) along.push(along[i - 1] + distance(places[i - 1], places[i]));
  return places.some((place, i) => places.some((other, k) => along[k] > along[i] + 3 * APART && distance(place, other) < APART));
}

/** Evenly spaced places along a curve that runs beside a path; `gap` is signed, px. */
function wallOf(places: readonly Place[], gap: number): Place[] {
  const wall: Place[] = [];
  for (const [i, place] of places.entries()) {
    const heading = headingAt(places, i);
    if (heading === null) continue;
    if (distance(place, places[0]) < ENDS || distance(place, places[places.length - 1]) < ENDS) continue;
    const beside = { x: Math.round(place.x - heading.y * gap), y: Math.round(place.y + heading.x * gap) };
    if (wall.every((other) => distance(other, beside) >= SPACING)) wall.push(beside);
  }
  return wall;
}

/** The share of a route, without its ends, that has a nova close by on both sides. */
function sheltered(novae: readonly Disc[], { places }: Flight): number {
  let [between, all] = [0, 0];
  for (const [i, place] of places.entries()) {
    const heading = headingAt(places, i);
    if (heading === null) continue;
    if (distance(place, places[0]) < ENDS || distance(place, places[places.length - 1]) < ENDS) continue;
    all++;
    const [left, right] = [-1, 1].map((side) =>
      novae.some((nova) => {
        const [dx, dy] = [nova.x - place.x, nova.y - place.y];
        const across = side * (heading.x * dy - heading.y * dx);
        return across > 0 && across - nova.radius <= WIDEST && Math.abs(heading.x * dx + heading.y * dy) <= nova.radius + REACH;
      }),
    );
    if (left && right) between++;
  }
  return all === 0 ? 0 : between / all;
}
