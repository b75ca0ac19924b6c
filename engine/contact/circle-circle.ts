/**
 * Tells whether two circles overlap. Touching from outside is no overlap. This is `collidesCircleCircle` of the original game.
 *
 * @param dx - x of the second centre minus x of the first, px
 * @param dy - y of the second centre minus y of the first, px
 * @param reach - sum of both radii, px
 * @returns whether they overlap
 */
export function circlesOverlap(dx: number, dy: number, reach: number): boolean {
  return dx * dx + dy * dy < reach * reach;
}
