import { whereAny } from '../count.ts';
import type { Effect, EngineEffect } from '../effect.ts';
import { AlienCrowd } from './crowd.ts';
import { explode, fallAsleep, layOutAliens, touchAlien, wake } from './events.ts';

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

export const alienExplosion: Effect = {
  name: 'alien-explosion',
  summary: () => 'two aliens that touch explode',
  calledFor: (level) => {
    const n = level.aliens.length;
    return n > 1 ? { called: true, because: `${n} aliens` } : { called: false, because: 'fewer than two aliens' };
  },
  events: [explode],
};
