import { TICK } from '../../constants.ts';
import { circlesOverlap } from '../../contact.ts';
import type { FrameRule } from '../../frames.ts';
import { type CentralForce, rebase, SLOTS } from '../../motion/index.ts';
import { type EngineEffect, whereAny } from '../effect.ts';
import { changeFields, comeOffRim, enterField, enterFields, followRim, leaveField, setRim } from './fields.ts';
import { arriveOnRim, expandSlide, RimFlow } from './slide.ts';
import { letGoTime } from './slide-ends.ts';

const { FIELD, RIM } = SLOTS;

/** The push of a field away from its centre, equally strong everywhere in it. */
const repulsorPush: CentralForce = {
  acts: 'instead',
  strongest: (_level, { push }) => push,
  isActing: ({ s }) => s[FIELD] >= 0,
  centre(m) {
    const { x, y } = m.scene.repulsors;
    const field = m.s[FIELD];
    rebase(m, -1, x[field] - m.originX, y[field] - m.originY, 0, 0);
  },
  set({ flow, rules }) {
    flow.alpha = rules.push;
    flow.beta = 0;
    flow.range = 0;
    flow.extra = rules.push;
  },
  swing: () => Number.POSITIVE_INFINITY,
};

/** Fields in frames: the first in the level's list that contains her centre pushes her, instead of whatever else acts. */
const fieldFrame: FrameRule = {
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

export const repulsor: EngineEffect = {
  name: 'repulsor',
  summary: ({ push }) => `pushes her away at ${push} px/s2 while her centre is inside, instead of the gun`,
  calledFor: whereAny('repulsors', 'repulsor'),
  rules: ['push'],
  force: repulsorPush,
  frame: fieldFrame,
  circles: ({ repulsors }) => repulsors,
  // a flag for each field: whether it contains her
  stateLength: ({ repulsors }) => repulsors.count,
  beforePiece(m) {
    if (m.s[RIM] >= 0) followRim(m);
  },
  attach(m) {
    m.rim = new RimFlow();
  },
  sliding: { set: setRim, expand: expandSlide, arrive: arriveOnRim, letGo: letGoTime },
  events: [enterField, leaveField, comeOffRim],
  layOut: enterFields,
  moved: changeFields,
};
