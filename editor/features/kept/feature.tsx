import type { Feature } from '../feature.ts';
import { KeptDialog } from './KeptDialog.tsx';
import { tellKept } from './tell-kept.ts';

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
