import type { Level } from '../../schema/basics/index.ts';

/** A disc in which an effect acts on her while her centre is inside; px of the level. */
export interface RimDisc {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** The mouths of all wormholes: number 2 i lies at (x, y) of wormhole i, number 2 i + 1 at its other end. */
export const mouthDiscs = ({ wormholes }: Level): readonly RimDisc[] =>
  wormholes.flatMap(({ x, y, toX, toY, radius }) => [
    { x, y, radius },
    { x: toX, y: toY, radius },
  ]);

/** The mouth at the other end of the same wormhole. */
export const exitOf = (mouth: number): number => (mouth % 2 === 0 ? mouth + 1 : mouth - 1);

/** The discs of winds and mouths. Provers that follow neither keep clear of all of them. */
export const rimDiscs = (level: Level): readonly RimDisc[] => [...level.winds, ...mouthDiscs(level)];

/** How late the engine may notice that she crosses a rim, px, and a little more. */
export const RIM_SLACK = 2e-6;
