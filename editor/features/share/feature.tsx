import type { Feature } from '../feature.ts';
import { DropZone } from './DropZone.tsx';
import { LinkDialog } from './LinkDialog.tsx';
import { ShareDialog } from './ShareDialog.tsx';
import { followLinks } from './take-link.ts';
import './share.css';

function Dialogs() {
  return (
    <>
      <ShareDialog />
      <DropZone />
      <LinkDialog />
    </>
  );
}

/** Levels as files, links and pages, and those that are dropped or linked. */
export const share: Feature = {
  name: 'share',
  dialogs: Dialogs,
  start: followLinks,
  commands: ({ session }) => [
    {
      id: 'file.share',
      title: 'Import, export, link',
      group: 'File',
      run: () => session.setState({ overlay: 'share' }),
    },
    {
      id: 'file.publish',
      title: 'Publish as a page to play',
      group: 'File',
      run: () => session.setState({ overlay: 'publish' }),
    },
  ],
};
