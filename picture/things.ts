import { KINDS, type Level, type ListedKind, listOf, type ObjectKind, type SingleKind } from '../schema/index.ts';

/** An object of a level; the astronaut has no radius. */
export interface Thing {
  readonly x: number;
  readonly y: number;
  readonly radius?: number;
}

/** The level's objects of one kind. */
export const thingsOf = (level: Level, kind: ObjectKind): readonly Thing[] =>
  KINDS[kind].list === null ? [level[kind as SingleKind]] : level[listOf(kind as ListedKind)];
