import { eventRule, listTouching, offerContact, quietOutside, rockDistanceToNear, targetsNear } from '../../events/index.ts';
import { placeCircle, placeRock } from '../../motion/index.ts';
import { type EngineEffect, whereAny } from '../effect.ts';

const touchNova = eventRule({
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
  hazard: ({ novae }) => ({ kind: 'nova', circles: novae, first: 0, movedBy: 'nothing' }),
  circles: ({ novae }) => novae,
  events: [touchNova],
};

const touchHot = eventRule({
  name: 'hot asteroid',
  ends: { outcome: 'collided', touches: 'asteroid' },
  list(m) {
    const { near } = m;
    const { coldCount, targets } = m.scene;
    const found = targetsNear(m, touchHot, near.skin + m.touchMargin, coldCount);
    for (let k = 0; k < found.length; k++) {
      const i = found[k];
      if (i < coldCount) continue;
      near.add(touchHot.kind, i, rockDistanceToNear(m, i) - targets.r[i] - m.touchMargin);
    }
  },
  guard(m, i, from) {
    placeRock(m, i);
    offerContact(m, m.scene.targets.r[i], m.kappa, touchHot.kind, i, from);
  },
  quiet: (m, i, time) => quietOutside(m, m.targetX[i], m.targetY[i], m.scene.targets.r[i] + m.touchMargin, time),
  fire: (m, i) => m.scene.targets.index[i],
});

export const hotAsteroids: EngineEffect = {
  name: 'hot-asteroids',
  summary: () => 'end the run on touch, and pull like cold asteroids',
  calledFor: (level) => {
    const n = level.asteroids.filter((a) => a.hot).length;
    return n > 0
      ? { called: true, because: `${n} hot ${n === 1 ? 'asteroid' : 'asteroids'}` }
      : { called: false, because: 'no hot asteroids' };
  },
  kills: true,
  hazard: ({ targets, coldCount }) => ({ kind: 'asteroid', circles: targets, first: coldCount, movedBy: 'recoil' }),
  events: [touchHot],
};
