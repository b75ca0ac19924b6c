import { WARNING_CODES } from '../engine/index.ts';
import { CODES, type CodeExplanation } from '../schema/index.ts';
import { CHECK_CODES } from './check/index.ts';

/** Explanations of the codes of all problems. */
export const EXPLAINED_CODES: readonly CodeExplanation[] = [...CHECK_CODES, ...CODES, ...WARNING_CODES];
