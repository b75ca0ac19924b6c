import { TICK } from '../../constants.ts';
import { circlesOverlap } from '../../contact/index.ts';
import type { FrameRule } from '../../frames/index.ts';

/** Fields in frames: the first in the level's list that contains her centre pushes her, instead of whatever else acts. */
export const fieldFrame: FrameRule = {
  discs: (scene) => scene.repulsors,
  isWork: true,
  // the field that was last told of, or -1
  stateLength: () => 1,
  layOut(_scene, s, at) {
    s[at] = -1;
  },
  act(frame, near, at) {
    const { x: hersX, y: hersY, scene } = frame;
    let field = -1;
    if (near.length > 0) {
      const { x, y, r } = scene.repulsors;
      const { push } = scene.rules;
      for (let k = 0; k < near.length; k++) {
        const i = near[k];
        const dx = hersX - x[i];
        const dy = hersY - y[i];
        if (!circlesOverlap(dx, dy, r[i])) continue;
        const d = Math.sqrt(dx * dx + dy * dy);
        frame.ax = d > 0 ? (push * dx) / d : push;
        frame.ay = d > 0 ? (push * dy) / d : 0;
        field = i;
        break;
      }
    }
    const { s, tell } = frame;
    if (tell === null || s[at] === field) return;
    const time = frame.number * TICK;
    if (s[at] >= 0) tell({ time, type: 'leave', index: s[at] });
    if (field >= 0) tell({ time, type: 'enter', index: field });
    s[at] = field;
  },
};
