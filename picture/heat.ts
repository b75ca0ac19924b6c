import type { LegendEntry } from './legend.ts';
import { THEMES, type Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** Where a search has been: squares of `cellSize` px, `x` and `y` their centres in level px. */
export interface Explored {
  readonly cellSize: number;
  readonly cells: readonly { readonly x: number; readonly y: number; readonly visits: number }[];
}

/** Cells of one strength, from the seldom visited to those that were visited most. */
export interface HeatShade {
  /** 0 to 1 */
  readonly opacity: number;
  /** Visits of its cells. */
  readonly least: number;
  readonly most: number;
  readonly cells: Explored['cells'];
}

/** Shades, from the cells that were seldom visited to those that were most. */
const SHADES = 7;

const shadeOpacity = (shade: number): number => 0.07 + (0.68 * shade) / (SHADES - 1);

/** How strongly each cell is drawn: the oftener visited the stronger. Every shade has about as many cells, so that all of them tell something. */
export function heatShades({ cells }: Explored): HeatShade[] {
  const shades: Explored['cells'][number][][] = Array.from({ length: SHADES }, () => []);
  const ranked = [...cells].sort((a, b) => a.visits - b.visits);
  let shade = 0;
  for (const [rank, cell] of ranked.entries()) {
    // the same number of visits is the same shade
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

/** What the cells are drawn in. */
export const heatColour = (theme: Theme['name']): string => THEMES[theme].heat;

const inShort = (count: number): string =>
  count >= 1e6 ? `${(count / 1e6).toFixed(1)}M` : count >= 1e4 ? `${Math.round(count / 1e3)}k` : String(count);

/** How often the cells of a shade were visited: `3`, `4-12`, `10k-34k`. */
export function visitsInWords({ least, most }: Pick<HeatShade, 'least' | 'most'>): string {
  const [from, to] = [inShort(least), inShort(most)];
  return from === to ? from : `${from}–${to}`;
}

/** What the shades count. */
export const heatCaption = ({ cellSize }: Explored): string => `visits of the search to each square of ${cellSize} px`;

/** How often a search came by each place. */
export function drawHeat(view: View, theme: Theme, explored: Explored): string {
  const half = explored.cellSize / 2;
  const side = num(explored.cellSize * view.scale);
  const paths = heatShades(explored).map(({ opacity, cells }) => {
    const squares = cells.map(({ x, y }) => `M${num(view.x(x - half))} ${num(view.y(y - half))}h${side}v${side}h-${side}z`);
    return `<path d="${squares.join('')}" fill-opacity="${num(opacity)}"/>`;
  });
  return `<g data-kind="explored" fill="${theme.heat}">${paths.join('')}</g>`;
}

/** What is counted and how strong how many visits are, for the legend. */
export function heatSigns(theme: Theme, explored: Explored): LegendEntry[] {
  const square = (opacity: number): string =>
    `<rect x="-9" y="-6" width="18" height="12" fill="${theme.space[1]}" stroke="${theme.muted}" stroke-width=".8"/>` +
    `<rect x="-9" y="-6" width="18" height="12" fill="${theme.heat}" fill-opacity="${num(opacity)}"/>`;
  const shades = heatShades(explored).map((shade) => ({ label: visitsInWords(shade), icon: square(shade.opacity) }));
  return [{ label: `${heatCaption(explored)}:`, icon: null }, ...shades];
}
