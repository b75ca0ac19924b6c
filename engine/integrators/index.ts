import type { Accuracy } from '../accuracy.ts';
import type { Integrator } from '../motion/index.ts';
import { PIECE_SHARE } from '../tolerances.ts';
import { euler } from './euler.ts';
import { rk4 } from './rk4.ts';
import { taylor } from './taylor.ts';
import { verlet } from './verlet.ts';

export { untilGrid } from './step-near.ts';

/**
 * The integrator of an accuracy.
 * @throws {RangeError} if it is none in continuous time
 */
export function integratorOf(accuracy: Accuracy): Integrator {
  switch (accuracy.integrator) {
    case 'euler':
      return euler;
    case 'verlet':
      return verlet;
    case 'rk4':
      return rk4;
    case 'taylor':
      return taylor((accuracy.tolerance ?? 1e-9) / PIECE_SHARE);
    default:
      throw new RangeError(`'${accuracy.integrator}' is not an integrator in continuous time`);
  }
}
