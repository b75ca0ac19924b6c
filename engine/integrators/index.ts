import type { Accuracy } from '../accuracy.ts';
import type { Integrator } from '../motion/index.ts';
import { euler } from './euler.ts';
import { rk4 } from './rk4.ts';
import { taylorOf } from './taylor.ts';
import { verlet } from './verlet.ts';

export { untilGrid } from './fixed-step.ts';
export { taylorOf } from './taylor.ts';

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
      return taylorOf(accuracy);
    default:
      throw new RangeError(`'${accuracy.integrator}' is not an integrator in continuous time`);
  }
}
