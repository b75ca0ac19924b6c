import { compile } from '../../../engine/index.ts';
import { findSlackInSteps } from '../../../solver/index.ts';
import type { Start } from '../work.ts';

/** How far each press and release of a run may slip alone. */
export const slack: Start<'slack'> = ({ level, terms, holds, goal }) => findSlackInSteps(compile(level, terms), holds, goal);
