import { VERDICT_MEANS } from '../../check/words/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { isFailing } from '../show-failure/index.ts';
import type { BuiltPack } from './check-pack.ts';

/** Whether nobody can play a level, so that it is never built. */
export const isUnplayable = ({ verdict }: CheckedLevel): boolean => verdict === 'invalid' || verdict === 'crashed';

/** The levels because of which nothing is built: with `force` only those that nobody can play. */
export const refusedOf = ({ levels }: BuiltPack, force: boolean): BuiltPack['levels'] =>
  levels.filter(force ? isUnplayable : isFailing);

/** What is wrong with a level that is refused. */
export const whyRefused = ({ verdict }: CheckedLevel): string =>
  verdict === 'completable' ? 'it has an error' : VERDICT_MEANS[verdict];
