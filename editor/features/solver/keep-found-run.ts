import type { Hold } from '../../../schema/index.ts';
import { verifyRun } from '../../../solver/index.ts';
import { addRun, type EditedLevel, freeRunName, replaceHolds } from '../../core/document/index.ts';
import type { ProofStore } from '../../core/proof/index.ts';
import type { SessionStore } from '../../core/session/index.ts';

/** The name of the first run that completes the level. */
export const SOLUTION = 'solution';

interface KeepParts {
  readonly document: EditedLevel;
  readonly proof: ProofStore;
  readonly session: SessionStore;
}

/** Replaces a run of the level and shows it. @param name of the run to replace */
export function replaceByFound({ document, session }: KeepParts, holds: readonly Hold[], name: string): void {
  document.change(`Replace run ${name}`, replaceHolds(name, holds));
  session.setState({ run: name });
}

/**
 * Adds a run to the level and shows it. If no run completes the level and this one does, it becomes the first run.
 * @param wanted its name, unless it is the first run that completes the level
 */
export function addFound({ document, proof, session }: KeepParts, holds: readonly Hold[], wanted: string): void {
  const file = document.file();
  const { provenBy, scene } = proof.proof();
  // The first run is the one in pictures; a run that fails in the current level must not become it.
  const proves = provenBy === null && verifyRun(scene, holds) !== null;
  const hasSolution = file.runs?.some(({ name }) => name === SOLUTION) === true;
  const name = freeRunName(file, proves && !hasSolution ? SOLUTION : wanted);
  if (document.change(`Add run ${name}`, addRun(name, holds, proves ? 'first' : 'last')).ok) session.setState({ run: name });
}
