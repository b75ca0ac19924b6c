import { whereAny } from '../count.ts';
import type { EngineEffect } from '../effect.ts';
import { arriveInMouths, enterMouth, leaveMouth, startInMouths } from './events.ts';
import { wormholeFrame } from './frame.ts';
import { mouthsOf, preparedMouths } from './mouths.ts';

export const wormholes: EngineEffect = {
  name: 'wormholes',
  summary: () => 'when her centre enters one mouth, she goes on from the other, with her velocity and angle',
  calledFor: whereAny('wormholes', 'wormhole'),
  jumps: true,
  tells: { jump: (index) => `goes through wormhole ${index + 1}` },
  prepare: mouthsOf,
  circles: preparedMouths,
  frame: wormholeFrame,
  events: [enterMouth, leaveMouth],
  stateLength: ({ level }) => level.wormholes.length,
  layOut: startInMouths,
  moved: arriveInMouths,
};
