import type { Mark } from '../../picture/comparison/index.ts';
import { KINDS, kindOfList, type Level, type ObjectKind, type ObjectList, SINGLE_KINDS } from '../../schema/index.ts';
import type { Change } from './change.ts';

/**
 * The objects that differ in what can be seen, for a picture of both versions.
 * @param changes what `diffLevels` found between the two
 */
export function marksOf(changes: readonly Change[], before: Level, after: Level): Mark[] {
  return changes.flatMap((change): Mark[] => {
    if (change.type !== 'added' && change.type !== 'removed' && change.type !== 'changed') return [];
    const kind = kindOf(change.of);
    if (kind === null) return [];
    const [b, a] = [before, after].map((level, side) => {
      if (change.type !== 'changed')
        return (change.type === 'added') === (side === 1) ? objectAt(level, kind, change.index) : null;
      return objectAt(level, kind, side === 0 ? change.before : change.after);
    });
    const isSeen = change.type !== 'changed' || change.fields.some(({ key }) => Object.hasOwn(KINDS[kind].fields, key));
    return isSeen ? [{ kind, before: b, after: a }] : [];
  });
}

const kindOf = (of: string): ObjectKind | null =>
  SINGLE_KINDS.find((kind) => kind === of) ?? (of === 'runs' ? null : kindOfList(of as ObjectList));

function objectAt(level: Level, kind: ObjectKind, index: number): NonNullable<Mark['before']> {
  const single = SINGLE_KINDS.find((one) => one === kind);
  return single === undefined ? level[KINDS[kind].list as ObjectList][index] : level[single];
}
