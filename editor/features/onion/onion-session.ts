import { ofLevel } from '../../core/context/index.ts';
import { solverSessionOf } from '../solver/index.ts';
import { type OnionSession, watchOnion } from './watch-onion.ts';

/** The comparison of an open level with what was before a change. */
export const onionSessionOf = ofLevel<OnionSession>((editor, level) => {
  const { session, desk } = editor;
  const { robustness } = solverSessionOf(editor, level);
  return watchOnion({ level, session, desk, robustness: robustness.store });
});
