import { CircleAlert, CircleCheck, CloudOff, Download, Eye, FileWarning, GitMerge, LoaderCircle } from 'lucide-react';
import type { ComponentType } from 'react';
import { useStore } from 'zustand';
import { useEditor, useLevel } from '../context/index.ts';
import { problemsInWords, type SaveState } from '../files/index.ts';
import type { Keeping } from '../journal/index.ts';
import { keepFile, levelFile } from '../share/index.ts';
import { Button, Hint } from '../ui/index.ts';

const LOOKS: Readonly<Record<SaveState['kind'], { Icon: ComponentType<{ size: number }>; text: string }>> = {
  saved: { Icon: CircleCheck, text: 'saved' },
  saving: { Icon: LoaderCircle, text: 'saving' },
  unsaved: { Icon: LoaderCircle, text: 'unsaved' },
  offline: { Icon: CloudOff, text: 'server is gone' },
  failing: { Icon: CircleAlert, text: 'not saved' },
  conflict: { Icon: GitMerge, text: 'conflict' },
  deleted: { Icon: CircleAlert, text: 'gone from the disk' },
  unreadable: { Icon: FileWarning, text: "the file can't be read" },
  readOnly: { Icon: Eye, text: 'read only' },
};

/** Where changes are that are not saved. `null`: nobody keeps them. */
const KEPT: Readonly<Record<Keeping, { readonly short: string; readonly long: string }>> = {
  kept: {
    short: 'kept in this browser',
    long: `It is kept in this browser, for ${location.host}, and is there again when this page dies.`,
  },
  keeping: { short: 'keeping…', long: 'It is on its way into this browser: if this page died now, it could be lost.' },
  failing: { short: 'not kept', long: 'This browser can not keep it: it is lost when this page is closed before it is saved.' },
  page: {
    short: 'in this tab alone',
    long: 'This browser keeps nothing of this page: it is lost when this page is closed before it is saved.',
  },
};

/** The reason in full. @param file the level's file @param lasts whether what is saved is still there when the page is gone */
function reasonOf(state: SaveState, keeping: Keeping | null, lasts: boolean, file: string): string {
  const kept = keeping === null ? '' : ` ${KEPT[keeping].long}`;
  switch (state.kind) {
    case 'saved':
      return lasts
        ? 'Everything is saved.'
        : 'This browser has no database for this page: the level is lost when this page is closed.';
    case 'saving':
    case 'unsaved':
      return `Will be saved in a moment.${kept}`;
    case 'offline':
    case 'failing':
      return `${state.message}. ${state.hint}.${kept}`;
    case 'conflict':
      return `The file was changed on the disk at the same place as here.${kept}`;
    case 'deleted':
      return `The file was deleted on the disk.${kept}`;
    case 'unreadable':
      return `The file on the disk can't be read as a level: ${problemsInWords(file, state.problems)} Once it is mended, the page goes on by itself. What is on the screen is the last good state.${kept}`;
    case 'readOnly':
      return state.unsaved ? `${state.why}; this tab has changes that were not written.${kept}` : `${state.why}.`;
  }
}

/** In a few words. */
function textOf(state: SaveState, keeping: Keeping | null, lasts: boolean): string {
  const { text } = LOOKS[state.kind];
  if (state.kind === 'saved' && !lasts) return 'in this tab alone';
  return state.kind === 'offline' && keeping !== null ? `${text}, ${KEPT[keeping].short}` : text;
}

/** Changes that do not come to the disk by themselves: a copy is worth having. */
const IN_DANGER: readonly SaveState['kind'][] = ['offline', 'failing', 'deleted', 'unreadable'];

/** Where somebody has to choose. */
const TO_RESOLVE: readonly SaveState['kind'][] = ['conflict', 'deleted', 'unreadable'];

/** Whether the work is safe, and what to do when it is not. */
export function SaveStatus() {
  const { session, workspace } = useEditor();
  const { opened, document } = useLevel();
  const state = useStore(opened.saver.store);
  const role = useStore(opened.lock.store);
  const keeping = useStore(opened.keeping);
  const { lasts } = workspace.storage;
  const { Icon } = LOOKS[state.kind];
  return (
    <>
      <Hint text={reasonOf(state, keeping, lasts, `${opened.id()}.level.json`)}>
        <output className={`topbar__saved topbar__saved--${state.kind}`} aria-label="Saving">
          <Icon size={14} />
          {textOf(state, keeping, lasts)}
        </output>
      </Hint>
      {IN_DANGER.includes(state.kind) && (
        <Button
          hint="Download the level as it is now"
          icon={<Download size={14} />}
          onClick={() => void keepFile(levelFile(opened.id(), document.settledFile()))}
        />
      )}
      {TO_RESOLVE.includes(state.kind) && (
        <Button hint="Look at both and choose" look="outlined" onClick={() => session.setState({ overlay: 'conflict' })}>
          Resolve
        </Button>
      )}
      {role === 'reader' && (
        <Button hint="Edit here; the other tab becomes read only" look="outlined" onClick={() => opened.lock.takeOver()}>
          Take over
        </Button>
      )}
    </>
  );
}
