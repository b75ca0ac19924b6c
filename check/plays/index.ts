/**
 * What players teach about a level: how often they succeed, and where, when and why they fail.
 *
 * @module
 */
export { type Attempt, type FailureCause, isAttempt, type RefusedPlay } from './attempt.ts';
export type { PlayedBy } from './by-attempt.ts';
export type { FailureCluster } from './clusters.ts';
export type { EdgeStatistics } from './edges.ts';
export { type FittedPlayers, fitToPlays, observe } from './fit-to-plays.ts';
export { compareWithModel, type ModelComparison } from './model.ts';
export type { Quartiles } from './quartiles.ts';
export type { Reference } from './reference.ts';
export { createPlayReplayer, type PlayReplayer } from './replay.ts';
export { collectStatistics, type PlayStatistics, statisticsOf } from './statistics.ts';
