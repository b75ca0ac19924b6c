import type { About, Blocker } from './proof.ts';
import type { Setting, Spot } from './setting.ts';

/** A circle that is deadly to touch and covers at least this area at all times; px from the start. */
export interface StandingCircle {
  readonly of: Blocker;
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** A disc in which her centre cannot be while the run goes on. */
export interface BlockingDisc extends Spot {
  readonly of: Blocker;
}

/**
 * Everything that ends a run on contact and stands still: novae, and the part of each hot asteroid that stays covered wherever
 * recoil moves it. For a mineral the black hole is included, because touching it ends the run.
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
 * The discs in which her centre cannot be. At any angle her box contains a circle as wide as its shorter side, so each hazard
 * blocks its radius plus half that side (lemma `reach`). If she is observed once per frame only, the segment between two
 * observations outside a disc can enter it as deep as a chord of length `jump` (lemma `chord`), so the disc is reduced by that.
 */
export function blockingDiscs(setting: Setting, about: About): BlockingDisc[] {
  const { jump, leastHalf } = setting;
  return standingCircles(setting, about).flatMap(({ of, x, y, radius }) => {
    const r = radius + leastHalf;
    return r > jump / 2 ? [{ of, x, y, r: Math.sqrt(r * r - (jump * jump) / 4) }] : [];
  });
}

/** The discs of the range; she is lost outside all of them. Between two observations she may cut a corner. */
export function rangeDiscs({ level, drift, jump }: Setting): Spot[] {
  return level.asteroids.map(({ x, y }, i) => ({
    x: x - level.astronaut.x,
    y: y - level.astronaut.y,
    r: level.range + drift[i] + jump / 2,
  }));
}
