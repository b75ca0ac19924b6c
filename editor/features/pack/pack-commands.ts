import type { Command } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';

/** The commands of the view of all levels. */
export const packCommands = ({ session }: Editor): readonly Command[] => [
  {
    id: 'view.pack',
    title: 'Show the pack: all levels as cards',
    group: 'View',
    keys: ['Shift+p'],
    run: () => session.setState({ view: 'pack' }),
  },
];
