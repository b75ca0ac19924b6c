import { Gem } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

/** A mineral with its light; faint once it is collected. */
export const mineral: KindOnCanvas = {
  sign: { Icon: Gem, tone: 'accent' },
  parts: DRAWINGS.mineral.parts,
  pose: ({ found, images: [body] }, pose) => void body.setAlpha(pose?.collected.has(found.index) === true ? 0.18 : 1),
};
