import type { LegendEntry } from './legend.ts';
import { THEMES, type Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** Where a search has been, for a heat map. */
export interface Explored {
  /** Side of a square, px. */
  readonly cellSize: number;
  /** The squares that were visited. */
  readonly cells: readonly {
    /** x of the centre, px of the level. */
    readonly x: number;
    /** y of the centre, px of the level. */
    readonly y: number;
    /** How often a simulated state fell into the square. */
    readonly visits: number;
  }[];
}

/** The squares that are drawn in one opacity. */
export interface HeatShade {
  /** Opacity, 0 to 1. */
  readonly opacity: number;
  /** The least number of visits among its squares. */
  readonly least: number;
  /** The greatest number of visits among its squares. */
  readonly most: number;
  /** The squares. */
  readonly cells: Explored['cells'];
}

/** How many shades there are at most. */
const SHADES = 7;

const shadeOpacity = (shade: number): number => 0.07 + (0.68 * shade) / (SHADES - 1);

/**
 * Divides the squares of a heat map into shades. Each shade has about as many squares as the others, so that all of them are
 * informative.
 * @param explored where a search has been
 * @returns the shades, from rarely visited to often visited
 */
export function heatShades({ cells }: Explored): HeatShade[] {
  const shades: Explored['cells'][number][][] = Array.from({ length: SHADES }, () => []);
  const ranked = [...cells].sort((a, b) => a.visits - b.visits);
  let shade = 0;
  for (const [rank, cell] of ranked.entries()) {
    // Squares with equal visits get the same shade.
    if (rank === 0 || cell.visits > ranked[rank - 1].visits) shade = Math.floor((SHADES * rank) / ranked.length);
    shades[shade].push(cell);
  }
  return shades.flatMap((members, i) => {
    const [first] = members;
    if (first === undefined) return [];
    const most = members[members.length - 1].visits;
    return [{ opacity: shadeOpacity(i), least: first.visits, most, cells: members }];
  });
}

/**
 * The colour of a heat map.
 * @param theme name of the theme
 * @returns a CSS colour
 */
export const heatColour = (theme: Theme['name']): string => THEMES[theme].heat;

const inShort = (count: number): string =>
  count >= 1e6 ? `${(count / 1e6).toFixed(1)}M` : count >= 1e4 ? `${Math.round(count / 1e3)}k` : String(count);

/**
 * Formats how often the squares of a shade were visited: `3`, `4-12`, `10k-34k`.
 * @param shade the least and the greatest number of visits
 * @returns the text
 */
export function visitsInWords({ least, most }: Pick<HeatShade, 'least' | 'most'>): string {
  const [from, to] = [inShort(least), inShort(most)];
  return from === to ? from : `${from}–${to}`;
}

/**
 * Says what a heat map counts.
 * @param explored where a search has been
 * @returns the text
 */
export const heatCaption = ({ cellSize }: Explored): string => `visits of the search to each square of ${cellSize} px`;

/** Draws the squares of a heat map; the group that they are put into has the colour. */
export function drawSquares(view: View, explored: Explored): string {
  const half = explored.cellSize / 2;
  const side = num(explored.cellSize * view.scale);
  const paths = heatShades(explored).map(({ opacity, cells }) => {
    const squares = cells.map(({ x, y }) => `M${num(view.x(x - half))} ${num(view.y(y - half))}h${side}v${side}h-${side}z`);
    return `<path d="${squares.join('')}" fill-opacity="${num(opacity)}"/>`;
  });
  return paths.join('');
}

/** Draws where a search has been. */
export function drawHeat(view: View, theme: Theme, explored: Explored): string {
  return `<g data-kind="explored" fill="${theme.heat}">${drawSquares(view, explored)}</g>`;
}

/** The entries of a legend for the shades of a heat map: how much each stands for. */
export function shadeSigns(theme: Theme, colour: string, explored: Explored): LegendEntry[] {
  const square = (opacity: number): string =>
    `<rect x="-9" y="-6" width="18" height="12" fill="${theme.space[1]}" stroke="${theme.muted}" stroke-width=".8"/>` +
    `<rect x="-9" y="-6" width="18" height="12" fill="${colour}" fill-opacity="${num(opacity)}"/>`;
  return heatShades(explored).map((shade) => ({ label: visitsInWords(shade), icon: square(shade.opacity) }));
}

/** The entries of the legend: what is counted, and the visits of each shade. */
export function heatSigns(theme: Theme, explored: Explored): LegendEntry[] {
  return [{ label: `${heatCaption(explored)}:`, icon: null }, ...shadeSigns(theme, theme.heat, explored)];
}
