import type { Level } from '../../schema/index.ts';

/** A disc in which something happens to her whose centre is in it; px in the level. */
export interface RimDisc {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** The mouths of wormholes: 2 i at (x, y) of wormhole i, 2 i + 1 at its other end. The one is where the other, which is {@link exitOf} it, leads to. */
export const mouthDiscs = ({ wormholes }: Level): readonly RimDisc[] =>
  wormholes.flatMap(({ x, y, toX, toY, radius }) => [
    { x, y, radius },
    { x: toX, y: toY, radius },
  ]);

/** The number of the mouth that one leads to. */
export const exitOf = (mouth: number): number => (mouth % 2 === 0 ? mouth + 1 : mouth - 1);

/** Winds and mouths: those ways to prove that follow neither keep out of all of them. */
export const rimDiscs = (level: Level): readonly RimDisc[] => [...level.winds, ...mouthDiscs(level)];

/** She may cross a rim by so much late, px, and a little more. */
export const RIM_SLACK = 2e-6;
