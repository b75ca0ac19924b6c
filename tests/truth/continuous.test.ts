import { declareMissing } from '../missing.ts';
import { compareWithReferences } from './against-references.ts';
import { continuousReferences, hardReferences, hasContinuousReferences, hasHardReferences, NO_REFERENCES } from './references.ts';

const ORIGINAL = 'runs of the original levels in continuous time';
const HARD = 'hard cases in continuous time';

const originals = hasContinuousReferences ? continuousReferences() : [];

if (hasContinuousReferences) compareWithReferences(ORIGINAL, originals);
else declareMissing(ORIGINAL, NO_REFERENCES);

// Shares are counted in both: in this file, so that the runs of the original levels are played once.
if (hasHardReferences && hasContinuousReferences) {
  const cases = hardReferences();
  compareWithReferences(HARD, cases, [...cases, ...originals]);
} else {
  declareMissing(HARD, NO_REFERENCES);
}
