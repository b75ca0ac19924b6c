import {
  CircleAlert,
  CircleCheck,
  CloudOff,
  Download,
  Eye,
  FileWarning,
  GitMerge,
  LoaderCircle,
  TriangleAlert,
} from 'lucide-react';
import { type ComponentType, useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { useDocument, useEditor, useLevel } from '../core/context/index.ts';
import { keepFile, levelFile } from '../core/exchange/index.ts';
import { type OpenedLevel, problemsInWords, type SaveState } from '../core/files/index.ts';
import type { Keeping } from '../core/journal/index.ts';
import { Button, Hint } from '../core/ui/index.ts';

const LOOKS: Readonly<Record<SaveState['kind'], { Icon: ComponentType<{ size: number }>; text: string }>> = {
  saved: { Icon: CircleCheck, text: 'saved' },
  saving: { Icon: LoaderCircle, text: 'saving' },
  unsaved: { Icon: LoaderCircle, text: 'unsaved' },
  offline: { Icon: CloudOff, text: 'disconnected' },
  failing: { Icon: CircleAlert, text: 'not saved' },
  conflict: { Icon: GitMerge, text: 'conflict' },
  deleted: { Icon: CircleAlert, text: 'deleted on disk' },
  unreadable: { Icon: FileWarning, text: "file can't be read" },
  readOnly: { Icon: Eye, text: 'read-only' },
};

/** Where unsaved changes are kept. */
const KEPT: Readonly<Record<Keeping, { readonly short: string; readonly long: string }>> = {
  kept: {
    short: 'kept in this browser',
    long: `It is kept in this browser for ${location.host} and is restored if this page crashes.`,
  },
  keeping: { short: 'keeping…', long: 'This browser is storing it: if the page crashed now, it could be lost.' },
  failing: { short: 'not kept', long: "This browser can't keep it: it is lost if the page is closed before it is saved." },
  page: {
    short: 'in this tab only',
    long: 'This browser stores nothing for this page: it is lost if the page is closed before it is saved.',
  },
};

/** The reason in full. @param file the level's file @param lasts whether saved data survives the page */
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
      return `The file was changed on disk in the same place as here.${kept}`;
    case 'deleted':
      return `The file was deleted on disk.${kept}`;
    case 'unreadable':
      return `The file on disk can't be read as a level: ${problemsInWords(file, state.problems)} The page shows the last valid state and continues by itself once the file is fixed.${kept}`;
    case 'readOnly':
      return state.unsaved ? `${state.why}; this tab has changes that were not saved.${kept}` : `${state.why}.`;
  }
}

/** The state in a few words. */
function textOf(state: SaveState, keeping: Keeping | null, lasts: boolean): string {
  const { text } = LOOKS[state.kind];
  if (state.kind === 'saved' && !lasts) return 'in this tab only';
  return state.kind === 'offline' && keeping !== null ? `${text}, ${KEPT[keeping].short}` : text;
}

/** States in which changes do not reach the disk by themselves: the user is offered a download. */
const IN_DANGER: readonly SaveState['kind'][] = ['offline', 'failing', 'deleted', 'unreadable'];

/** States in which the user must choose. */
const TO_RESOLVE: readonly SaveState['kind'][] = ['conflict', 'deleted', 'unreadable'];

/** Whether the work is saved, and what to do if it is not. */
export function SaveStatus() {
  const { session, workspace } = useEditor();
  const { opened, document } = useLevel();
  const state = useStore(opened.saver.store);
  const role = useStore(opened.lock.store);
  const keeping = useStore(opened.keeping);
  const isUndecided = useDocument(({ file }) => (file.conflicts ?? []).length > 0);
  const isHolding = useStore(opened.holding);
  const { lasts } = workspace.storage;
  const { Icon } = LOOKS[state.kind];
  const isUnsaved = state.kind === 'readOnly' ? state.unsaved : state.kind !== 'saved';
  // A page that ends takes along what the browser's database has not yet confirmed.
  useQuestionOnLeaving(isUnsaved && keeping !== null && keeping !== 'kept');
  return (
    <>
      <Hint text={reasonOf(state, keeping, lasts, `${opened.id()}.level.json`)}>
        <output className={`topbar__saved topbar__saved--${state.kind}`} aria-label="Saving">
          <Icon size={14} />
          {isHolding ? 'not saved' : textOf(state, keeping, lasts)}
        </output>
      </Hint>
      {IN_DANGER.includes(state.kind) && (
        <Button
          hint="Download the level as it is now"
          icon={<Download size={14} />}
          onClick={() => void keepFile(levelFile(opened.id(), document.committedFile()))}
        />
      )}
      {(TO_RESOLVE.includes(state.kind) || isUndecided) && (
        <Button hint="Compare both versions and choose" look="outlined" onClick={() => session.setState({ overlay: 'conflict' })}>
          Resolve
        </Button>
      )}
      {role === 'reader' && !isHolding && (
        <Button hint="Edit here; the other tab becomes read-only" look="outlined" onClick={() => opened.lock.takeOver()}>
          Take over
        </Button>
      )}
    </>
  );
}

/** Asks before the page is left while it alone has a change. */
function useQuestionOnLeaving(isAlone: boolean): void {
  useEffect(() => {
    if (!isAlone) return;
    const ask = (event: BeforeUnloadEvent) => event.preventDefault();
    window.addEventListener('beforeunload', ask);
    return () => window.removeEventListener('beforeunload', ask);
  }, [isAlone]);
}

function Question({ opened }: { readonly opened: OpenedLevel }) {
  const [isTaking, setIsTaking] = useState(false);
  useQuestionOnLeaving(true);
  return (
    <aside className="heldbar" aria-label="Change that waits">
      <TriangleAlert size={16} />
      <p className="heldbar__text" role="alert">
        Another tab has this level open. Your change is only in this tab, and is not saved.
      </p>
      <Button
        hint="Save it here; the other tab becomes read-only"
        look="main"
        disabled={isTaking}
        onClick={() => {
          setIsTaking(true);
          opened.lock.takeOver();
        }}
      >
        {isTaking ? 'Taking over…' : 'Take over and save'}
      </Button>
      <Button
        hint="Show the level as the other tab has it; undo brings the change back"
        look="outlined"
        onClick={() => opened.dropHeld()}
      >
        Drop the change
      </Button>
    </aside>
  );
}

/** What to do with a change of a level that another tab writes. It is kept until the user has chosen. */
export function HeldBar() {
  const { opened } = useLevel();
  const isHolding = useStore(opened.holding);
  return isHolding ? <Question opened={opened} /> : null;
}
