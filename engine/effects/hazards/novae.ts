import { eventRule, listTouching, offerContact, quietOutside } from '../../events/index.ts';
import { placeCircle } from '../../motion/index.ts';
import { whereAny } from '../count.ts';
import type { EngineEffect } from '../effect.ts';

export const touchNova = eventRule({
  name: 'nova',
  ends: { outcome: 'collided', touches: 'nova' },
  list: (m) => listTouching(m, touchNova, m.scene.novae),
  guard(m, i, from) {
    const { x, y, r, index } = m.scene.novae;
    placeCircle(m, x[i], y[i], m.originX, m.originY);
    offerContact(m, r[i], 0, touchNova.kind, index[i], from);
  },
  quiet(m, i, time) {
    const { x, y, r } = m.scene.novae;
    return quietOutside(m, x[i] - m.originX, y[i] - m.originY, r[i] + m.touchMargin, time);
  },
  fire: (_m, index) => index,
});

export const novae: EngineEffect = {
  name: 'novae',
  summary: () => 'end the run on touch',
  calledFor: whereAny('novae', 'nova'),
  kills: true,
  circles: ({ novae }) => novae,
  events: [touchNova],
};
