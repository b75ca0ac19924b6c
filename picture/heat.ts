import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** Where a search has been: squares of `cellSize` px, `x` and `y` their centres in level px. */
export interface Explored {
  readonly cellSize: number;
  readonly cells: readonly { readonly x: number; readonly y: number; readonly visits: number }[];
}

/** Shades, from the cells that were seldom visited to those that were most. */
const SHADES = 7;

/** How often a search came by each place: the oftener the stronger. Every shade has about as many cells, so that all of them tell something. */
export function drawHeat(view: View, theme: Theme, { cellSize, cells }: Explored): string {
  const shades = Array.from({ length: SHADES }, () => '');
  const side = cellSize * view.scale;
  const ranked = [...cells].sort((a, b) => a.visits - b.visits);
  let shade = 0;
  for (const [rank, { x, y, visits }] of ranked.entries()) {
    // the same number of visits is the same shade
    if (rank === 0 || visits > ranked[rank - 1].visits) shade = Math.floor((SHADES * rank) / ranked.length);
    shades[shade] +=
      `M${num(view.x(x - cellSize / 2))} ${num(view.y(y - cellSize / 2))}h${num(side)}v${num(side)}h${num(-side)}z`;
  }
  const paths = shades.map((d, i) => (d === '' ? '' : `<path d="${d}" fill-opacity="${num(shadeOpacity(i))}"/>`));
  return `<g data-kind="explored" fill="${theme.heat}">${paths.join('')}</g>`;
}

const shadeOpacity = (shade: number): number => 0.07 + (0.68 * shade) / (SHADES - 1);

/** The sign of the shades, for the legend. */
export function drawHeatSign(theme: Theme): string {
  const squares = [0, Math.floor(SHADES / 2), SHADES - 1].map(
    (shade, i) =>
      `<rect x="${-9 + 6 * i}" y="-5" width="6" height="10" fill="${theme.heat}" fill-opacity="${num(shadeOpacity(shade))}"/>`,
  );
  return squares.join('');
}
