import { type Brush, fadingDisc, faint } from './brush.ts';
import type { GameColours } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/** A mineral: a cut crystal with a light around it. */
function drawMineral(brush: Brush, colours: GameColours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.mineral, 0.55)],
    [1, faint(colours.mineral, 0)],
  ]);
  const facets: readonly (readonly [colour: string, points: readonly (readonly [number, number])[]])[] = [
    [
      colours.mineralLight,
      [
        [0, -0.85],
        [-0.5, -0.25],
        [0, -0.1],
      ],
    ],
    [
      colours.mineral,
      [
        [0, -0.85],
        [0.5, -0.25],
        [0, -0.1],
      ],
    ],
    [
      colours.mineral,
      [
        [-0.5, -0.25],
        [0, 0.85],
        [0, -0.1],
      ],
    ],
    [
      '#1b8fa3',
      [
        [0.5, -0.25],
        [0, 0.85],
        [0, -0.1],
      ],
    ],
  ];
  for (const [colour, points] of facets) {
    brush.fillStyle = colour;
    brush.beginPath();
    for (const [x, y] of points) brush.lineTo(x, y);
    brush.closePath();
    brush.fill();
  }
}

/** A mineral with its light. */
export const mineral: KindDrawing = {
  textures: { mineral: drawMineral },
  parts: () => [{ texture: 'mineral', depth: 6, scale: 1.8 }],
  spin: 0,
};
