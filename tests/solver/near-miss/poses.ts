import { BOX } from './near-miss.ts';

/** Distance between her box at an angle and a point. */
function gapTo(px: number, py: number, angle: number): number {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = Math.max(0, Math.abs(px * c + py * s) - BOX.halfWidth);
  const across = Math.max(0, Math.abs(py * c - px * s) - BOX.halfHeight);
  return Math.hypot(along, across);
}

/**
 * The radius that novae at given places around the black hole need so that no box touches it clear of all of them, found by
 * trying poses; a lower bound.
 */
export function radiusNeeded(novae: readonly (readonly [number, number])[], radius: number): number {
  let needed = 0;
  for (let i = 0; i < 60; i++) {
    const angle = (i * Math.PI) / 60;
    for (let j = 0; j < 120; j++) {
      const way = (j * Math.PI) / 60;
      // From the inside outwards, to where the box leaves the black hole.
      let [near, far] = [0, radius + BOX.halfDiagonal];
      for (let n = 0; n < 40; n++) {
        const d = (near + far) / 2;
        if (gapTo(-d * Math.cos(way), -d * Math.sin(way), angle) < radius) near = d;
        else far = d;
      }
      const [x, y] = [near * Math.cos(way), near * Math.sin(way)];
      needed = Math.max(needed, Math.min(...novae.map(([nx, ny]) => gapTo(nx - x, ny - y, angle))));
    }
  }
  return needed;
}
