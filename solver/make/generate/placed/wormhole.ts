import { distance, type PlacedKind } from './placed-kind.ts';

/** px between the centres of both mouths, at least. */
const MOUTHS_APART = 160;

/** Both mouths lie where she may pass, and keep their distance from everything else. */
export const wormhole = {
  kind: 'wormhole',
  list: 'wormholes',
  isUsual: false,
  isSolid: true,
  turn: 4,
  make({ between, inPlay, isFree }) {
    const radius = between(0, 1) === 0 ? 24 : 32;
    const [mouth, other] = [inPlay(), inPlay()];
    if (distance(mouth, other) < MOUTHS_APART) return null;
    if (!isFree({ ...mouth, radius }) || !isFree({ ...other, radius })) return null;
    return { ...mouth, toX: other.x, toY: other.y, radius };
  },
} as const satisfies PlacedKind;
