import type { Hold } from '../../../schema/index.ts';
import { verifyRun } from '../../../solver/index.ts';
import { addRun, type EditedLevel, freeRunName, replaceHolds } from '../../document/index.ts';
import type { ProofStore } from '../../proof/index.ts';
import type { SessionStore } from '../../session/index.ts';

/** What the run is called that shows first that a level can be completed. */
export const SOLUTION = 'solution';

interface KeepParts {
  readonly document: EditedLevel;
  readonly proof: ProofStore;
  readonly session: SessionStore;
}

/** Puts a run in the place of one of the level, and shows it. @param name of that run */
export function replaceByFound({ document, session }: KeepParts, holds: readonly Hold[], name: string): void {
  document.change(`Replace run ${name}`, replaceHolds(name, holds));
  session.setState({ run: name });
}

/**
 * Adds a run to the level and shows it. Where no run completes the level and this one does, it comes first: it is the proof.
 * @param wanted what it is called, unless it is the level's first solution
 */
export function addFound({ document, proof, session }: KeepParts, holds: readonly Hold[], wanted: string): void {
  const file = document.file();
  const { provenBy, scene } = proof.proof();
  // the first run is the one that is shown, but what fails in the level as it is now proves nothing
  const proves = provenBy === null && verifyRun(scene, holds) !== null;
  const hasSolution = file.runs?.some(({ name }) => name === SOLUTION) === true;
  const name = freeRunName(file, proves && !hasSolution ? SOLUTION : wanted);
  if (document.change(`Add run ${name}`, addRun(name, holds, proves ? 'first' : 'last')).ok) session.setState({ run: name });
}
