import { objectName } from '../../schema/index.ts';
import type { LostMineral } from '../proofs.ts';
import type { CheckProblem } from './problem.ts';

/** The problem of a mineral that is proved to be out of reach. */
export const mineralLost = ({ index, proof }: LostMineral): CheckProblem => ({
  code: 'mineral-never-collectable',
  severity: 'warning',
  message: `nobody can collect ${objectName('mineral', index)}: ${proof.reason}`,
  hint: `this is proved (${proof.code}) and confirmed by a separate checker: move the mineral, or what keeps her from it`,
  pointer: `/minerals/${index}`,
});
