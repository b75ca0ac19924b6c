import { GAME_COLOURS, type GameColours, type Theme } from '../../phaser/index.ts';
import { heatColour } from '../../picture/index.ts';

export { colourNumber, type Theme } from '../../phaser/index.ts';

/** The colours of the canvas, as CSS. Space is dark in the dark theme and pale in the light one. */
export interface Colours extends GameColours {
  readonly grid: string;
  readonly range: string;
  /** of a run that completes the level */
  readonly way: string;
  readonly wayHeld: string;
  /** of a run that does not */
  readonly wayLost: string;
  readonly wayLostHeld: string;
  readonly danger: string;
  readonly near: string;
  /** of the heat map, as in pictures */
  readonly heat: string;
  /** of the heat map of deaths */
  readonly death: string;
  /** of states that are already lost */
  readonly lost: string;
  /** of what was before a change */
  readonly onion: string;
  /** of places where something may stand */
  readonly leeway: string;
  readonly slack: string;
  readonly select: string;
  readonly guide: string;
  readonly label: string;
}

export const COLOURS: Readonly<Record<Theme, Colours>> = {
  dark: {
    ...GAME_COLOURS.dark,
    grid: '#8ea3c9',
    range: '#7ea2d6',
    way: '#7cf2b0',
    wayHeld: '#baffd6',
    wayLost: '#c9cfdb',
    wayLostHeld: '#f1f3f7',
    danger: '#ff6b61',
    near: '#ffc04d',
    heat: heatColour('dark'),
    death: '#ff6b61',
    lost: '#d59bff',
    onion: '#4fd8e8',
    leeway: '#d3e25a',
    slack: '#7cf2b0',
    select: '#5fb0ff',
    guide: '#ff7ad9',
    label: '#dfe7f5',
  },
  light: {
    ...GAME_COLOURS.light,
    grid: '#54658a',
    range: '#4f72a8',
    way: '#0b7a45',
    wayHeld: '#00592f',
    wayLost: '#4a5263',
    wayLostHeld: '#232936',
    danger: '#c3261b',
    near: '#9a6200',
    heat: heatColour('light'),
    death: '#c3261b',
    lost: '#7b1fb8',
    onion: '#006a80',
    leeway: '#5a6600',
    slack: '#0b7a45',
    select: '#0b63c4',
    guide: '#b0128a',
    label: '#1b2436',
  },
};
