import { KINDS, type Level, type ListedKind, listOf, type ObjectKind, type SingleKind } from '../schema/index.ts';

/** An object as a level has it; the astronaut is no disc. */
export interface Thing {
  readonly x: number;
  readonly y: number;
  readonly radius?: number;
}

/** The objects of a kind, as the level has them. */
export const thingsOf = (level: Level, kind: ObjectKind): readonly Thing[] =>
  KINDS[kind].list === null ? [level[kind as SingleKind]] : level[listOf(kind as ListedKind)];
