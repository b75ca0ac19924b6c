import { CircleQuestionMark, Clock, Play, Redo2, Search, Settings, Share2, Square, Undo2 } from 'lucide-react';
import { useStore } from 'zustand';
import { keyLabel } from '../core/commands/index.ts';
import { IS_MAC, useDocument, useEditor, useSession } from '../core/context/index.ts';
import { listHistoryOf } from '../core/levels/index.ts';
import { Button } from '../core/ui/index.ts';
import { SaveStatus } from './SaveStatus.tsx';
import { VerdictBadge } from './VerdictBadge.tsx';

/** The open level, its saving state, its verdict, and the main commands. */
export function TopBar() {
  const editor = useEditor();
  const { commands, session } = editor;
  const history = listHistoryOf(editor);
  const name = useDocument(({ file }) => file.name);
  const undo = useStore(history.store, (state) => state.undoLabel);
  const redo = useStore(history.store, (state) => state.redoLabel);
  const playing = useSession((state) => state.mode === 'play');
  const key = (binding: string) => keyLabel(binding, IS_MAC);
  return (
    <header className="topbar">
      <h1 className="topbar__level">{name}</h1>
      <SaveStatus />
      <Button
        className="topbar__undo"
        hint={undo === null ? 'Nothing to undo' : `Undo: ${undo}`}
        shortcut={key('$mod+z')}
        icon={<Undo2 size={16} />}
        disabled={undo === null}
        onClick={history.undo}
      />
      <Button
        hint={redo === null ? 'Nothing to redo' : `Redo: ${redo}`}
        shortcut={key('$mod+Shift+z')}
        icon={<Redo2 size={16} />}
        disabled={redo === null}
        onClick={history.redo}
      />
      <Button
        className="topbar__history"
        hint="History of this level"
        shortcut={key('y')}
        icon={<Clock size={16} />}
        onClick={() => session.setState({ overlay: 'history' })}
      />
      <Button
        className="topbar__search"
        aria-label="Search all commands"
        hint="Search all commands"
        shortcut={key('$mod+k')}
        look="outlined"
        icon={<Search size={14} />}
        onClick={() => session.setState({ overlay: 'palette' })}
      >
        <span className="topbar__words">Search</span>
      </Button>
      <span className="topbar__space" />
      <VerdictBadge />
      <Button
        className="topbar__play"
        hint={playing ? 'Back to editing' : 'Play from the start'}
        shortcut={playing ? 'Esc' : 'Space'}
        look="main"
        icon={playing ? <Square size={14} /> : <Play size={14} />}
        onClick={() => commands.run(playing ? 'play.stop' : 'play.start')}
      >
        {playing ? 'Stop' : 'Play'}
      </Button>
      <Button hint="Import, export, link" icon={<Share2 size={16} />} onClick={() => session.setState({ overlay: 'share' })} />
      <Button hint="Settings" icon={<Settings size={16} />} onClick={() => session.setState({ overlay: 'settings' })} />
      <Button
        className="topbar__help"
        hint="Shortcuts and gestures"
        shortcut="?"
        icon={<CircleQuestionMark size={16} />}
        onClick={() => session.setState({ overlay: 'cheatSheet' })}
      />
    </header>
  );
}
