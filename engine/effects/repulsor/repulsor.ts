import { SLOTS } from '../../motion/index.ts';
import { whereAny } from '../count.ts';
import type { EngineEffect } from '../effect.ts';
import { changeFields, enterFields } from './fields.ts';
import { repulsorPush } from './force.ts';
import { fieldFrame } from './frame.ts';
import { comeOffRim, enterField, followRim, leaveField } from './rims.ts';
import { setRim } from './slide.ts';

const { RIM } = SLOTS;

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
  setRim,
  events: [enterField, leaveField, comeOffRim],
  layOut: enterFields,
  moved: changeFields,
};
