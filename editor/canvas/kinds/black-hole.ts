import { Orbit } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

/** The black hole with its arms, which reach to twice its radius; it turns. */
export const blackHole: KindOnCanvas = {
  sign: { Icon: Orbit, tone: 'unknown' },
  parts: DRAWINGS.blackHole.parts,
  turn: ({ images: [body] }, time) => void body.setRotation(DRAWINGS.blackHole.spin * time),
};
