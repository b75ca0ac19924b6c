import type { Theme } from './theme.ts';

const radial = (id: string, stops: readonly (readonly [offset: number, color: string, opacity?: number])[], place = ''): string =>
  `<radialGradient id="gq-${id}"${place}>${stops
    .map(([offset, color, opacity]) => {
      const alpha = opacity === undefined ? '' : ` stop-opacity="${opacity}"`;
      return `<stop offset="${offset}" stop-color="${color}"${alpha}/>`;
    })
    .join('')}</radialGradient>`;

/** The gradients that every picture of a theme shares. */
export function drawGradients(theme: Theme): string {
  const lit = ' cx=".36" cy=".32" r=".78"';
  const { rock, hot, nova, disc, hole } = theme;
  return `<defs>${[
    radial(
      'space',
      [
        [0, theme.space[0]],
        [1, theme.space[1]],
      ],
      ' cx=".5" cy=".42" r=".8"',
    ),
    radial(
      'rock',
      [
        [0, rock[0]],
        [0.55, rock[1]],
        [1, rock[2]],
      ],
      lit,
    ),
    radial(
      'hot',
      [
        [0, hot[0]],
        [0.5, hot[1]],
        [1, hot[2]],
      ],
      ' cx=".5" cy=".5" r=".55"',
    ),
    radial('heat', [
      [0.45, hot[0], 0.55],
      [0.7, hot[1], 0.22],
      [1, hot[1], 0],
    ]),
    radial('nova', [
      [0, nova[0]],
      [0.4, nova[1]],
      [1, nova[2]],
    ]),
    radial('glare', [
      [0.2, nova[2], 0.6],
      [0.55, nova[2], 0.2],
      [1, nova[2], 0],
    ]),
    radial('field', [
      [0, theme.repulsor, 0.3],
      [1, theme.repulsor, 0.1],
    ]),
    radial('hole', [
      [0.7, hole],
      [0.93, hole],
      [1, disc],
    ]),
    radial('disc', [
      [0.42, disc, 0.75],
      [0.65, disc, 0.25],
      [1, disc, 0],
    ]),
  ].join('')}</defs>`;
}
