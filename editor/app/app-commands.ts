import type { Command } from '../core/commands/index.ts';
import type { Editor } from '../core/context/index.ts';
import { listHistoryOf } from '../core/levels/index.ts';
import { LAYERS, type Layer } from '../core/session/index.ts';
import { ALIVE_KEY } from '../features/alive/index.ts';
import { LEEWAY_KEY } from '../features/leeway/index.ts';
import { LOST_KEY } from '../features/lost/index.ts';
import { MEND_KEY, mendSessionOf } from '../features/mend/index.ts';
import { solverSessionOf } from '../features/solver/index.ts';
import { showPanel } from './show-panel.ts';

const LAYER_TITLES: Readonly<Record<Layer, string>> = {
  ranges: 'range of the gun',
  margins: 'hazard margins',
  nearMisses: 'near misses',
  slackFan: 'slack fan',
  ghosts: 'ghosts of attempts and candidates',
  heatMap: 'search heat map',
  deaths: 'heat map of deaths',
  lost: 'states that are already lost',
  onion: 'run before and after a change',
  leeway: 'places where the selection may stand',
  notes: 'notes',
};

/** The key that shows or hides a layer, if it has one. */
const keysOf = (layer: Layer): readonly string[] => (layer === 'lost' ? [LOST_KEY] : layer === 'leeway' ? [LEEWAY_KEY] : []);

/** Commands that work whatever is shown. */
export function appCommands(editor: Editor): readonly Command[] {
  const { session, settings, open } = editor;
  const history = listHistoryOf(editor);
  const needsLevel = () => (open.getState() === null ? 'open a level first' : null);
  /** What offers to mend the level; null if nothing does. */
  const mend = () => {
    const level = open.getState();
    const found = level === null ? null : mendSessionOf(level);
    return found === null || found.store.getState().phase === 'none' ? null : found;
  };
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
      id: 'level.fix',
      title: 'Fix this level',
      group: 'Solve',
      needs: needsLevel,
      run() {
        const level = open.getState();
        if (level === null) return;
        showPanel(editor, 'solver');
        solverSessionOf(editor, level).fixes.start();
      },
    },
    {
      id: 'level.mend',
      title: 'Mend what the last change broke',
      group: 'Solve',
      keys: [MEND_KEY],
      needs: () => (mend() === null ? (needsLevel() ?? 'change something that breaks the level first') : null),
      run: () => mend()?.start(),
    },
    {
      id: 'level.mend-dismiss',
      title: 'Leave broken what the last change broke',
      group: 'Solve',
      keys: ['Escape'],
      needs: () => (mend() === null ? 'nothing is offered to mend' : null),
      run: () => mend()?.leave(),
    },
    { id: 'file.new', title: 'New level', group: 'File', keys: ['Alt+n'], inText: true, run: show('newLevel') },
    { id: 'file.share', title: 'Import, export, link', group: 'File', run: show('share') },
    { id: 'file.publish', title: 'Publish as a page to play', group: 'File', run: show('publish') },
    { id: 'file.kept', title: 'Unsaved changes kept in this browser', group: 'File', run: show('kept') },
    { id: 'file.trash', title: 'Deleted levels', group: 'File', run: show('trash') },
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
    { id: 'help.tour', title: 'Take the tour', group: 'Help', run: show('tour') },
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
      id: 'run.keep-alive',
      title: 'Keep the run alive: turn it on or off',
      group: 'Run',
      keys: [ALIVE_KEY],
      run: () => settings.setState({ keepAlive: !settings.getState().keepAlive }),
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
      (layer): Command => ({
        id: `view.layer-${layer}`,
        title: `Show or hide the ${LAYER_TITLES[layer]}`,
        group: 'View',
        keys: keysOf(layer),
        run: () => {
          const { layers } = session.getState();
          session.setState({ layers: { ...layers, [layer]: !layers[layer] } });
        },
      }),
    ),
  ];
}
