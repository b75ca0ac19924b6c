import type { Colours } from '../colours.ts';
import { type Brush, disc, fadingDisc, faint } from './brush.ts';

/** An alien without its pupil, which looks where it goes. */
export function drawAlien(brush: Brush, colours: Colours): void {
  // eight stubby arms, the body, a big eye
  brush.fillStyle = colours.alienShade;
  for (let i = 0; i < 8; i++) {
    const angle = (Math.PI * (i + 0.5)) / 4;
    disc(brush, 0.82 * Math.cos(angle), 0.82 * Math.sin(angle), 0.17);
  }
  const body = brush.createRadialGradient(-0.3, -0.35, 0.1, 0, 0, 0.9);
  body.addColorStop(0, '#b8f2a4');
  body.addColorStop(0.5, colours.alien);
  body.addColorStop(1, colours.alienShade);
  brush.fillStyle = body;
  disc(brush, 0, 0, 0.84);
  brush.fillStyle = '#ffffff';
  disc(brush, 0, -0.05, 0.42);
  brush.strokeStyle = faint('#08330f', 0.7);
  brush.lineWidth = 0.06;
  brush.lineCap = 'round';
  brush.beginPath();
  brush.arc(0, 0.2, 0.42, 0.25 * Math.PI, 0.75 * Math.PI);
  brush.stroke();
}

/** What an alien sees with. */
export function drawPupil(brush: Brush): void {
  brush.fillStyle = '#142014';
  disc(brush, 0, 0, 0.9);
  brush.fillStyle = '#ffffff';
  disc(brush, -0.3, -0.35, 0.28);
}

/** A mineral: a cut crystal with a light around it. */
export function drawMineral(brush: Brush, colours: Colours): void {
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

/** The astronaut; the unit is 16 px, so that her box is 20 x 32 px. Her right side, the box's x axis, is where the gun points. */
export function drawAstronaut(brush: Brush, colours: Colours): void {
  const px = 1 / 16;
  const part = (x: number, y: number, width: number, height: number, round: number, colour: string) => {
    brush.fillStyle = colour;
    brush.beginPath();
    brush.roundRect(x * px, y * px, width * px, height * px, round * px);
    brush.fill();
  };
  part(-10, -6, 6, 13, 2, colours.suitShade);
  part(-6, 5, 5, 11, 2, colours.suitShade);
  part(1, 5, 5, 11, 2, colours.suit);
  part(-7, -4, 14, 13, 3, colours.suit);
  part(-4, -1, 8, 4, 1, colours.suitShade);
  part(2, 0, 8, 4, 2, colours.suit);
  part(5, -1, 5, 3, 1, '#39424f');
  brush.fillStyle = colours.suit;
  disc(brush, 0, -9.5 * px, 6.5 * px);
  part(-2, -13, 8, 7, 3, colours.visor);
  part(0, -12, 3, 2, 1, '#fff2cf');
}

/** A grain of light, for beams and bursts. */
export function drawSpark(brush: Brush): void {
  fadingDisc(brush, 1, [
    [0, '#ffffff'],
    [0.4, faint('#ffffff', 0.7)],
    [1, faint('#ffffff', 0)],
  ]);
}
