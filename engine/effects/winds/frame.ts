import { TICK } from '../../constants.ts';
import type { Frame, FrameRule } from '../../frames/index.ts';
import { preparedWinds } from './discs.ts';

/** Winds in frames: while her centre is inside one, its acceleration is added to everything else that acts. */
export const windFrame: FrameRule = {
  discs: preparedWinds,
  stateLength: (scene) => preparedWinds(scene).count,
  layOut(scene, s, at) {
    const winds = preparedWinds(scene);
    const { x, y } = scene.level.astronaut;
    for (let i = 0; i < winds.count; i++) s[at + i] = isInside(winds, i, x, y) ? 1 : 0;
  },
  isBusy(scene, s, at) {
    const { count } = preparedWinds(scene);
    for (let i = 0; i < count; i++) if (s[at + i] === 1) return true;
    return false;
  },
  act(frame, near, at) {
    const { scene, s, x, y } = frame;
    const winds = preparedWinds(scene);
    for (let i = 0; i < winds.count; i++) {
      if (s[at + i] === 0 || isInside(winds, i, x, y)) continue;
      s[at + i] = 0;
      tell(frame, 'leave', i);
    }
    for (let k = 0; k < near.length; k++) {
      const i = near[k];
      if (!isInside(winds, i, x, y)) continue;
      frame.ax += winds.ax[i];
      frame.ay += winds.ay[i];
      if (s[at + i] === 1) continue;
      s[at + i] = 1;
      tell(frame, 'enter', i);
    }
  },
};

const tell = (frame: Frame, what: string, index: number): void =>
  frame.tell?.({ time: frame.number * TICK, type: 'effect', effect: 'winds', what, index });

function isInside({ x, y, r }: ReturnType<typeof preparedWinds>, i: number, hersX: number, hersY: number): boolean {
  const dx = hersX - x[i];
  const dy = hersY - y[i];
  return dx * dx + dy * dy < r[i] * r[i];
}
