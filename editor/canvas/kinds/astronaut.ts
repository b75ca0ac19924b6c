import { PersonStanding } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

/** Only her icon: a layer of her own shows her, with the beam of the gun. */
export const astronaut: KindOnCanvas = {
  sign: { Icon: PersonStanding, tone: 'quiet' },
  parts: DRAWINGS.astronaut.parts,
};
