import { Bug } from 'lucide-react';
import { type Brush, disc, faint } from '../brush.ts';
import type { Colours } from '../colours.ts';
import { type KindOnCanvas, put } from './kind-on-canvas.ts';

/** px of screen by which a pupil moves at least */
const GAZE = 0.25;

/** An alien without its pupil, which is an image of its own and follows her. */
function drawAlien(brush: Brush, colours: Colours): void {
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

/** An alien that looks at her. During a run it is shown where it has chased her, and faint after its explosion. */
export const alien: KindOnCanvas = {
  sign: { Icon: Bug, tone: 'good' },
  textures: { alien: drawAlien, pupil: drawPupil },
  parts: () => [
    { texture: 'alien', depth: 7 },
    { texture: 'pupil', depth: 7, scale: 0.2, offset: { x: 0, y: -0.05 } },
  ],
  pose(figure, pose, zoom) {
    const { index } = figure.found;
    const moved = pose !== null && pose.aliens !== null && pose.aliens.length > 3 * index;
    const x = moved ? pose.aliens[3 * index] : figure.at.x;
    const y = moved ? pose.aliens[3 * index + 1] : figure.at.y;
    for (const image of figure.images) image.setAlpha(moved && pose.aliens[3 * index + 2] === 0 ? 0.2 : 1);
    const dx = (pose?.x ?? x) - x;
    const dy = (pose?.y ?? y) - y;
    const distance = Math.hypot(dx, dy);
    const reach = distance > 0 ? (0.16 * figure.radius) / distance : 0;
    const gaze = figure.away[1];
    // A smaller change would not be visible, and images that only move cost next to nothing.
    if (zoom * Math.hypot(dx * reach - gaze.x, dy * reach - gaze.y) > GAZE) {
      gaze.x = dx * reach;
      gaze.y = dy * reach;
    }
    put(figure, x, y);
  },
};
