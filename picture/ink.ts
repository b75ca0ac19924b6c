/** Colours of diagrams by purpose: [on light ground, on dark ground]. Nothing is distinguished by colour alone. */
const INKS = {
  panel: ['#ffffff', '#0a0e1d'],
  shade: ['#eef1f8', '#141a33'],
  rule: ['#dbe0ec', '#242c4c'],
  text: ['#151b33', '#eef2ff'],
  muted: ['#566087', '#98a4cc'],
  euler: ['#b35c00', '#f0a050'],
  verlet: ['#1f6fd0', '#6fb1ff'],
  rk4: ['#0f8a4b', '#5fe09a'],
  taylor: ['#8a3fd1', '#c79bff'],
  arcade: ['#d02020', '#ff6b6b'],
  peer: ['#5d6680', '#9aa6c9'],
} as const;

/** The purpose of a colour. */
export type Ink = keyof typeof INKS;

/** `auto` follows the preference of the reader's system where the viewer knows it, and is light elsewhere. */
export type Ground = 'auto' | 'light' | 'dark';

/** Draws in an ink: sets `currentColor` for the drawings. */
export function inked(ground: Ground, ink: Ink, drawings: string): string {
  if (drawings === '') return '';
  return `<g class="gq-${ink}" color="${INKS[ink][ground === 'dark' ? 1 : 0]}">${drawings}</g>`;
}

/** The style that turns a light picture into a dark one; empty unless the ground is `auto`. */
export function inkStyle(ground: Ground): string {
  if (ground !== 'auto') return '';
  const rules = Object.entries(INKS).map(([ink, [, dark]]) => `.gq-${ink}{color:${dark}}`);
  return `<style>@media (prefers-color-scheme:dark){${rules.join('')}}</style>`;
}
