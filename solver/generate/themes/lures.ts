import { type Disc, type Place, rulesOf } from '../../../schema/basics/index.ts';
import { distance, fits } from '../layout.ts';
import { distanceToWays } from '../tube.ts';
import { corridors } from './corridors.ts';
import { DIRECTIONS, TURN } from './directions.ts';
import { FINE, type Site, snap } from './site.ts';
import type { Theme } from './theme.ts';

/** px between a mineral and the route from which on it leads elsewhere. */
export const ASIDE = 50;

// A pocket: beads on a circle around a mineral.
const BEAD = 12;
const POCKET = 46;
const BEADS = 8;

const ALIEN = 25;

/** Minerals far from the route, in pockets of novae that are open to one side, with sleeping aliens beside them. */
export const lures: Theme = {
  measured: 'minerals off the route',
  least: 1,
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

  measure: ({ minerals }, { places }) =>
    minerals.filter((mineral) => places.every((place) => distance(place, mineral) >= ASIDE)).length,
};

/** Beads around a mineral, where the ways leave room. */
function pocket(site: Site, { x, y }: Disc): void {
  for (let i = 0; i < BEADS; i++) {
    const { x: dx, y: dy } = DIRECTIONS[(i * TURN) / BEADS];
    site.nova({ x: x + dx * POCKET, y: y + dy * POCKET }, BEAD);
  }
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
  const place = places[site.random.below(places.length)];
  site.layout = { ...site.layout, aliens: [...site.layout.aliens, { ...place, radius: ALIEN }] };
}
