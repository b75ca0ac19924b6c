import type { Stretch } from '../stretch.ts';
import type { Mover, World } from '../world.ts';
import { Bracketing } from './guards.ts';
import { Motion } from './motion.ts';

export { GAUSS_TOLERANCE } from './collocation.ts';

/** Motion by Gauss collocation of order 32; what happens is bracketed between moments of it. */
export function gauss(world: World): Stretch {
  const motion = new Motion(world);
  return {
    unit: 1,
    reach: motion.reach,
    besideCentre: motion.besideCentre,
    happenings: (end, margins) => new Bracketing(motion, end, margins).find(world),
    bodyAt(s) {
      const { her, box } = motion.at(s);
      return { at: her.at, velocity: her.velocity, box };
    },
    moveTo(s) {
      const moment = motion.at(s);
      const moved = ({ at, velocity }: Mover): Mover => ({ at, velocity });
      const hers = moved(moment.her);
      const asteroids = world.asteroids.map((_, i) => moved(moment.asteroid(i)));
      const aliens = world.aliens.map((_, i) => moved(moment.alien(i)));
      Object.assign(world.her, hers);
      world.box = moment.box;
      for (const [i, body] of world.asteroids.entries()) Object.assign(body, asteroids[i]);
      for (const [i, body] of world.aliens.entries()) Object.assign(body, aliens[i]);
    },
  };
}
