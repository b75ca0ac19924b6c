/**
 * What players teach about a level: how often they succeed, and where, when and why they fail.
 *
 * @module
 */
export { type Attempt, type FailureCause, isAttempt, type PlayedBy, type RefusedPlay } from './attempt.ts';
export type { EdgeStatistics, Quartiles } from './edges.ts';
export type { FailureCluster } from './failures.ts';
export { type FittedPlayers, fitToPlays, observe } from './fit-to-plays.ts';
export { compareWithModel, type ModelComparison } from './model.ts';
export { createPlayReplayer, type PlayReplayer } from './replay.ts';
export type { Reference } from './routes.ts';
export { collectStatistics, type PlayStatistics } from './statistics.ts';
