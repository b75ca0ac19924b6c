import { Sun } from 'lucide-react';
import { DRAWINGS, TEXTURE_UNIT } from '../../../phaser/index.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

/** px of screen below which a nova does not turn: it would not be visible, and images at rest cost next to nothing */
const TURNS_FROM = 10;

/** A dwarf nova with a glow; it turns. */
export const nova: KindOnCanvas = {
  sign: { Icon: Sun, tone: 'bad' },
  parts: DRAWINGS.nova.parts,
  turn({ found, images: [body] }, time, zoom) {
    if (TEXTURE_UNIT * body.scale * zoom >= TURNS_FROM) body.setRotation(DRAWINGS.nova.spin * time + found.index);
  },
};
