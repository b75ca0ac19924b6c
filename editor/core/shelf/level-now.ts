import { levelHash } from '../../../game/index.ts';
import type { OpenLevel } from '../context/index.ts';
import { keptWith } from '../kept/index.ts';

const hashOf = keptWith(levelHash);

/** The hash of the open level as it is now. */
export const hashNow = ({ proof }: Pick<OpenLevel, 'proof'>): string => hashOf(proof.proof().level);
