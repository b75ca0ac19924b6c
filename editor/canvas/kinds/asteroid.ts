import { Circle, Flame } from 'lucide-react';
import { DRAWINGS } from '../../../phaser/index.ts';
import { isVariant } from '../../../schema/index.ts';
import { type KindOnCanvas, put } from './kind-on-canvas.ts';

/** An asteroid in one of several shapes, with a glow if it is hot. During a run it is shown where the recoil has moved it. */
export const asteroid: KindOnCanvas = {
  sign: { Icon: Circle, tone: 'quiet' },
  variantSign: { Icon: Flame, tone: 'bad' },
  parts: ({ kind, key, object }) => DRAWINGS.asteroid.parts({ hot: isVariant(kind, object) }, key),
  pose(figure, pose) {
    const { index } = figure.found;
    const moved = pose !== null && pose.asteroids !== null && pose.asteroids.length > 2 * index;
    if (moved) put(figure, pose.asteroids[2 * index], pose.asteroids[2 * index + 1]);
    else put(figure, figure.at.x, figure.at.y);
  },
};
