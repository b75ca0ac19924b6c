import { createProver, type LiveProof } from '../../core/proof/index.ts';
import { type FormerRun, formerOf, isShown } from './former.ts';

/** ms that the page may be blocked by it */
const PATIENCE = 400;

/**
 * The run that is shown now, as it was in a former level. It is played again if another run was shown then, or under
 * other terms.
 */
export function replayFormer(former: FormerRun, now: LiveProof): FormerRun {
  if (isShown(former, now)) return former;
  const { file, level } = former;
  const proof = createProver().prove({
    file,
    run: now.run.name,
    // the level has the rules of the folder that applied then
    terms: { ...now.terms, rules: level.rules ?? {} },
    patience: PATIENCE,
  });
  return formerOf(proof);
}
