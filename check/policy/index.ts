/**
 * Decides which problems count: what a configuration says about their severity, and what a level allows. Verdicts are not
 * decided here, and nothing here makes a level completable.
 *
 * @module
 */
export { applyPolicy } from './apply-policy.ts';
