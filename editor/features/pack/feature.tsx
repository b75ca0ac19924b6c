import { laterCover } from '../../core/panel/index.ts';
import type { Feature } from '../feature.ts';
import './pack.css';

/** All levels as cards, in the order in which they are played. */
export const pack: Feature = {
  name: 'pack',
  dialogs: laterCover(
    ({ view }) => view === 'pack',
    () => import('./PackView.tsx').then(({ PackView }) => PackView),
    { view: 'level' },
  ),
  commands: ({ session }) => [
    {
      id: 'view.pack',
      title: 'Show the pack: all levels as cards',
      group: 'View',
      keys: ['Shift+p'],
      run: () => session.setState({ view: 'pack' }),
    },
  ],
};
