import type { Level } from '../../schema/index.ts';
import type { PeerOutcome } from './peer.ts';

/** A circle whose overlap with the astronaut an engine must report; `ends` is the outcome of touching it, null for none. */
export interface Touchable {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly ends: PeerOutcome;
}

/** Every circle of a level: black hole, novae, asteroids, minerals. Cold asteroids and minerals end nothing. */
export function touchables(level: Level): Touchable[] {
  const place = (c: { x: number; y: number; radius: number }, ends: PeerOutcome): Touchable => ({
    x: c.x,
    y: c.y,
    radius: c.radius,
    ends,
  });
  return [
    place(level.blackHole, 'completed'),
    ...level.novae.map((c) => place(c, 'collided')),
    ...level.asteroids.map((c) => place(c, c.hot ? 'collided' : null)),
    ...level.minerals.map((c) => place(c, null)),
  ];
}
