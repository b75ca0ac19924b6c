import type { Player } from '../../../game/index.ts';
import type { Pose } from '../../core/context/index.ts';

/** What the canvas and the readout show of a player. */
export interface ShownPlayer {
  /** Minerals that are collected, each counted once. */
  minerals(): number;
  /** px/s */
  speed(): number;
  /** The positions now, which may be between two ticks. */
  pose(): Pose;
  /** The tick of the positions, with a fraction. */
  moment(): number;
}

export function showPlayer(player: Player): ShownPlayer {
  const { level } = player;
  const pose = new Float64Array(player.state.length);
  const aliens = level.aliens.length > 0 ? new Float64Array(3 * level.aliens.length) : null;
  const asteroids = level.recoil ? new Float64Array(2 * level.asteroids.length) : null;
  const taken = new Set<number>();
  let { events } = player;
  let read = 0;
  const collected = () => {
    // a restart begins another list
    if (player.events !== events || read > events.length) {
      events = player.events;
      read = 0;
      taken.clear();
    }
    for (; read < events.length; read++) {
      const event = events[read];
      if (event.type === 'mineral') taken.add(event.index);
    }
    return taken;
  };
  return {
    minerals: () => collected().size,
    // the pose lies between the last tick and the one before
    moment: () => (player.ending === null ? Math.max(0, player.tick - 1 + player.alpha) : player.tick),
    speed: () => Math.hypot(player.state[2], player.state[3]),
    pose() {
      player.readPose(pose);
      if (aliens !== null) player.readAliens(aliens);
      if (asteroids !== null) player.readAsteroids(asteroids);
      const [x, y, , , cos, sin] = pose;
      const target = player.ending === null ? player.target : null;
      const place = (index: number) =>
        asteroids === null ? level.asteroids[index] : { x: asteroids[2 * index], y: asteroids[2 * index + 1] };
      return { x, y, cos, sin, beamTo: target === null ? null : place(target), aliens, asteroids, collected: collected() };
    },
  };
}
