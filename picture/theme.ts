/** All colours of a picture. Nothing is distinguished by colour alone: shapes and patterns differ as well. */
export interface Theme {
  readonly name: 'dark' | 'light';
  readonly space: readonly [centre: string, edge: string];
  readonly star: string;
  readonly panel: string;
  readonly rule: string;
  readonly text: string;
  readonly muted: string;
  readonly coast: string;
  readonly gun: string;
  readonly halo: string;
  readonly range: string;
  readonly rock: readonly [lit: string, middle: string, shade: string];
  readonly crater: string;
  readonly craterEdge: string;
  readonly hole: string;
  readonly disc: string;
  readonly suit: string;
  readonly suitEdge: string;
  readonly visor: string;
  readonly good: string;
  readonly bad: string;
  /** Heat maps. */
  readonly heat: string;
  /** The paths of several runs in one picture, in turn. */
  readonly ways: readonly string[];
}

const dark: Theme = {
  name: 'dark',
  space: ['#141b36', '#070a16'],
  star: '#cdd8ff',
  panel: '#0a0e1d',
  rule: '#2a3355',
  text: '#eef2ff',
  muted: '#98a4cc',
  coast: '#c8d3f5',
  gun: '#ffd166',
  halo: '#070a16',
  range: '#8fa6ff',
  rock: ['#c3c7d4', '#858b9e', '#474c5e'],
  crater: '#5a6074',
  craterEdge: '#d3d7e3',
  hole: '#020208',
  disc: '#b58cff',
  suit: '#f4f6ff',
  suitEdge: '#5c6a94',
  visor: '#2f6fd6',
  good: '#6ee7a0',
  bad: '#ff5d5d',
  heat: '#ff9b5c',
  ways: ['#ffd166', '#6fb1ff', '#ff8ad8', '#5fe09a', '#ff9b5c', '#c79bff', '#7ef0f0', '#e6e86a'],
};

const light: Theme = {
  name: 'light',
  space: ['#ffffff', '#edf0f8'],
  star: '#a9b4d6',
  panel: '#ffffff',
  rule: '#ccd3e6',
  text: '#151b33',
  muted: '#566087',
  coast: '#39456f',
  gun: '#c77700',
  halo: '#ffffff',
  range: '#5b6fc4',
  rock: ['#d9dce5', '#a3a9ba', '#6b7184'],
  crater: '#7f869a',
  craterEdge: '#f1f3f8',
  hole: '#0c0a1c',
  disc: '#6d3fd1',
  suit: '#ffffff',
  suitEdge: '#3b4770',
  visor: '#2f6fd6',
  good: '#0f8a4b',
  bad: '#d02020',
  heat: '#e0701c',
  ways: ['#b87400', '#1f6fd0', '#c2227d', '#0f8a4b', '#c8501a', '#7a3fd1', '#0f8f9f', '#7d8000'],
};

/** The themes by name. */
export const THEMES = { dark, light } as const;

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
