import { declareMissing } from '../missing.ts';
import { compareWithReferences } from './against-references.ts';
import { continuousReferences, hasContinuousReferences, NO_REFERENCES } from './references.ts';

const TITLE = 'runs of the original levels in continuous time';

if (hasContinuousReferences) compareWithReferences(TITLE, continuousReferences());
else declareMissing(TITLE, NO_REFERENCES);
