import { CircleDashed } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

export const repulsor: KindOnCanvas = {
  sign: { Icon: CircleDashed, tone: 'unknown' },
  parts: DRAWINGS.repulsor.parts,
};
