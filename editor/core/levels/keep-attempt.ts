import { simulate } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { Attempt } from '../attempts/index.ts';
import type { Editor, OpenLevel } from '../context/index.ts';
import { addRun, type ChangeResult, freeRunName, replaceHolds, titled } from '../document/index.ts';
import { bareTitle } from '../shelf/index.ts';

interface Parts {
  readonly editor: Pick<Editor, 'session' | 'notices'>;
  readonly level: Pick<OpenLevel, 'document' | 'proof'>;
}

const TOPIC = { topic: 'kept' } as const;

function changed({ editor: { notices } }: Parts, result: ChangeResult): boolean {
  if (!result.ok) notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`, TOPIC);
  return result.ok;
}

/** Adds an attempt to the level as its last run; no other run changes. */
export const keepAsRun = (parts: Parts, { number, holds }: Pick<Attempt, 'number' | 'holds'>): void =>
  keepHolds(parts, `attempt ${number}`, holds);

/** Characters of a run's name that come from the name of a file. */
const LONGEST_NAME = 60;

/** Adds holds to the level as its last run. @param title where they come from, which the run is called after */
export function keepHolds(parts: Parts, title: string, holds: readonly Hold[]): void {
  const { document } = parts.level;
  const { session, notices } = parts.editor;
  const name = freeRunName(document.file(), bareTitle(title).slice(-LONGEST_NAME));
  if (!changed(parts, document.change(`Keep ${title} as a run`, addRun(name, holds)))) return;
  session.setState({ run: name });
  notices.show('info', `${titled(title)} is kept as the last run, “${name}”.`, TOPIC);
}

/**
 * Keeps an attempt that completes the level as the run that shows it: it replaces the holds of the shown run if no run
 * completes the level, else it becomes the first run. An attempt that does not complete the level, or no longer does, is kept
 * as the last run.
 */
export function makeProof(parts: Parts, attempt: Attempt): void {
  const { document, proof } = parts.level;
  const { session, notices } = parts.editor;
  const { number, holds } = attempt;
  const { scene, run, provenBy } = proof.proof();
  // The level or its accuracy may have changed since it was played.
  if (simulate(scene, holds).outcome !== 'completed') {
    keepAsRun(parts, attempt);
    notices.show('warning', `Attempt ${number} does not complete the level as it is now. It is kept as the last run.`, TOPIC);
    return;
  }
  const label = `Keep attempt ${number} as a run`;
  const replaces = provenBy === null && run.name !== null;
  const name = replaces ? run.name : freeRunName(document.file(), run.name === null ? 'solution' : 'played');
  if (!changed(parts, document.change(label, replaces ? replaceHolds(name, holds) : addRun(name, holds, 'first')))) return;
  session.setState({ run: name });
  const text = replaces
    ? `Attempt ${number} replaces the holds of the run “${name}”.`
    : `Attempt ${number} is kept as the first run, “${name}”.`;
  notices.show('info', text, TOPIC);
}
