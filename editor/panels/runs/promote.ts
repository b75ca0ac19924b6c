import type { Editor, OpenLevel } from '../../context/index.ts';
import { addRun, freeRunName, replaceHolds } from '../../document/index.ts';
import type { Attempt } from '../../play/index.ts';

/**
 * Puts an attempt into the level. One that completes it becomes the proof: in place of the shown run when that fails, else as the first run. Any other one
 * is kept as the last run.
 */
export function promoteAttempt({ session, notices }: Editor, { document, proof }: OpenLevel, attempt: Attempt): void {
  const { run } = proof.proof();
  const { number, holds, end } = attempt;
  if (end.outcome !== 'completed') {
    const name = freeRunName(document.file(), `attempt ${number}`);
    document.change(`Keep attempt ${number}`, addRun(name, holds));
    session.setState({ run: name });
    return;
  }
  const label = `Make attempt ${number} the proof`;
  if (run.name !== null && run.outcome !== 'completed') document.change(label, replaceHolds(run.name, holds));
  else {
    const name = freeRunName(document.file(), run.name === null ? 'solution' : 'played');
    document.change(label, addRun(name, holds, 'first'));
    session.setState({ run: name });
  }
  notices.show('info', `Attempt ${number} is a run of the level now.`, { topic: 'promoted' });
}
