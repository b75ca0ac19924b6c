import { KINDS, type ObjectKind } from './kinds.ts';
import type { Level, ObjectOf } from './level-types.ts';

/** The objects of a kind in a level. */
export function objectsIn<K extends ObjectKind>(level: Level, kind: K): readonly ObjectOf<K>[] {
  const found = (level as unknown as Readonly<Record<string, unknown>>)[KINDS[kind].list ?? kind];
  return (KINDS[kind].list === null ? [found] : found) as readonly ObjectOf<K>[];
}
