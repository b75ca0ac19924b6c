import { DEFAULT_RULES, type Rules } from '../../schema/index.ts';

/** The astronaut's box, px: half its sides along its x axis (which points at the target) and across, and half its diagonal. */
export interface Box {
  readonly halfWidth: number;
  readonly halfHeight: number;
  /** Rounded up. Any larger bound is right too, only slower. */
  readonly halfDiagonal: number;
}

/** The box that these rules give her. */
export function boxOf({ boxWidth, boxHeight }: Rules): Box {
  const halfWidth = boxWidth / 2;
  const halfHeight = boxHeight / 2;
  const halfDiagonal = Math.ceil(Math.sqrt(halfWidth * halfWidth + halfHeight * halfHeight) * 1000 + 1e-6) / 1000;
  return { halfWidth, halfHeight, halfDiagonal };
}

/** The original game's box: 20 x 32 px. */
export const DEFAULT_BOX: Box = boxOf(DEFAULT_RULES);
