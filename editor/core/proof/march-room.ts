import { STATE_SIZE } from '../../../engine/index.ts';
import { Tracks } from './tracks.ts';

/**
 * Arrays for trajectories and snapshots. They are reused from scene to scene: a large level would allocate megabytes with every
 * move of the pointer.
 */
export class MarchRoom {
  states = new Float64Array(0);
  held = new Uint8Array(0);
  readonly aliens = new Tracks(3);
  readonly asteroids = new Tracks(2);
  readonly snapshots: Float64Array[] = [];
  alienState = new Float64Array(0);
  asteroidState = new Float64Array(0);

  /** Prepares the arrays for a scene and discards those of another one. */
  prepare(aliens: number, asteroids: number): void {
    this.aliens.clear(aliens);
    this.asteroids.clear(asteroids);
    this.alienState = new Float64Array(aliens * this.aliens.size);
    this.asteroidState = new Float64Array(asteroids * this.asteroids.size);
  }

  /** Makes room for a number of entries. */
  grow(entries: number): void {
    if (this.held.length >= entries) return;
    const room = Math.max(entries, 2 * this.held.length, 1202);
    const states = new Float64Array(STATE_SIZE * room);
    states.set(this.states);
    this.states = states;
    const held = new Uint8Array(room);
    held.set(this.held);
    this.held = held;
  }
}
