import { whereAny } from '../count.ts';
import type { EngineEffect } from '../effect.ts';
import { AlienCrowd } from './crowd.ts';
import { fallAsleep, layOutAliens, touchAlien, wake } from './events.ts';

export const alienChase: EngineEffect = {
  name: 'alien-chase',
  summary: ({ alienSight, alienPull }) =>
    `an alien within ${alienSight} px accelerates towards her at ${alienPull} px/s2, otherwise it stops dead; touching it ends the run`,
  calledFor: whereAny('aliens', 'alien'),
  rules: ['alienPull', 'alienSight'],
  chase: {
    kind: 'alien',
    circles: ({ aliens }) => aliens,
    pull: ({ alienPull }) => alienPull,
    sight: ({ alienSight }) => alienSight,
  },
  moves: true,
  kills: true,
  events: [touchAlien, wake, fallAsleep],
  attach(m) {
    m.crowd = new AlienCrowd(m);
  },
  layOut: layOutAliens,
};
