import { createProver, type LiveProof } from '../proof/index.ts';
import { type FormerRun, formerOf, isShown } from './former.ts';

/** ms that the page may be blocked by it */
const PATIENCE = 400;

/**
 * The run that is shown now, as it was in a former level. It is played again if another run was shown then, or at another
 * accuracy.
 */
export function replayFormer(former: FormerRun, now: LiveProof): FormerRun {
  if (isShown(former, now)) return former;
  const { file, level } = former;
  const proof = createProver().prove({
    file,
    // those of the folder, too, where the level had none
    rules: level.rules ?? {},
    run: now.run.name,
    accuracy: now.accuracy,
    patience: PATIENCE,
  });
  return formerOf(proof);
}
