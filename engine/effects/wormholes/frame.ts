import { TICK } from '../../constants.ts';
import type { FrameRule } from '../../frames/index.ts';
import { inMouth, OPEN, otherMouth, preparedMouths, stateAt } from './mouths.ts';

/** Wormholes in frames: while her centre is inside a mouth of an open one, she is moved at the end of the frame. */
export const wormholeFrame: FrameRule = {
  discs: preparedMouths,
  stateLength: (scene) => preparedMouths(scene).count / 2,
  layOut(scene, s, at) {
    const mouths = preparedMouths(scene);
    const { x, y } = scene.level.astronaut;
    for (let w = 0; 2 * w < mouths.count; w++) s[at + w] = stateAt(mouths, w, x, y, 0, 0, null);
  },
  isBusy(scene, s, at) {
    const count = preparedMouths(scene).count / 2;
    for (let w = 0; w < count; w++) if (s[at + w] !== OPEN) return true;
    return false;
  },
  act(frame, near, at) {
    const { scene, s } = frame;
    const mouths = preparedMouths(scene);
    const { x, y } = frame;
    for (let w = 0; 2 * w < mouths.count; w++) if (s[at + w] !== OPEN) s[at + w] = stateAt(mouths, w, x, y, 0, 0, null);
    for (const mouth of near) {
      const w = mouth >> 1;
      if (s[at + w] !== OPEN) continue;
      const dx = x - mouths.x[mouth];
      const dy = y - mouths.y[mouth];
      if (!(dx * dx + dy * dy < mouths.r[mouth] * mouths.r[mouth])) continue;
      const exit = otherMouth(mouth);
      frame.x += mouths.x[exit] - mouths.x[mouth];
      frame.y += mouths.y[exit] - mouths.y[mouth];
      for (let other = 0; 2 * other < mouths.count; other++) s[at + other] = stateAt(mouths, other, frame.x, frame.y, 0, 0, 0);
      s[at + w] = inMouth(exit);
      frame.tell?.({ time: frame.number * TICK, type: 'effect', effect: 'wormholes', what: 'jump', index: w });
      return;
    }
  },
};
