import type { Editor } from '../../core/context/index.ts';
import { laterCover } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';

const KeptDialog = laterCover(
  ({ overlay }) => overlay === 'kept',
  () => import('./KeptDialog.tsx').then((there) => there.KeptDialog),
);

/** Unsaved changes that this browser keeps. */
export const kept: Feature = {
  name: 'kept',
  dialogs: KeptDialog,
  arrive: (page) => (editor) => void tellKept(editor, page.location.host),
  commands: ({ session }) => [
    {
      id: 'file.kept',
      title: 'Unsaved changes kept in this browser',
      group: 'File',
      run: () => session.setState({ overlay: 'kept' }),
    },
  ],
};

type Parts = Pick<Editor, 'journal' | 'workspace' | 'notices' | 'session'>;

/**
 * Tells the user which levels have unsaved changes in this browser, now and when its database answers only later. The open level is
 * left out: its changes are already restored.
 * @param host of the page: what is kept is kept for it
 * @returns stops it
 */
export function tellKept(parts: Parts, host: string): () => void {
  void tell(parts, host);
  return parts.journal.onAdopted(() => void tell(parts, host));
}

async function tell({ journal, workspace, notices, session }: Parts, host: string): Promise<void> {
  const places = await journal.unsaved().catch(() => []);
  const { list, opened } = workspace.store.getState();
  const here = `${list?.folder.id ?? ''}/`;
  const ids = places.filter(({ place }) => place.startsWith(here)).map(({ place }) => place.slice(here.length));
  const others = ids.filter((id) => id !== opened?.id());
  if (others.length === 0) return;
  const which = others.length === 1 ? others[0] : `${others.length} levels`;
  notices.show('warning', `Unsaved changes to ${which} are kept in this browser for ${host}.`, {
    topic: 'kept',
    actions: [{ title: 'Review', run: () => session.setState({ overlay: 'kept' }) }],
  });
}
