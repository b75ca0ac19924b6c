import { boxOf } from '../../../../engine/index.ts';
import { rulesOf } from '../../../../schema/basics/index.ts';
import { coastsOf, type Flight, headingAt, lengthOf } from './flight.ts';
import { FINE, placeChain, snap } from './site.ts';
import type { Theme } from './theme.ts';

// px; the largest gate that fits is taken.
const RADII = [56, 48, 40, 32, 24] as const;

// Of the side of a square as large as the level.
const LEAST_SHARE = 0.245;

// px that a free flight has at least to get a gate.
const LONG = 110;

/** Long free flights between far asteroids, through gates of few large novae. */
export const slings: Theme = {
  measured: 'px of her two longest free flights, on average',
  // 170 px in a level of 800 x 600 px
  least: ({ width, height }) => Math.round(LEAST_SHARE * Math.sqrt(width * height)),
  symmetry: 'none',
  adjust: ({ coast, room }) => ({ coast: Math.round(coast * 1.6), asteroids: [2, 4], room: room + 2, novae: 0 }),

  arrange(site) {
    const { width, height, asteroids } = site.spec;
    // from one end of the level to the other
    const flip = site.random.below(2) === 0;
    const x = site.between(70, width * 0.2);
    site.start({ x: flip ? width - x : x, y: site.between(80, height - 80) });
    const span = Math.min(420, Math.max(230, width * 0.42));
    return placeChain(site, site.between(...asteroids), {
      first: [110, 200],
      next: [Math.round(span * 0.7), Math.round(span)],
      radii: [40, () => 24 + 8 * site.random.below(2)],
    });
  },

  rank(level, flight, spec) {
    const px = slings.measure(level, flight);
    return px < slings.least(spec) ? null : Math.min(1.5, (0.7 * px) / slings.least(spec));
  },

  compose(site, flight) {
    const { halfDiagonal } = boxOf(rulesOf(site.layout));
    for (const [first, last] of coastsOf(flight)) {
      const length = lengthOf(flight.places.slice(first, last + 1));
      if (length < LONG) continue;
      const gates = length > 300 ? [0.3, 0.7] : [0.5];
      for (const share of gates) {
        const i = Math.round(first + share * (last - first));
        const heading = headingAt(flight.places, i);
        if (heading === null) continue;
        const { x, y } = flight.places[i];
        for (const side of [-1, 1]) {
          RADII.flatMap((radius) => [0, 12, 24, 40].map((more) => ({ radius, more }))).some(({ radius, more }) => {
            const away = side * (radius + halfDiagonal + site.spec.room + 2 + more);
            return site.nova(snap({ x: x - heading.y * away, y: y + heading.x * away }, FINE), radius) !== null;
          });
        }
      }
    }
    for (let x = 64; x < site.spec.width - 40; x += 64) {
      for (let y = 64; y < site.spec.height - 40; y += 64) site.slot({ x, y }, 28);
    }
  },

  measure: (_, flight) => {
    const [first = 0, second = 0] = flightLengths(flight);
    return (first + second) / 2;
  },
};

/** The lengths of free flights, px, the longest first. */
const flightLengths = (flight: Flight): number[] =>
  coastsOf(flight)
    .map(([first, last]) => lengthOf(flight.places.slice(first, last + 1)))
    .sort((a, b) => b - a);
