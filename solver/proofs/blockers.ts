import type { About, Blocker } from './proof.ts';
import type { Disc, Setting } from './setting.ts';

/** A circle that ends the run on touch, and covers this much all the time; px from the start. */
export interface StandingCircle {
  readonly of: Blocker;
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** A disc in which her centre can't be while the run goes on, and whose it is. */
export interface BlockingDisc extends Disc {
  readonly of: Blocker;
}

/**
 * What ends the run on touch and stands still: novae, and hot asteroids as far as they cover the same place wherever recoil moves
 * them. For a mineral the black hole is one too: touching it ends the run.
 */
export function standingCircles({ level, drift }: Setting, about: About): StandingCircle[] {
  const circles: StandingCircle[] = [];
  const add = (of: Blocker, { x, y }: { x: number; y: number }, radius: number) => {
    if (radius > 0) circles.push({ of, x: x - level.astronaut.x, y: y - level.astronaut.y, radius });
  };
  for (const [index, nova] of level.novae.entries()) add({ kind: 'nova', index }, nova, nova.radius);
  for (const [index, asteroid] of level.asteroids.entries()) {
    if (asteroid.hot) add({ kind: 'asteroid', index }, asteroid, asteroid.radius - drift[index]);
  }
  if (about.kind === 'mineral') add({ kind: 'blackHole', index: 0 }, level.blackHole, level.blackHole.radius);
  return circles;
}

/**
 * The discs in which her centre can't be. Her box holds a circle about its centre as wide as its shorter side, however it is turned: so each
 * hazard blocks its radius and half that side more. Where she is looked at once a frame only, the straight way from one look to the
 * next stays out of a somewhat smaller disc: a chord of length `jump` cuts that deep.
 */
export function blockingDiscs(setting: Setting, about: About): BlockingDisc[] {
  const { jump, leastHalf } = setting;
  return standingCircles(setting, about).flatMap(({ of, x, y, radius }) => {
    const r = radius + leastHalf;
    return r > jump / 2 ? [{ of, x, y, r: Math.sqrt(r * r - (jump * jump) / 4) }] : [];
  });
}

/** The discs of the range: outside all of them she is lost. Between two looks she may cut a corner. */
export function rangeDiscs({ level, drift, jump }: Setting): Disc[] {
  return level.asteroids.map(({ x, y }, i) => ({
    x: x - level.astronaut.x,
    y: y - level.astronaut.y,
    r: level.range + drift[i] + jump / 2,
  }));
}
