import { Wind } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import { KINDS } from '../../../schema/index.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

const usual = (name: string): number => {
  const field = KINDS.wind.fields[name];
  return field.type === 'number' ? (field.default ?? 0) : 0;
};

/** A disc with streaks in the direction of the wind, larger for stronger winds; a small ring for a wind of strength 0. */
export const wind: KindOnCanvas = {
  sign: { Icon: Wind, tone: 'accent' },
  parts({ object }) {
    const { ax = usual('ax'), ay = usual('ay') } = object as { ax?: number; ay?: number };
    return DRAWINGS.wind.parts({ ax, ay });
  },
};
