import { Download, Upload } from 'lucide-react';
import { useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { usePromised } from '../../core/ask/index.ts';
import type { Command } from '../../core/commands/index.ts';
import { type Editor, LevelContext, PerLevel, useEditor, useLevel, useSession } from '../../core/context/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import type { Feature } from '../feature.ts';
import { exportHistory, importHistory } from './history-file.ts';
import { NameVersionDialog } from './NameVersionDialog.tsx';
import './history.css';
import { VersionDetail } from './VersionDetail.tsx';
import { VersionList } from './VersionList.tsx';

function Dialogs() {
  return (
    <>
      <HistoryDialog />
      <NameVersionDialog />
    </>
  );
}

/** Earlier versions of the level, compared and restored. */
export const history: Feature = { name: 'history', dialogs: Dialogs, commands: historyCommands };

/** The keys of the history. */
const HISTORY_KEY = 'y';
const NAME_KEY = 'Shift+y';

/** Commands for the history of the open level. */
function historyCommands({ session, open }: Editor): readonly Command[] {
  const needs = () => (open.getState() === null ? 'open a level first' : null);
  return [
    {
      id: 'history.show',
      title: 'History of this level',
      group: 'File',
      keys: [HISTORY_KEY],
      needs,
      run: () => session.setState({ overlay: 'history' }),
    },
    {
      id: 'history.name',
      title: 'Name this version',
      group: 'File',
      keys: [NAME_KEY],
      needs,
      run: () => session.setState({ overlay: 'nameVersion' }),
    },
  ];
}

/** The dialog with the versions of the open level. */
function HistoryDialog() {
  const editor = useEditor();
  const { session } = editor;
  const level = useStore(editor.open);
  const open = useSession((state) => state.overlay === 'history');
  const close = () => session.setState({ overlay: null });
  return (
    <Dialog
      open={open}
      wide
      title="History"
      about="Every saved version of this level, kept in this browser only. Those with a name stay for good."
      onClose={close}
    >
      {level === null ? (
        <p>Open a level first.</p>
      ) : (
        <LevelContext.Provider value={level}>
          <PerLevel>
            <History onClose={close} />
          </PerLevel>
        </LevelContext.Provider>
      )}
    </Dialog>
  );
}

function History({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const level = useLevel();
  const { versions } = level.opened;
  const list = useStore(versions.store);
  const trouble = useStore(editor.versions.trouble);
  const [picked, setPicked] = useState<number | null>(null);
  const [said, setSaid] = useState('');
  const root = useRef<HTMLDivElement>(null);
  const isRead = usePromised(versions, (asked) => asked.load().then(() => true)) !== null;
  const isThere = isRead && list !== null && list.length > 0;
  // the dialog itself takes the focus when it opens
  useEffect(() => {
    if (!isThere) return;
    const frame = requestAnimationFrame(() => root.current?.querySelector<HTMLElement>('[role=tree]')?.focus());
    return () => cancelAnimationFrame(frame);
  }, [isThere]);
  const version = list?.find(({ number }) => number === picked) ?? null;
  return (
    <div ref={root} className={version === null ? 'history' : 'history history--picked'}>
      {trouble !== null && (
        <p className="history__trouble" role="alert">
          {trouble.message}
        </p>
      )}
      <div className="history__list">
        {!isRead ? (
          <p className="history__empty">Loading…</p>
        ) : list === null || list.length === 0 ? (
          <p className="history__empty">No versions yet: each save adds one.</p>
        ) : (
          <VersionList versions={list} picked={picked} onPick={setPicked} />
        )}
        <div className="history__file">
          <Button
            hint="Save all versions as one file"
            look="outlined"
            icon={<Download size={14} />}
            disabled={!isThere}
            onClick={() => void exportHistory(level).then(setSaid)}
          >
            Export
          </Button>
          <Button
            hint="Add the versions of a file that was exported"
            look="outlined"
            icon={<Upload size={14} />}
            onClick={() => void importHistory(level).then(setSaid)}
          >
            Import
          </Button>
          <output className="history__said">{said}</output>
        </div>
      </div>
      {version === null ? (
        <p className="history__detail history__empty">Choose a version to see what has changed since.</p>
      ) : (
        <VersionDetail
          key={version.number}
          version={version}
          versions={list ?? []}
          onBack={() => {
            setPicked(null);
            root.current?.querySelector<HTMLElement>('[role=tree]')?.focus();
          }}
          onClose={onClose}
        />
      )}
    </div>
  );
}
