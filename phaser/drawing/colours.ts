/** Dark space, or the pale one of the editor's light theme. */
export type Theme = 'dark' | 'light';

/** The colours of objects and of space, as CSS (`#rrggbb`). */
export interface GameColours {
  /** The background. */
  readonly space: string;
  /** Clouds in the background. */
  readonly haze: string;
  /** Stars in the background. */
  readonly star: string;
  /** Cold asteroids. */
  readonly rock: string;
  /** Their side away from the light. */
  readonly rockShade: string;
  /** Their side towards the light. */
  readonly rockLight: string;
  /** The body of hot asteroids. */
  readonly ember: string;
  /** Their glowing cracks. */
  readonly lava: string;
  /** The glow of novae. */
  readonly nova: string;
  /** Their middle. */
  readonly novaCore: string;
  /** Rims of repulsors. */
  readonly field: string;
  /** Aliens. */
  readonly alien: string;
  /** Their shaded parts. */
  readonly alienShade: string;
  /** Minerals. */
  readonly mineral: string;
  /** Their bright facets. */
  readonly mineralLight: string;
  /** The middle of the black hole. */
  readonly hole: string;
  /** The rim of the black hole. */
  readonly holeRim: string;
  /** Her suit. */
  readonly suit: string;
  /** The shaded parts of her suit. */
  readonly suitShade: string;
  /** The visor of her helmet. */
  readonly visor: string;
  /** The beam of the gun. */
  readonly beam: string;
  /** Ghosts. */
  readonly ghost: string;
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

/** The colours of each theme. */
export const GAME_COLOURS: Readonly<Record<Theme, GameColours>> = {
  dark: { ...SHARED, space: '#0a0d15', haze: '#1a2140', star: '#cdd8ee', field: '#7c8cff', ghost: '#9aa7bd' },
  light: { ...SHARED, space: '#dfe5ef', haze: '#c5d0e6', star: '#8c99b3', field: '#4b5ce0', ghost: '#6c7890' },
};

/**
 * A colour as Phaser takes it.
 *
 * @param css - `#rrggbb`
 * @returns the same as a number
 */
export function colourNumber(css: string): number {
  return Number.parseInt(css.slice(1), 16);
}
