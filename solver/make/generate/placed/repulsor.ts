import type { PlacedKind } from './placed-kind.ts';

export const repulsor = {
  kind: 'repulsor',
  list: 'repulsors',
  isUsual: true,
  isSolid: true,
  turn: 1,
  make({ between, inPlay, isFree }) {
    const field = { ...inPlay(), radius: between(0, 1) === 0 ? 32 : 48 };
    return isFree(field) ? field : null;
  },
} as const satisfies PlacedKind;
