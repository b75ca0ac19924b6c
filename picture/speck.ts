import type { Theme } from './theme.ts';
import { num } from './xml.ts';

/** From this many objects on each is drawn as a speck: details would be too small to see, and the file too large to open. */
export const SPECKS_FROM = 1500;

export type SpeckKind = 'asteroid' | 'hot-asteroid' | 'nova' | 'repulsor' | 'alien' | 'mineral';

/** The simplest sign of a thing around its centre, of another shape for each kind. */
export function drawSpeck(kind: SpeckKind, radius: number, theme: Theme): string {
  const r = num(radius);
  const h = num(0.35 * radius);
  switch (kind) {
    case 'asteroid':
      return `<circle r="${r}" fill="${theme.rock[1]}"/>`;
    case 'hot-asteroid':
      return `<circle r="${r}" fill="${theme.hot[1]}"/><path d="M0-${h}L${h} ${h}H-${h}Z" fill="${theme.flame}"/>`;
    case 'nova':
      return `<path d="M0-${r}L${h}-${h}L${r} 0L${h} ${h}L0 ${r}L-${h} ${h}L-${r} 0L-${h}-${h}Z" fill="${theme.nova[2]}"/>`;
    case 'repulsor':
      return `<circle r="${r}" fill="${theme.repulsor}" fill-opacity=".2" stroke="${theme.repulsor}" stroke-dasharray="4 3"/>`;
    case 'alien':
      return `<path d="M-${r} ${r}V0A${r} ${r} 0 0 1 ${r} 0V${r}Z" fill="${theme.alien}"/>`;
    case 'mineral':
      return `<path d="M0-${r}L${r} 0L0 ${r}L-${r} 0Z" fill="${theme.mineral[1]}"/>`;
  }
}
