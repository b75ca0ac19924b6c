import type { Command } from '../core/commands/index.ts';
import type { Editor } from '../core/context/index.ts';
import { listHistoryOf } from '../core/levels/index.ts';
import { showLayer } from '../core/session/index.ts';
import { LAYERS } from './panels.tsx';

/** Commands that work whatever is shown. */
export function appCommands(editor: Editor): readonly Command[] {
  const { session, settings, open } = editor;
  const history = listHistoryOf(editor);
  const needsLevel = () => (open.getState() === null ? 'open a level first' : null);
  const show = (overlay: NonNullable<ReturnType<typeof session.getState>['overlay']>) => () => session.setState({ overlay });
  return [
    {
      id: 'edit.undo',
      title: 'Undo',
      group: 'Edit',
      keys: ['$mod+z'],
      needs: () => (history.store.getState().undoLabel === null ? needsLevel() : null),
      run: history.undo,
    },
    {
      id: 'edit.redo',
      title: 'Redo',
      group: 'Edit',
      keys: ['$mod+Shift+z', '$mod+y'],
      needs: () => (history.store.getState().redoLabel === null ? needsLevel() : null),
      run: history.redo,
    },
    {
      id: 'file.save',
      title: 'Save now',
      group: 'File',
      keys: ['$mod+s'],
      mode: 'both',
      inText: true,
      inDialogs: true,
      needs: needsLevel,
      run: () => void open.getState()?.opened.saver.flush(),
    },
    {
      id: 'help.palette',
      title: 'Search all commands',
      group: 'Help',
      keys: ['$mod+k', '$mod+Shift+p'],
      inText: true,
      inDialogs: true,
      run: show('palette'),
    },
    { id: 'help.keys', title: 'Shortcuts and gestures', group: 'Help', keys: ['Shift+?', '?'], run: show('cheatSheet') },
    { id: 'help.settings', title: 'Settings', group: 'Help', keys: ['$mod+Comma'], inText: true, run: show('settings') },
    {
      id: 'view.theme',
      title: 'Switch between light and dark',
      group: 'View',
      mode: 'both',
      run: () => settings.setState({ theme: document.documentElement.dataset.theme === 'light' ? 'dark' : 'light' }),
    },
    {
      id: 'view.grid-snapping',
      title: 'Turn grid snapping on or off',
      group: 'View',
      keys: ['Shift+g'],
      run: () => settings.setState({ snapToGrid: !settings.getState().snapToGrid }),
    },
    {
      id: 'view.rulers',
      title: 'Show or hide the rulers',
      group: 'View',
      keys: ['Shift+r'],
      run: () => settings.setState({ rulers: !settings.getState().rulers }),
    },
    {
      id: 'view.minimap',
      title: 'Show or hide the minimap',
      group: 'View',
      keys: ['Shift+o'],
      run: () => settings.setState({ minimap: !settings.getState().minimap }),
    },
    ...LAYERS.map(
      ({ id, title, keys = [] }): Command => ({
        id: `view.layer-${id}`,
        title: `Show or hide the ${title}`,
        group: 'View',
        keys,
        run: () => {
          const { layers } = session.getState();
          showLayer(session, id, !layers[id]);
        },
      }),
    ),
  ];
}
