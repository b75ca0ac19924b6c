import {
  type Attempt,
  collectStatistics,
  createPlayReplayer,
  isAttempt,
  type PlayStatistics,
} from '../../../check/plays/index.ts';
import { createVerifier, type PlayVerdict } from '../../../game/index.ts';
import { accuracyNameOf, createReporting, job, type Played, type Work } from '../job.ts';

/** What a play is found to be. */
export interface CheckedPlay {
  readonly verdict: PlayVerdict;
  /** The verdict in words. */
  readonly message: string;
  /** What its holds lead to; null unless the verdict is `ok`. */
  readonly replayed: Attempt | null;
}

/** Verifies plays of a level, and says what they teach together with those that are known. It reports the number of those that are verified. */
export const plays = job<
  Played & {
    /** The contents of their `.gqr` files. */
    readonly plays: readonly Uint8Array[];
    /** What plays that were verified before turned out to be. */
    readonly known: readonly Attempt[];
    /** The index of the first of `plays` among all plays. */
    readonly first: number;
  },
  { readonly plays: readonly CheckedPlay[]; readonly statistics: PlayStatistics },
  { readonly done: number }
>({ name: 'plays', lane: 'long', most: null });

/** ms between two reports */
const REPORT = 100;

/** Verifies plays one by one, and collects what they teach. */
export const playsWork: Work<typeof plays> = {
  of: plays,
  *steps({ level, terms, plays: all, known, first }, now) {
    const verifier = createVerifier(level, { accuracy: accuracyNameOf(terms), maxWork: terms.maxWork });
    const replayer = createPlayReplayer(level, terms, { minerals: 'any' });
    const attempts: Attempt[] = [...known];
    const checked: CheckedPlay[] = [];
    const isReportDue = createReporting(REPORT, now(), now);
    for (const bytes of all) {
      const { verdict, message, play } = verifier.verify(bytes);
      const replayed = verdict === 'ok' && play !== null ? replayer.replay(play, first + checked.length) : null;
      const attempt = replayed !== null && isAttempt(replayed) ? replayed : null;
      if (attempt !== null) attempts.push(attempt);
      checked.push({ verdict, message, replayed: attempt });
      yield isReportDue() ? { done: checked.length } : null;
    }
    return { plays: checked, statistics: collectStatistics(level, terms, attempts) };
  },
};
