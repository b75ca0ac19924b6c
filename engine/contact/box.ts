import { DEFAULT_RULES, type Rules } from '../../schema/basics/index.ts';

/** The astronaut's collision box. Its x axis points at the target. */
export interface Box {
  /** Half its side along its x axis, px. */
  readonly halfWidth: number;
  /** Half its side across, px. */
  readonly halfHeight: number;
  /** Half its diagonal, px, rounded up. It serves as a bound: a larger value would also be right, only slower. */
  readonly halfDiagonal: number;
}

/**
 * The collision box under given rules.
 *
 * @param rules - the game's rules; `boxWidth` and `boxHeight` are used, px
 * @returns the box
 */
export function boxOf({ boxWidth, boxHeight }: Rules): Box {
  const halfWidth = boxWidth / 2;
  const halfHeight = boxHeight / 2;
  const halfDiagonal = Math.ceil(Math.sqrt(halfWidth * halfWidth + halfHeight * halfHeight) * 1000 + 1e-6) / 1000;
  return { halfWidth, halfHeight, halfDiagonal };
}

/** The original game's box: 20 x 32 px. */
export const DEFAULT_BOX: Box = boxOf(DEFAULT_RULES);
