import { type Brush, disc, faint } from './brush.ts';
import type { GameColours } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/** An alien without its pupil, which is an image of its own and follows her. */
function drawAlien(brush: Brush, colours: GameColours): void {
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

/** The pupil of an alien. */
function drawPupil(brush: Brush): void {
  brush.fillStyle = '#142014';
  disc(brush, 0, 0, 0.9);
  brush.fillStyle = '#ffffff';
  disc(brush, -0.3, -0.35, 0.28);
}

/** An alien that is awake; its pupil looks at her. */
export const alien: KindDrawing = {
  textures: { alien: drawAlien, pupil: drawPupil },
  parts: () => [
    { texture: 'alien', depth: 7 },
    { texture: 'pupil', depth: 7, scale: 0.2, offset: { x: 0, y: -0.05 } },
  ],
  spin: 0,
};
