import { eventRule, listTouching, offerContact, quietOutside } from '../../events/index.ts';
import { GOES_ON, type Motion, placeCircle, SLOTS } from '../../motion/index.ts';
import { type EngineEffect, whereAny } from '../effect.ts';

const { MINERALS } = SLOTS;

const isCollected = (m: Motion, i: number): boolean => m.s[m.minerals + i] !== 0;

const collect = eventRule({
  name: 'mineral',
  passing: true,
  list: (m) => listTouching(m, collect, m.scene.minerals),
  isOver: isCollected,
  guard(m, i, from) {
    if (isCollected(m, i)) return;
    const { minerals } = m.scene;
    placeCircle(m, minerals.x[i], minerals.y[i], m.originX, m.originY);
    offerContact(m, minerals.r[i], 0, collect.kind, i, from);
  },
  quiet(m, i, time) {
    if (isCollected(m, i)) return time;
    const { x, y, r } = m.scene.minerals;
    return quietOutside(m, x[i] - m.originX, y[i] - m.originY, r[i] + m.touchMargin, time);
  },
  fire(m, i, _b, time) {
    m.s[m.minerals + i] = 1;
    m.s[MINERALS]++;
    m.recorder?.event({ time, type: 'mineral', index: m.scene.minerals.index[i] });
    return GOES_ON;
  },
});

export const minerals: EngineEffect = {
  name: 'minerals',
  summary: () => 'collected on touch',
  calledFor: whereAny('minerals', 'mineral'),
  collects: ({ minerals }) => minerals,
  circles: ({ minerals }) => minerals,
  events: [collect],
};
