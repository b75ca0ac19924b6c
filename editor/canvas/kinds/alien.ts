import { Bug } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import { type KindOnCanvas, put } from './kind-on-canvas.ts';

/** px of screen by which a pupil moves at least */
const GAZE = 0.25;

/** An alien that looks at her. During a run it is shown where it has chased her, and faint after its explosion. */
export const alien: KindOnCanvas = {
  sign: { Icon: Bug, tone: 'good' },
  parts: DRAWINGS.alien.parts,
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
