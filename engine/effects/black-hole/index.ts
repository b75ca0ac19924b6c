import { distanceToNear, eventRule, offerContact, quietOutside } from '../../events/index.ts';
import { placeCircle } from '../../motion/index.ts';
import type { Effect } from '../effect.ts';

const touchBlackHole = eventRule({
  name: 'black hole',
  ends: { outcome: 'completed', touches: 'blackHole' },
  list(m) {
    const { x, y, radius } = m.scene.level.blackHole;
    m.near.add(touchBlackHole.kind, 0, distanceToNear(m, x, y) - radius - m.touchMargin);
  },
  guard(m, _i, from) {
    const { x, y, radius } = m.scene.level.blackHole;
    placeCircle(m, x, y, m.originX, m.originY);
    offerContact(m, radius, 0, touchBlackHole.kind, 0, from);
  },
  quiet(m, _i, time) {
    const { x, y, radius } = m.scene.level.blackHole;
    return quietOutside(m, x - m.originX, y - m.originY, radius + m.touchMargin, time);
  },
  fire: () => 0,
});

export const blackHole: Effect = {
  name: 'black-hole',
  summary: () => 'touching it completes the level',
  calledFor: () => ({ called: true, because: 'every level has one' }),
  events: [touchBlackHole],
};
