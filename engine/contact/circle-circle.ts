/**
 * Whether two circles overlap: centre distance < r1 + r2 (touching from outside is no contact).
 * The original's `collidesCircleCircle`.
 * @param dx, dy centre of the second minus centre of the first, px
 * @param reach r1 + r2, px
 */
export function circlesOverlap(dx: number, dy: number, reach: number): boolean {
  return dx * dx + dy * dy < reach * reach;
}
