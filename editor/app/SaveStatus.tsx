import { CircleAlert, CircleCheck, CloudOff, Eye, GitMerge, LoaderCircle } from 'lucide-react';
import type { ComponentType } from 'react';
import { useStore } from 'zustand';
import { useEditor, useLevel } from '../context/index.ts';
import type { SaveState } from '../files/index.ts';
import { Button, Hint } from '../ui/index.ts';

const LOOKS: Readonly<Record<SaveState['kind'], { Icon: ComponentType<{ size: number }>; text: string }>> = {
  saved: { Icon: CircleCheck, text: 'saved' },
  saving: { Icon: LoaderCircle, text: 'saving' },
  unsaved: { Icon: LoaderCircle, text: 'unsaved' },
  offline: { Icon: CloudOff, text: 'server is gone, kept in this browser' },
  failing: { Icon: CircleAlert, text: 'not saved' },
  conflict: { Icon: GitMerge, text: 'conflict' },
  displaced: { Icon: CircleAlert, text: 'gone from the disk' },
  readOnly: { Icon: Eye, text: 'read only' },
};

/** The reason in full. */
function reasonOf(state: SaveState): string {
  switch (state.kind) {
    case 'saved':
      return 'Everything is on the disk.';
    case 'saving':
    case 'unsaved':
      return 'Will be on the disk in a moment; until then it is kept in this browser.';
    case 'offline':
    case 'failing':
      return `${state.message}. ${state.hint}`;
    case 'conflict':
      return 'The file was changed on the disk at the same place as here.';
    case 'displaced':
      return state.reason === 'deleted' ? 'The file was deleted on the disk.' : 'The file on the disk is no valid level now.';
    case 'readOnly':
      return state.unsaved ? `${state.why}; this tab has changes that were not written.` : `${state.why}.`;
  }
}

/** Whether the work is safe, and what to do when it is not. */
export function SaveStatus() {
  const { session } = useEditor();
  const { opened } = useLevel();
  const state = useStore(opened.saver.store);
  const role = useStore(opened.lock.store);
  const { Icon, text } = LOOKS[state.kind];
  return (
    <>
      <Hint text={reasonOf(state)}>
        <output className={`topbar__saved topbar__saved--${state.kind}`} aria-label="Saving">
          <Icon size={14} />
          {text}
        </output>
      </Hint>
      {(state.kind === 'conflict' || state.kind === 'displaced') && (
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
