import type { Disc, Place } from '../../../../schema/basics/index.ts';
import { distance } from '../layout.ts';
import { DIRECTIONS, directionOf, TURN } from './directions.ts';
import { longestOrbit } from './flight.ts';
import { type Site, setOff } from './site.ts';
import type { Theme } from './theme.ts';

const BEAD = 12;

// px between the centres of two beads of a ring, about, and between two rings.
const SPACING = 40;
const RINGS_APART = 44;

// px between a ring and the asteroid in its middle.
const CROWN = 26;

// px between the asteroid's rim and her path, at least: an orbit goes around and not through.
const CLEAR = 18;

/** What stands around the orbit: places of beads, from a radius on. */
type Figure = (body: Disc, radius: number, site: Site) => Place[];

const FIGURES: readonly Figure[] = [
  // a ring
  (body, radius) => ringOf(body, radius, SPACING),
  // arcs with gaps between them
  (body, radius, site) => {
    const arcs = site.between(2, 4);
    const ring = [ringOf(body, radius, SPACING), ringOf(body, radius + RINGS_APART, SPACING)];
    return ring.flatMap((places) => places.filter((_, i) => ((i * arcs) / places.length) % 1 < 0.55));
  },
  // rays
  (body, radius, site) => {
    const rays = 2 * site.between(3, 5);
    return Array.from({ length: rays }, (_, i) =>
      [0, 1, 2, 3].map((bead) => around(body, (i / rays) * TURN, radius + 36 * bead)),
    ).flat();
  },
  // the arms of a spiral, each half a turn long
  (body, radius, site) => {
    const arms = site.between(2, 3);
    const beads = Math.floor((Math.PI * (radius + 60)) / SPACING);
    return Array.from({ length: arms }, (_, arm) =>
      Array.from({ length: beads }, (_, i) => around(body, (arm / arms + i / beads / 2) * TURN, radius + (150 * i) / beads)),
    ).flat();
  },
];

/** One large asteroid that she goes around, and rings, rays or spirals of novae about it. */
export const orbits: Theme = {
  measured: 'full turns around an asteroid',
  least: () => 0.55,
  symmetry: 'rotate',
  adjust: ({ presses, hold }) => ({ presses: [1, Math.max(2, presses[1] - 1)], hold: [hold[0], 420] }),

  arrange(site) {
    const { width, height, ingredients } = site.spec;
    const radius = Math.min(64, Math.max(40, 8 * Math.round(Math.min(width, height) / 80)));
    const off = (side: number) => site.between(0, side * 0.16) - side * 0.08;
    const middle = { x: width / 2 + off(width), y: height / 2 + off(height) };
    site.start({ x: -1e4, y: -1e4 });
    const body = site.asteroid(() => middle, radius, ingredients.includes('hot') && site.random.below(2) === 0);
    if (body === null) return false;
    const place = site.near(body, radius + 70, radius + 130);
    if (place.x < 60 || place.y < 60 || place.x > width - 60 || place.y > height - 60) return false;
    site.start(place);
    setOff(site, body);
    for (let n = site.between(0, Math.max(1, Math.round(width / 500))); n > 0; n--) {
      site.asteroid(() => site.near(body, 200, 280), 16 + 8 * site.random.below(2));
    }
    return true;
  },

  rank({ asteroids }, flight, spec) {
    const { turns, index } = longestOrbit(asteroids, flight);
    const body = asteroids[index];
    const isClear = flight.places.every((place) => distance(place, body) >= body.radius + CLEAR);
    return turns >= orbits.least(spec) && isClear ? Math.min(1.5, turns) : null;
  },

  compose(site, flight) {
    const { asteroids } = site.layout;
    const body = asteroids[longestOrbit(asteroids, flight).index];
    const orbit = flight.places.map((place) => distance(place, body)).filter((away) => away < 250);
    const least = Math.min(...orbit);
    const inner = body.radius + CROWN;
    // where she passes close to the asteroid there is no room for a crown
    if (least > inner + 50) for (const place of ringOf(body, inner, 30)) site.nova(place, 10);
    const rings: { readonly radius: number; readonly share: number }[] = [];
    for (let radius = Math.ceil(least); radius <= 236; radius += 4) {
      const ring = ringOf(body, radius, SPACING);
      const free = ring.filter((place) => site.takesNova({ ...place, radius: BEAD })).length;
      rings.push({ radius, share: free / ring.length });
    }
    const most = Math.max(...rings.map(({ share }) => share));
    const outer = rings.find(({ share }) => share >= 0.92 * most)?.radius ?? 236;
    for (const place of FIGURES[site.random.below(FIGURES.length)](body, outer, site)) site.nova(place, BEAD);
    for (let radius = outer - RINGS_APART; radius > inner + 30; radius -= RINGS_APART) offer(site, body, radius);
    for (let radius = outer + RINGS_APART; radius < 500; radius += RINGS_APART) offer(site, body, radius);
  },

  measure: ({ asteroids }, flight) => longestOrbit(asteroids, flight).turns,
};

/** Evenly spaced places on a circle, which begin at the top. */
function ringOf(body: Disc, radius: number, spacing: number): Place[] {
  const count = Math.floor((2 * Math.PI * radius) / spacing);
  // an even number of places, that rings may be turned by half
  const even = Math.max(4, count - (count % 2));
  return Array.from({ length: even }, (_, i) => around(body, (i / even) * TURN, radius));
}

/** The place at a number of directions from the top, clockwise. */
function around({ x, y }: Disc, turn: number, radius: number): Place {
  const { x: dx, y: dy } = unitAt(turn + directionOf(0, -1));
  return { x: Math.round(x + dx * radius), y: Math.round(y + dy * radius) };
}

/** The unit vector at a number of directions that need not be whole. */
function unitAt(turn: number): Place {
  const whole = Math.floor(turn);
  const [a, b] = [DIRECTIONS[whole % TURN], DIRECTIONS[(whole + 1) % TURN]];
  const share = turn - whole;
  const between = { x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share };
  const length = distance(between, { x: 0, y: 0 });
  return { x: between.x / length, y: between.y / length };
}

function offer(site: Site, body: Disc, radius: number): void {
  for (const place of ringOf(body, radius, SPACING)) site.slot(place, BEAD);
}
