import type { LegendEntry } from './legend.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** How it is known that the black hole cannot be reached any more. */
export type LostKnown = 'proved' | 'not found';

/** Where a level is already lost although she lives on. */
export interface Lost {
  /** States from which the black hole cannot be reached, px of the level. */
  readonly states: readonly { readonly x: number; readonly y: number; readonly known: LostKnown }[];
  /** Where such states begin, px of the level. */
  readonly places: readonly { readonly x: number; readonly y: number; readonly known: LostKnown }[];
}

/** Radius of the mark of a state and of the ring around a place, units. */
const STATE = 4;
const PLACE = 11;

/** A proof is a filled disc; what was merely not found is hollow and dashed, so that nothing depends on colour. */
function mark(x: number, y: number, known: LostKnown, theme: Theme): string {
  const at = `cx="${num(x)}" cy="${num(y)}" r="${STATE}"`;
  return known === 'proved'
    ? `<circle ${at} fill="${theme.bad}" fill-opacity=".85"/>`
    : `<circle ${at} fill="none" stroke="${theme.bad}" stroke-width="1.2" stroke-dasharray="2 1.6"/>`;
}

const ring = (x: number, y: number, known: LostKnown, theme: Theme): string =>
  `<circle cx="${num(x)}" cy="${num(y)}" r="${PLACE}" fill="none" stroke="${theme.bad}" stroke-width="2"${known === 'proved' ? '' : ' stroke-dasharray="4 3"'}/>`;

/** Draws lost states, and rings where they begin. */
export function drawLost(view: View, theme: Theme, { states, places }: Lost): string {
  const marks = states.map(({ x, y, known }) => mark(view.x(x), view.y(y), known, theme));
  const rings = places.map(({ x, y, known }) => ring(view.x(x), view.y(y), known, theme));
  return `<g data-kind="lost">${marks.join('')}${rings.join('')}</g>`;
}

/** The entries of the legend. */
export function lostSigns(theme: Theme, { states, places }: Lost): LegendEntry[] {
  const has = (known: LostKnown) => states.some((state) => state.known === known);
  return [
    ...(has('proved') ? [{ label: 'proved: the black hole is out of her reach', icon: mark(0, 0, 'proved', theme) }] : []),
    ...(has('not found')
      ? [{ label: 'no run was found from here; that proves nothing', icon: mark(0, 0, 'not found', theme) }]
      : []),
    ...(places.length > 0 ? [{ label: 'it begins here', icon: ring(0, 0, 'proved', theme) }] : []),
  ];
}
