import type { Command } from '../commands/index.ts';
import type { Editor, OpenLevel } from '../context/index.ts';
import {
  canBeMarked,
  freeGroupName,
  groupOf,
  groupsIn,
  hiddenIn,
  lockedIn,
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

/** The rest of a label: nothing for one, ` 3 objects` for more. */
const several = (count: number): string => (count === 1 ? '' : ` ${count} objects`);

export function orderActions({ notices }: Editor, { document, selection }: OpenLevel): OrderActions {
  const change = (label: string, recipe: Recipe) => {
    const result = document.change(label, recipe);
    if (!result.ok) notices.refuse(result.refusal);
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
        change(`${isLocked ? 'Lock' : 'Unlock'}${several(those.length)}`, setMark(those, 'isLocked', isLocked));
    },
    hide(keys, isHidden) {
      const those = markable(keys, 'isHidden');
      if (those.length > 0) change(`${isHidden ? 'Hide' : 'Show'}${several(those.length)}`, setMark(those, 'isHidden', isHidden));
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
      change(`Group${several(those.length)}`, setMark(those, 'group', name));
      selection.select(those);
    },
    ungroup(keys) {
      const file = document.file();
      const names = new Set(keys.flatMap((key) => groupOf(file, key) ?? []));
      const members = [...names].flatMap((name) => groupsIn(file).get(name) ?? []);
      if (members.length === 0) return;
      change(`Ungroup${several(members.length)}`, setMark(members, 'group', null));
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

/** Commands that lock, hide, name and group the selection. */
export function orderCommands(editor: Editor, level: OpenLevel): readonly Command[] {
  const { commands, session } = editor;
  const { document, selection } = level;
  const actions = orderActions(editor, level);
  const needsSelected = () => (selection.keys().length > 0 ? null : 'select an object first');
  const needsTwo = () => (selection.keys().length > 1 ? null : 'select two objects first');
  const groups = () => new Set(selection.keys().flatMap((key) => groupOf(document.file(), key) ?? []));
  const needsGroup = () => (groups().size > 0 ? null : 'select a group first');
  return [
    {
      id: 'object.lock',
      title: 'Lock or unlock the selection',
      group: 'Object',
      keys: ['$mod+Shift+l'],
      needs: needsSelected,
      run: () => actions.lock(selection.keys(), !areAll(level, selection.keys(), 'isLocked')),
    },
    {
      id: 'object.unlock-all',
      title: 'Unlock all objects',
      group: 'Object',
      needs: () => (lockedIn(document.file()).size > 0 ? null : 'lock an object first'),
      run: () => actions.lock([...lockedIn(document.file())], false),
    },
    {
      id: 'object.hide',
      title: 'Hide or show the selection; it is simulated all the same',
      group: 'Object',
      keys: ['$mod+Shift+h'],
      needs: needsSelected,
      run: () => actions.hide(selection.keys(), !areAll(level, selection.keys(), 'isHidden')),
    },
    {
      id: 'object.show-all',
      title: 'Show all hidden objects',
      group: 'Object',
      needs: () => (hiddenIn(document.file()).size > 0 ? null : 'hide an object first'),
      run: () => actions.hide([...hiddenIn(document.file())], false),
    },
    {
      id: 'object.rename',
      title: 'Name the selected object or group',
      group: 'Object',
      keys: ['F2'],
      needs: needsSelected,
      run() {
        const [key] = selection.keys();
        const [group] = groups();
        const isGroup = group !== undefined && selection.keys().length > 1;
        commands.run('panel.outline');
        session.setState({ renaming: isGroup ? groupRowKey(group) : key });
      },
    },
    {
      id: 'object.group',
      title: 'Group the selection',
      group: 'Object',
      keys: ['$mod+g'],
      needs: needsTwo,
      run: () => actions.group(selection.keys()),
    },
    {
      id: 'object.ungroup',
      title: 'Ungroup the selection',
      group: 'Object',
      keys: ['$mod+Shift+g'],
      needs: needsGroup,
      run: () => actions.ungroup(selection.keys()),
    },
    {
      id: 'object.next-member',
      title: 'Select the members of the selected group one by one',
      group: 'Object',
      keys: ['Alt+Enter'],
      needs: needsGroup,
      run() {
        const [name] = groups();
        const members = groupsIn(document.file()).get(name) ?? [];
        const now = selection.keys().length === 1 ? members.indexOf(selection.keys()[0]) : -1;
        selection.select(members.slice((now + 1) % members.length).slice(0, 1));
      },
    },
    {
      id: 'object.whole-group',
      title: 'Select the whole group of the selected object',
      group: 'Object',
      keys: ['Shift+Alt+Enter'],
      needs: needsGroup,
      run: () => selection.select([...groups()].flatMap((name) => groupsIn(document.file()).get(name) ?? [])),
    },
  ];
}

/** The key of the row of a group among the rows of objects, whose keys never begin like this. */
export const groupRowKey = (group: string): string => `@group ${group}`;
