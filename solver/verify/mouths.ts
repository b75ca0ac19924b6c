import type { Level } from '../../schema/index.ts';
import type { Claim } from './claim.ts';
import type { Point } from './rounded.ts';

/** The disc in which a wormhole takes her centre to another, px from the start. */
export interface Mouth extends Point {
  readonly radius: number;
  /** the centre of the other: she comes out of it as far from there as she was from here */
  readonly exit: Point;
}

/** The mouths of the level: those at the near end of wormhole i are number 2 i, at the far end 2 i + 1. Lemma `mouths`. */
export function mouthsOf({
  level,
  place,
}: Pick<Claim, 'place'> & { readonly level: Pick<Level, 'wormholes'> }): readonly Mouth[] {
  return level.wormholes.flatMap(({ x, y, toX, toY, radius }) => {
    const near = place({ x, y });
    const far = place({ x: toX, y: toY });
    return [
      { ...near, radius, exit: far },
      { ...far, radius, exit: near },
    ];
  });
}
