import { Infinity as Loop } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

/** Both mouths look alike and turn. */
export const wormhole: KindOnCanvas = {
  sign: { Icon: Loop, tone: 'accent' },
  parts: DRAWINGS.wormhole.parts,
  turn: ({ images: [body] }, time) => void body.setRotation(DRAWINGS.wormhole.spin * time),
};
