import { Files } from 'lucide-react';
import { flushSync } from 'react-dom';
import type { Feature } from '../feature.ts';
import { fileCommands, levelDestinations } from './file-commands.ts';
import { HeldBackDialog } from './HeldBackDialog.tsx';
import { LevelsPanel } from './LevelsPanel.tsx';
import { NewLevelDialog } from './NewLevelDialog.tsx';
import { TrashDialog } from './TrashDialog.tsx';
import './dialogs.css';

function Dialogs() {
  return (
    <>
      <NewLevelDialog />
      <TrashDialog />
      <HeldBackDialog />
    </>
  );
}

/** The list of levels, and what is done with their files. */
export const levels: Feature = {
  name: 'levels',
  panel: {
    id: 'levels',
    title: 'Levels',
    icon: <Files size={17} />,
    side: 'left',
    place: 'fixed',
    content: LevelsPanel,
  },
  dialogs: Dialogs,
  destinations: levelDestinations,
  commands: (editor) => {
    const { session, commands } = editor;
    return [
      ...fileCommands(editor),
      {
        id: 'file.new',
        title: 'New level',
        group: 'File',
        keys: ['Alt+n'],
        inText: true,
        run: () => session.setState({ overlay: 'newLevel' }),
      },
      { id: 'file.trash', title: 'Deleted levels', group: 'File', run: () => session.setState({ overlay: 'trash' }) },
      {
        id: 'file.find',
        title: 'Find a level',
        group: 'File',
        keys: ['$mod+p'],
        inText: true,
        run: () => {
          // Where panels are shown one at a time, the list may not be rendered yet.
          flushSync(() => commands.run('panel.levels'));
          const field = document.querySelector<HTMLInputElement>('.levels input[type="search"]');
          field?.focus();
          field?.select();
        },
      },
    ];
  },
};
