import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { type AccuracyName, type Outcome, TICK } from '../../../engine/index.ts';
import type { PlayVerdict } from '../../../game/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type Attempt, attemptInWords, causeInWords } from '../../core/attempts/index.ts';
import type { Replay } from '../../core/session/index.ts';
import type { OpenedPlay } from '../../core/shelf/index.ts';
import type { TreeRow } from '../../core/tree/index.ts';

/** An attempt of this session or an opened play, as the list shows it. */
export interface AttemptRow extends TreeRow {
  /** The attempt; null if it is an opened play. */
  readonly attempt: Attempt | null;
  /** The content of its `.gqr` file. */
  readonly bytes: Uint8Array;
  /** The hash of the level that it was played on. */
  readonly playedOn: string;
  readonly accuracy: AccuracyName;
  readonly holds: readonly Hold[];
  /** `attempt 3`, or the name of the file. */
  readonly title: string;
  /** What it leads to; null if that is not known: the play is not what it claims. */
  readonly outcome: Outcome | 'left' | null;
  /** How it ends, as a sentence about her. */
  readonly end: string;
  /** The last tick. */
  readonly tick: number;
  /** Different minerals that she collects; null if that is not known, either. */
  readonly minerals: number | null;
  readonly verdict: PlayVerdict | null;
}

export const SORTS = ['newest', 'oldest', 'shortest', 'longest', 'minerals', 'name'] as const;
export type Sort = (typeof SORTS)[number];

export const SHOWN = ['all', 'completed', 'failed', 'left', 'mine', 'opened', 'differs'] as const;
export type Shown = (typeof SHOWN)[number];

/** How the list is ordered and what it leaves out. */
export interface ListOptions {
  readonly sort: Sort;
  readonly shown: Shown;
  /** Words that the title or the end contains. */
  readonly words: string;
}

type Entry = Omit<AttemptRow, keyof TreeRow> & { readonly key: string };

function ofAttempt(attempt: Attempt, range: number): Entry {
  const { number, holds, end, tick, minerals, accuracy, played } = attempt;
  return {
    key: `attempt-${number}`,
    attempt,
    bytes: played.bytes,
    playedOn: played.hash,
    accuracy,
    holds,
    title: `attempt ${number}`,
    outcome: end?.outcome ?? 'left',
    end: `She ${attemptInWords(attempt, range)}.`,
    tick,
    minerals,
    verdict: null,
  };
}

const OUTCOMES_IN_WORDS: Readonly<Record<Outcome | 'left', string>> = {
  completed: 'to reach the black hole',
  collided: 'to collide',
  lost: 'to be lost',
  timeout: 'to run out of time',
  left: 'to have been left',
};

function ofPlay(opened: OpenedPlay, range: number): Entry {
  const { key, source, bytes, play, replayed, verdict } = opened;
  const { claim, holds, accuracy, level } = play;
  return {
    key,
    attempt: null,
    bytes,
    playedOn: level,
    accuracy,
    holds,
    title: source,
    outcome: replayed?.outcome ?? null,
    end:
      replayed === null
        ? `It claims ${OUTCOMES_IN_WORDS[claim.outcome]} at ${(claim.tick * TICK).toFixed(2)} s, but ${verdict}.`
        : `She ${replayedInWords(replayed, range)}.`,
    tick: claim.tick,
    minerals: replayed?.minerals ?? null,
    verdict,
  };
}

function replayedInWords({ outcome, cause, time }: NonNullable<OpenedPlay['replayed']>, range: number): string {
  const when = `at ${time.toFixed(2)} s`;
  if (outcome === 'left') return `was left ${when}`;
  if (outcome === 'collided' && cause !== null) return `${causeInWords(cause)} ${when}`;
  return outcomeAsPredicate({ outcome, with: null, time: outcome === 'timeout' ? Number(time.toFixed(2)) : time }, range);
}

/** The replay of a row. @param now the hash of the level as it is now */
export const replayOf = ({ title, holds, accuracy, tick, end, outcome, playedOn }: AttemptRow, now: string): Replay => ({
  title,
  holds,
  accuracy,
  tick,
  end: playedOn === now ? end : 'The level has changed since: this is what the same holds do now.',
  look: outcome === 'completed' ? 'won' : 'lost',
});

const IS_SHOWN: Readonly<Record<Shown, (entry: Entry) => boolean>> = {
  all: () => true,
  completed: ({ outcome }) => outcome === 'completed',
  failed: ({ outcome }) => outcome === 'collided' || outcome === 'lost' || outcome === 'timeout',
  left: ({ outcome }) => outcome === 'left',
  mine: ({ attempt }) => attempt !== null,
  opened: ({ attempt }) => attempt === null,
  differs: ({ verdict }) => verdict !== null && verdict !== 'ok',
};

/** Names with numbers in them are in the order of the numbers. */
const { compare: byName } = new Intl.Collator('en', { numeric: true });

const ORDERS: Readonly<Record<Sort, ((a: Entry, b: Entry) => number) | null>> = {
  newest: null,
  oldest: null,
  shortest: (a, b) => a.tick - b.tick,
  longest: (a, b) => b.tick - a.tick,
  minerals: (a, b) => (b.minerals ?? -1) - (a.minerals ?? -1) || a.tick - b.tick,
  name: (a, b) => byName(a.title, b.title),
};

/**
 * The rows of the list.
 * @param attempts of this session, the latest last
 * @param plays that were opened, the latest last
 * @param range of the level, px
 */
export function attemptRows(
  attempts: readonly Attempt[],
  plays: readonly OpenedPlay[],
  { sort, shown, words }: ListOptions,
  range: number,
): AttemptRow[] {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean);
  const all = [...plays.map((play) => ofPlay(play, range)), ...attempts.map((attempt) => ofAttempt(attempt, range))];
  const left = all.filter((entry) => {
    if (!IS_SHOWN[shown](entry)) return false;
    const text = `${entry.title} ${entry.end}`.toLowerCase();
    return wanted.every((word) => text.includes(word));
  });
  const order = ORDERS[sort];
  if (order !== null) left.sort(order);
  else if (sort === 'newest') left.reverse();
  return left.map((entry, place) => ({
    ...entry,
    depth: 1,
    label: `${entry.title}: ${entry.end}`,
    expanded: null,
    list: null,
    place,
    siblings: left.length,
  }));
}
