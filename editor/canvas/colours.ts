import { heatColour } from '../../picture/index.ts';

/** The colours of the canvas, as CSS. Space is dark in the dark theme and pale in the light one. */
export interface Colours {
  readonly space: string;
  readonly haze: string;
  readonly star: string;
  readonly grid: string;
  readonly rock: string;
  readonly rockShade: string;
  readonly rockLight: string;
  readonly ember: string;
  readonly lava: string;
  readonly nova: string;
  readonly novaCore: string;
  readonly field: string;
  readonly alien: string;
  readonly alienShade: string;
  readonly mineral: string;
  readonly mineralLight: string;
  readonly hole: string;
  readonly holeRim: string;
  readonly suit: string;
  readonly suitShade: string;
  readonly visor: string;
  readonly range: string;
  /** of a run that completes the level */
  readonly way: string;
  readonly wayHeld: string;
  /** of a run that does not */
  readonly wayLost: string;
  readonly wayLostHeld: string;
  readonly ghost: string;
  readonly danger: string;
  readonly near: string;
  /** of the heat map, as in pictures */
  readonly heat: string;
  readonly slack: string;
  readonly select: string;
  readonly guide: string;
  readonly beam: string;
  readonly label: string;
}

const SHARED = {
  rock: '#8b93a3',
  rockShade: '#4b5263',
  rockLight: '#b9c0cc',
  ember: '#7d3a2b',
  lava: '#ff8a3c',
  nova: '#ff5d3b',
  novaCore: '#fff3c9',
  alien: '#6fce5a',
  alienShade: '#2f7a35',
  mineral: '#3fd3e6',
  mineralLight: '#d6fbff',
  hole: '#05040a',
  holeRim: '#a78bfa',
  suit: '#f2f4f8',
  suitShade: '#b4bccb',
  visor: '#f0a93b',
  beam: '#8be9ff',
} as const;

export type Theme = 'dark' | 'light';

export const COLOURS: Readonly<Record<Theme, Colours>> = {
  dark: {
    ...SHARED,
    space: '#0a0d15',
    haze: '#1a2140',
    star: '#cdd8ee',
    grid: '#8ea3c9',
    field: '#7c8cff',
    range: '#7ea2d6',
    way: '#7cf2b0',
    wayHeld: '#baffd6',
    wayLost: '#c9cfdb',
    wayLostHeld: '#f1f3f7',
    ghost: '#9aa7bd',
    danger: '#ff6b61',
    near: '#ffc04d',
    heat: heatColour('dark'),
    slack: '#7cf2b0',
    select: '#5fb0ff',
    guide: '#ff7ad9',
    label: '#dfe7f5',
  },
  light: {
    ...SHARED,
    space: '#dfe5ef',
    haze: '#c5d0e6',
    star: '#8c99b3',
    grid: '#54658a',
    field: '#4b5ce0',
    range: '#4f72a8',
    way: '#0b7a45',
    wayHeld: '#00592f',
    wayLost: '#4a5263',
    wayLostHeld: '#232936',
    ghost: '#6c7890',
    danger: '#c3261b',
    near: '#9a6200',
    heat: heatColour('light'),
    slack: '#0b7a45',
    select: '#0b63c4',
    guide: '#b0128a',
    label: '#1b2436',
  },
};

/** `#rrggbb` as a number, as Phaser takes it. */
export function colourNumber(css: string): number {
  return Number.parseInt(css.slice(1), 16);
}
