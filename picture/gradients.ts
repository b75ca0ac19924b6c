import { LISTED_KINDS, SINGLE_KINDS } from '../schema/index.ts';
import { IN_PICTURE } from './kinds/index.ts';
import type { Theme } from './theme.ts';
import { radial } from './xml.ts';

/** The gradients that all pictures of a theme share. */
export function drawGradients(theme: Theme): string {
  const own = [...LISTED_KINDS, ...SINGLE_KINDS].flatMap((kind) => IN_PICTURE[kind].gradients?.(theme) ?? []);
  return `<defs>${[
    radial(
      'space',
      [
        [0, theme.space[0]],
        [1, theme.space[1]],
      ],
      ' cx=".5" cy=".42" r=".8"',
    ),
    ...own,
  ].join('')}</defs>`;
}
