/** How a compared run looks: never by its colour alone. */
export interface Look {
  readonly dark: string;
  readonly light: string;
  /** px of screen: strokes and gaps in turn */
  readonly dashes: readonly number[];
}

/** By slot. */
export const LOOKS: readonly Look[] = [
  { dark: '#4fd8e6', light: '#00707c', dashes: [10, 6] },
  { dark: '#ff8ad6', light: '#ad1284', dashes: [2, 5] },
  { dark: '#ffa057', light: '#9a4700', dashes: [15, 5, 2, 5] },
  { dark: '#d3dd55', light: '#5a6600', dashes: [24, 7] },
];
