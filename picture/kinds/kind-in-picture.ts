import type { Rules } from '../../schema/index.ts';
import type { Theme } from '../theme.ts';

/** One object to draw. */
export interface Look<Thing> {
  /** The object of the level. */
  readonly object: Thing;
  /** Which of its places to draw, for kinds with several. */
  readonly place: number;
  /** Radius, px: the object's, or a larger one if that would be too small to see. */
  readonly radius: number;
  /** Index in its list, from which details vary. */
  readonly index: number;
  readonly theme: Theme;
  readonly rules: Rules;
}

/** How a kind of object is drawn: as SVG around its own centre, in px of the level. */
export interface KindInPicture<Thing = object> {
  /** The drawing order: larger values are in front; null for kinds that are not drawn among the objects but over the path. */
  readonly depth: number | null;
  draw(look: Look<Thing>): string;
  /** The simplest drawing, for levels with very many objects. Its shape differs from that of every other kind. */
  speck(look: Look<Thing>): string;
  /** What connects its places, for kinds with several, drawn around the first of them. */
  between?(look: Look<Thing>): string;
  /** How far the picture includes its surroundings, in radii; 1 by default. */
  readonly reach?: number;
  /** What extends beyond its rim. */
  readonly around?: { readonly depth: number; readonly name: string; draw(theme: Theme, rules: Rules): string };
  /** The gradients that its drawing uses. */
  gradients?(theme: Theme): readonly string[];
  /**
   * The radius of its drawing in the legend, where it is scaled to the size of the others; `factor` reduces it further if much
   * lies around it. null: it has no entry.
   */
  readonly legend: { readonly radius: number; readonly factor?: number } | null;
}
