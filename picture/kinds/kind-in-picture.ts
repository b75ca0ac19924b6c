import type { Rules } from '../../schema/index.ts';
import type { Theme } from '../theme.ts';

/** One object to be drawn. */
export interface Look<Thing> {
  /** As the level has it. */
  readonly object: Thing;
  /** Which of its places it is drawn at, for a kind that has several. */
  readonly place: number;
  /** px: the object's, or more where that would be too small to be seen */
  readonly radius: number;
  /** Within its list: so that no two look quite alike. */
  readonly index: number;
  readonly theme: Theme;
  readonly rules: Rules;
}

/** How a kind of object is drawn in pictures: as SVG around its own centre, in px of the level. */
export interface KindInPicture<Thing = object> {
  /** What lies above what: the higher is in front. null: it is not drawn among the objects, but over the way. */
  readonly depth: number | null;
  draw(look: Look<Thing>): string;
  /** The simplest sign of it, of another shape than that of each other kind. */
  speck(look: Look<Thing>): string;
  /** What joins its places, for a kind that has several: around the first of them. */
  between?(look: Look<Thing>): string;
  /** How far a picture shows what is around its centre, in radii; 1 when left out. */
  readonly reach?: number;
  /** What lies around it, farther than its rim. */
  readonly around?: { readonly depth: number; readonly name: string; draw(theme: Theme, rules: Rules): string };
  /** The gradients that it is drawn with. */
  gradients?(theme: Theme): readonly string[];
  /** Its sign in the legend is its drawing at this radius, made as small as the others, and by a factor smaller where it has much around it; null: it needs no sign. */
  readonly legend: { readonly radius: number; readonly factor?: number } | null;
}
