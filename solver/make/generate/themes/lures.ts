import { type Disc, type Place, rulesOf } from '../../../../schema/basics/index.ts';
import { distance, fits } from '../layout.ts';
import { ALIEN } from '../placed.ts';
import { distanceToWays } from '../tube.ts';
import { corridors } from './corridors.ts';
import { DIRECTIONS, TURN } from './directions.ts';
import { FINE, type Site, snap } from './site.ts';
import type { Theme } from './theme.ts';

/** px between a mineral and the route from which on it leads elsewhere. */
export const ASIDE = 50;

// A pocket: beads on an arc around a mineral. px from the mineral to their centres, tried in this order, and between two of them.
const BEAD = 12;
const RADII = [44, 50, 56, 62, 68] as const;
const SPACING = 31;

// An arc of so many directions is wide enough, a third of a turn; and beads without which it is not a pocket.
const WIDE = TURN / 3;
const FEWEST = 3;

/** Minerals far from the route, each in a pocket of novae that is open to one side, with sleeping aliens beside them. */
export const lures: Theme = {
  measured: 'minerals off the route in pockets of novae',
  least: () => 1,
  symmetry: 'none',
  adjust: () => ({ novae: 0 }),
  arrange: corridors.arrange,
  rank: () => 0,

  compose(site) {
    const route = site.free[0];
    const off = site.layout.minerals.filter((mineral) => distanceToWays([route], mineral) >= ASIDE);
    for (const mineral of off) pocket(site, mineral);
    if (site.spec.ingredients.includes('aliens')) for (const mineral of off) guard(site, mineral);
    for (let x = 32; x < site.spec.width; x += 48)
      for (let y = 32; y < site.spec.height; y += 48) site.slot(snap({ x, y }, FINE), 16);
  },

  measure: ({ minerals, novae }, { places }) =>
    minerals.filter((mineral) => places.every((place) => distance(place, mineral) >= ASIDE) && isInPocket(mineral, novae)).length,
};

function isInPocket(mineral: Disc, novae: readonly Disc[]): boolean {
  const farthest = RADII[RADII.length - 1] + 1;
  return novae.filter((nova) => nova.radius === BEAD && distance(nova, mineral) <= farthest).length >= FEWEST;
}

/** Beads on the widest arc around a mineral that the ways leave free. They stay, even if no game touches them. */
function pocket(site: Site, mineral: Disc): void {
  let best: { readonly radius: number; readonly first: number; readonly length: number } | null = null;
  for (const radius of RADII) {
    const free = DIRECTIONS.map(({ x, y }) =>
      site.takesNova({ x: Math.round(mineral.x + x * radius), y: Math.round(mineral.y + y * radius), radius: BEAD }),
    );
    const [first, length] = longestStretch(free);
    if (best === null || length > best.length) best = { radius, first, length };
    if (length >= WIDE) break;
  }
  if (best === null) return;
  // her way in stays open
  const length = Math.min(best.length, (2 * TURN) / 3);
  const gaps = Math.floor(((2 * Math.PI * best.radius) / TURN) * ((length - 1) / SPACING));
  if (gaps < FEWEST - 1) return;
  for (let i = 0; i <= gaps; i++) {
    const step = best.first + (best.length - length) / 2 + (i * (length - 1)) / gaps;
    const { x, y } = DIRECTIONS[Math.round(step) % TURN];
    site.keep(site.nova({ x: mineral.x + x * best.radius, y: mineral.y + y * best.radius }, BEAD));
  }
}

/** The first index and the length of the longest stretch of directions that are free, all around. */
function longestStretch(free: readonly boolean[]): readonly [first: number, length: number] {
  if (free.every(Boolean)) return [0, free.length];
  let [first, most] = [0, 0];
  for (let from = 0; from < free.length; from++) {
    let length = 0;
    while (free[(from + length) % free.length]) length++;
    if (length > most) [first, most] = [from, length];
  }
  return [first, most];
}

/** An alien that sleeps as long as she keeps to the route, and wakes when she comes for the mineral. */
function guard(site: Site, mineral: Disc): void {
  const sight = rulesOf(site.layout).alienSight;
  const [route] = site.free;
  const places: Place[] = [];
  for (let i = 0; i < TURN; i += 4) {
    for (let away = 88; away < sight - 10; away += 12) {
      const alien = { x: Math.round(mineral.x + DIRECTIONS[i].x * away), y: Math.round(mineral.y + DIRECTIONS[i].y * away) };
      if (distanceToWays([route], alien) < sight + 12) continue;
      if (distanceToWays(site.free, alien) < ALIEN + 40) continue;
      if (fits(site.layout, site.spec, { ...alien, radius: ALIEN }, 20)) places.push(alien);
    }
  }
  if (places.length === 0) return;
  const alien = { ...places[site.random.below(places.length)], radius: ALIEN };
  site.object('aliens', alien);
  site.keep(alien);
}
