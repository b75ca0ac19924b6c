import { ofLevel } from '../../core/context/index.ts';
import { type LostSession, watchLost } from './watch-lost.ts';

/** The examination of where an open level is already lost. */
export const lostSessionOf = ofLevel<LostSession>(({ session, desk }, level) => watchLost({ level, session, desk }));
