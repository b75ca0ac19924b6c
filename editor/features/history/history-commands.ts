import type { Command } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';

/** The keys of the history. */
export const HISTORY_KEY = 'y';
export const NAME_KEY = 'Shift+y';

/** Commands for the history of the open level. */
export function historyCommands({ session, open }: Editor): readonly Command[] {
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
