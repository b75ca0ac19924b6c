import type { Stretch } from '../stretch.ts';
import type { Mover, World } from '../world.ts';
import { expand } from './flow.ts';
import { Guards, placeAt, velocityAt } from './guards.ts';
import type { Path } from './path.ts';
import { valueAt } from './series.ts';

export { TAYLOR_TOLERANCE } from './flow.ts';

/** Motion by power series of degree 30; guards are polynomials, and their roots are isolated by bounds on derivatives. */
export function taylor(world: World): Stretch {
  const flow = expand(world);
  return {
    unit: flow.unit,
    reach: flow.reach,
    besideCentre: flow.besideCentre,
    happenings: (end, margins) => new Guards(world, flow, end, margins).found,
    bodyAt: (s) => ({
      at: placeAt(flow.her, s),
      velocity: velocityAt(flow.her, s),
      box: { x: valueAt(flow.cos, s), y: valueAt(flow.sin, s) },
    }),
    moveTo(s) {
      const move = (body: Mover, path: Path) => {
        if (path.stands) return;
        body.at = placeAt(path, s);
        body.velocity = velocityAt(path, s);
      };
      world.box = { x: valueAt(flow.cos, s), y: valueAt(flow.sin, s) };
      move(world.her, flow.her);
      for (const [i, body] of world.asteroids.entries()) move(body, flow.asteroids[i]);
      for (const [i, body] of world.aliens.entries()) move(body, flow.aliens[i]);
    },
  };
}
