import { whereAny } from '../count.ts';
import type { EngineEffect } from '../effect.ts';
import { preparedWinds, windsOf } from './discs.ts';
import { enterWind, feelWinds, leaveWind, stateLength, wind } from './events.ts';
import { windFrame } from './frame.ts';

export const winds: EngineEffect = {
  name: 'winds',
  summary: () => 'a steady acceleration while her centre is inside, added to whatever else acts on her',
  calledFor: whereAny('winds', 'wind'),
  force: wind,
  tells: {
    enter: (index) => `enters wind ${index + 1}`,
    leave: (index) => `leaves wind ${index + 1}`,
  },
  prepare: windsOf,
  circles: preparedWinds,
  frame: windFrame,
  events: [enterWind, leaveWind],
  stateLength,
  layOut: (m) => feelWinds(m, null),
  moved: feelWinds,
};
