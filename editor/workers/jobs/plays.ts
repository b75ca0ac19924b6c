import { type Attempt, collectStatistics, createPlayReplayer, isAttempt } from '../../../check/plays/index.ts';
import { createVerifier } from '../../../game/index.ts';
import { accuracyNameOf } from '../../core/terms/index.ts';
import type { CheckedPlay } from '../protocol.ts';
import type { Start } from '../work.ts';

/** ms between two reports */
const REPORT = 100;

/** Verifies plays one by one, and collects what they teach. */
export const plays: Start<'plays'> = function* ({ level, terms, plays: all, known, first }, now) {
  const verifier = createVerifier(level, { accuracy: accuracyNameOf(terms), maxWork: terms.maxWork });
  const replayer = createPlayReplayer(level, terms, { minerals: 'any' });
  const attempts: Attempt[] = [...known];
  const checked: CheckedPlay[] = [];
  let last = now();
  for (const bytes of all) {
    const { verdict, message, play } = verifier.verify(bytes);
    const replayed = verdict === 'ok' && play !== null ? replayer.replay(play, first + checked.length) : null;
    const attempt = replayed !== null && isAttempt(replayed) ? replayed : null;
    if (attempt !== null) attempts.push(attempt);
    checked.push({ verdict, message, replayed: attempt });
    const isDue = now() - last >= REPORT;
    if (isDue) last = now();
    yield isDue ? { done: checked.length } : null;
  }
  return { plays: checked, statistics: collectStatistics(level, terms, attempts) };
};
