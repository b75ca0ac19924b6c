import type { Command } from '../commands/index.ts';
import type { Editor, OpenLevel } from '../context/index.ts';
import { groupOf, groupsIn, hiddenIn, lockedIn } from '../document/index.ts';
import { areAll, orderActions } from './order-actions.ts';
import { groupRowKey } from './row-keys.ts';

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
