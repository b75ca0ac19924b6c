import type { Editor, OpenLevel } from '../context/index.ts';
import {
  canBeMarked,
  freeGroupName,
  groupOf,
  groupsIn,
  MARK_KEYS,
  type Mark,
  marksOf,
  nameOf,
  type ObjectKey,
  objectsOf,
  type Recipe,
  renameGroup,
  setMark,
} from '../document/index.ts';

/** Locks, hides, names and groups objects; each is one step of the history. A refusal is shown as a notice. */
export interface OrderActions {
  lock(keys: readonly ObjectKey[], isLocked: boolean): void;
  hide(keys: readonly ObjectKey[], isHidden: boolean): void;
  /** @param name empty: none */
  name(key: ObjectKey, name: string): void;
  /** Puts objects into a new group with a free name. */
  group(keys: readonly ObjectKey[]): void;
  /** Dissolves the groups of objects. */
  ungroup(keys: readonly ObjectKey[]): void;
  renameGroup(group: string, name: string): void;
}

const plural = (count: number): string => (count === 1 ? '' : ` ${count} objects`);

export function orderActions({ notices }: Editor, { document, selection }: OpenLevel): OrderActions {
  const change = (label: string, recipe: Recipe) => {
    const result = document.change(label, recipe);
    if (!result.ok) notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`, { topic: 'refused' });
  };
  /** The objects whose mark can be set; says so where it can't be. */
  const markable = (keys: readonly ObjectKey[], mark: Mark): ObjectKey[] => {
    const all = keys.flatMap((key) => objectsOf(document.file()).get(key) ?? []);
    const foreign = all.find((found) => !canBeMarked(found, mark));
    if (foreign !== undefined) {
      const why =
        mark === 'isHidden' && foreign.kind === 'astronaut'
          ? 'The astronaut is drawn with her run: she can’t be hidden.'
          : `${MARK_KEYS[mark]} of ${nameOf(foreign).toLowerCase()} has a value of another program, which stays as it is.`;
      notices.show('info', why, { topic: 'refused' });
    }
    return all.filter((found) => canBeMarked(found, mark)).map(({ key }) => key);
  };
  return {
    lock(keys, isLocked) {
      const those = markable(keys, 'isLocked');
      if (those.length > 0)
        change(`${isLocked ? 'Lock' : 'Unlock'}${plural(those.length)}`, setMark(those, 'isLocked', isLocked));
    },
    hide(keys, isHidden) {
      const those = markable(keys, 'isHidden');
      if (those.length > 0) change(`${isHidden ? 'Hide' : 'Show'}${plural(those.length)}`, setMark(those, 'isHidden', isHidden));
    },
    name(key, name) {
      const those = markable([key], 'name');
      if (those.length > 0)
        change(name === '' ? 'Remove the name' : `Name it ${name}`, setMark(those, 'name', name === '' ? null : name));
    },
    group(keys) {
      const those = markable(keys, 'group');
      if (those.length < 2) return;
      const name = freeGroupName(document.file(), 'group 1');
      change(`Group${plural(those.length)}`, setMark(those, 'group', name));
      selection.select(those);
    },
    ungroup(keys) {
      const file = document.file();
      const names = new Set(keys.flatMap((key) => groupOf(file, key) ?? []));
      const members = [...names].flatMap((name) => groupsIn(file).get(name) ?? []);
      if (members.length === 0) return;
      change(`Ungroup${plural(members.length)}`, setMark(members, 'group', null));
    },
    renameGroup: (group, name) => change(`Rename the group ${name}`, renameGroup(document.file(), group, name)),
  };
}

/** Whether all of these objects have a flag. */
export const areAll = (level: OpenLevel, keys: readonly ObjectKey[], flag: 'isLocked' | 'isHidden'): boolean => {
  const objects = objectsOf(level.document.file());
  return keys.every((key) => {
    const found = objects.get(key);
    return found !== undefined && marksOf(found)[flag];
  });
};
