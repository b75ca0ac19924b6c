import type { Disc, Place } from '../../../../schema/basics/index.ts';
import type { SymmetryKind } from '../generator-spec.ts';
import { distance, type Layout } from '../layout.ts';
import { Site } from './site.ts';

/** Maps a place to the one that corresponds to it. Twice it gives the place itself. */
export type Image = (place: Place) => Place;

/** px between an object and the image of its counterpart, at most. */
const OFF = 6;

/** Half a turn around a place. */
const halfTurn =
  ({ x, y }: Place): Image =>
  (place) => ({ x: Math.round(2 * x - place.x), y: Math.round(2 * y - place.y) });

/** The mirror image about the line through two places. */
function mirror(a: Place, b: Place): Image {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const square = dx * dx + dy * dy;
  return ({ x, y }) => {
    const across = (2 * ((x - a.x) * dy - (y - a.y) * dx)) / square;
    return { x: Math.round(x - across * dy), y: Math.round(y + across * dx) };
  };
}

/** Images of one kind that a layout may have: about its middle, the largest asteroid, and what start and black hole span. */
function imagesOf(kind: SymmetryKind, { start, blackHole, asteroids }: Layout, middle: Place): Image[] {
  const largest = asteroids.reduce((a, b) => (b.radius > a.radius ? b : a));
  const between = { x: (start.x + blackHole.x) / 2, y: (start.y + blackHole.y) / 2 };
  const centres = [middle, largest, between];
  if (kind === 'rotate') return centres.map(halfTurn);
  if (kind === 'none') return [];
  const [right, down] = [
    { x: 1, y: 0 },
    { x: 0, y: 1 },
  ];
  const along = (a: Place, by: Place) => mirror(a, { x: a.x + by.x, y: a.y + by.y });
  return [mirror(start, blackHole), ...centres.flatMap((at) => [along(at, right), along(at, down)])];
}

/** The counterpart of a disc by symmetry, of the same radius; undefined if there is none. */
export const partnerOf = (image: Image, { x, y, radius }: Disc, others: readonly Disc[]): Disc | undefined => {
  const at = image({ x, y });
  return others.find((other) => other.radius === radius && distance(other, at) <= OFF);
};

/** The share of novae whose image is a nova; 1 without novae. */
export function symmetryOf({ novae }: Pick<Layout, 'novae'>, image: Image): number {
  const paired = novae.filter((nova) => partnerOf(image, nova, novae) !== undefined);
  return novae.length === 0 ? 1 : paired.length / novae.length;
}

/** Adds to each nova its image, where that fits and leaves the ways open. */
export function withImages(site: Site, image: Image): Layout {
  for (const nova of site.layout.novae) {
    if (partnerOf(image, nova, site.layout.novae) === undefined) site.nova(image(nova), nova.radius);
  }
  return site.layout;
}

/** Without the novae that have no image. */
export const withoutSingles = (layout: Layout, image: Image): Layout => ({
  ...layout,
  novae: layout.novae.filter((nova) => partnerOf(image, nova, layout.novae) !== undefined),
});

/** The image of a kind in which most novae of a composed layout get a counterpart; null for no symmetry. */
export function bestImage(kind: SymmetryKind, { spec, random, layout, free }: Site): Image | null {
  const middle = { x: spec.width / 2, y: spec.height / 2 };
  let best: Image | null = null;
  let most = -1;
  for (const image of imagesOf(kind, layout, middle)) {
    const paired = withoutSingles(withImages(new Site(spec, random, layout, free), image), image).novae.length;
    if (paired > most) [best, most] = [image, paired];
  }
  return best;
}
