import type { Problem } from '../../../schema/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { keyAt } from '../../core/document/index.ts';
import { runAt } from './quick-fix.ts';

/** Shows the place of a problem: selects the object and brings it into view, or shows the run with the hold selected. */
export function goToProblem({ session, commands }: Editor, { document, selection }: OpenLevel, { pointer }: Problem): void {
  const file = document.file();
  const key = keyAt(file, pointer);
  if (key !== null) {
    selection.select([key]);
    commands.run('view.fit-selection');
    return;
  }
  const run = runAt(file, pointer);
  if (run === null) {
    selection.clear();
    commands.run('view.fit');
    return;
  }
  session.setState({ run });
  const hold = /\/holds\/(\d+)/.exec(pointer)?.[1];
  const ticks = hold === undefined ? undefined : file.runs?.find(({ name }) => name === run)?.holds[Number(hold)];
  if (ticks === undefined) return;
  selection.selectHolds(run, [Number(hold)]);
  session.setState({ tick: ticks[0], isPlayingBack: false });
}
