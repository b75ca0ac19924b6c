import type { Level } from '../../schema/basics/index.ts';
import type { Claim } from './claim.ts';
import type { Point } from './rounded.ts';

/** A mouth of a wormhole: a disc from which her centre is moved to another disc. Its centre is px from the start. */
export interface Mouth extends Point {
  readonly radius: number;
  /** Centre of the other mouth. She comes out at the same place relative to it. */
  readonly exit: Point;
}

/** The mouths of the level: the near end of wormhole i is number 2 i, its far end 2 i + 1 (lemma `mouths`). */
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
