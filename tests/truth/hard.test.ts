import { declareMissing } from '../missing.ts';
import { compareWithReferences } from './against-references.ts';
import { continuousReferences, hardReferences, hasContinuousReferences, hasHardReferences, NO_REFERENCES } from './references.ts';

const TITLE = 'hard cases in continuous time';

if (hasHardReferences && hasContinuousReferences) {
  const cases = hardReferences();
  compareWithReferences(TITLE, cases, [...cases, ...continuousReferences()]);
} else {
  declareMissing(TITLE, NO_REFERENCES);
}
