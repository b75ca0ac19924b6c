import { eachTargetNear, eventRule, offerContact, quietOutside, rockDistanceToNear } from '../../events/index.ts';
import { placeRock } from '../../motion/index.ts';
import type { Effect } from '../effect.ts';

export const touchHot = eventRule({
  name: 'hot asteroid',
  ends: { outcome: 'collided', touches: 'asteroid' },
  list(m) {
    const { near } = m;
    const { coldCount, targets } = m.scene;
    eachTargetNear(m, near.skin + m.touchMargin, coldCount, (i) => {
      near.add(touchHot.kind, i, rockDistanceToNear(m, i) - targets.r[i] - m.touchMargin);
    });
  },
  guard(m, i, from) {
    placeRock(m, i);
    offerContact(m, m.scene.targets.r[i], m.kappa, touchHot.kind, i, from);
  },
  quiet: (m, i, time) => quietOutside(m, m.targetX[i], m.targetY[i], m.scene.targets.r[i] + m.touchMargin, time),
  fire: (m, i) => m.scene.targets.index[i],
});

export const hotAsteroids: Effect = {
  name: 'hot-asteroids',
  summary: () => 'end the run on touch, and pull like cold asteroids',
  calledFor: (level) => {
    const n = level.asteroids.filter((a) => a.hot).length;
    return n > 0
      ? { called: true, because: `${n} hot ${n === 1 ? 'asteroid' : 'asteroids'}` }
      : { called: false, because: 'no hot asteroids' };
  },
  kills: true,
  events: [touchHot],
};
