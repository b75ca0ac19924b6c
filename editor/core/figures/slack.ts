import type { EdgeSlack } from '../../../solver/index.ts';

/** Slack is measured up to this many ticks in each direction; a slack that reaches it may be larger. */
export const SLACK_LIMIT = 60;

/** `7`, `60+` */
export const slackText = (ticks: number): string => (ticks >= SLACK_LIMIT ? `${SLACK_LIMIT}+` : String(ticks));

/** The press or release of a run that may slip least. */
export interface Tightest {
  /** 2 i for the press of hold i, 2 i + 1 for its release; the first of equals. */
  readonly edge: number;
  /** How much it may slip in both directions together, ticks. */
  readonly room: number;
  /** Whether it may be more: only so much was measured. */
  readonly isMore: boolean;
}

/** The press or release that may slip least; null for a run without holds. @param slack of each press and release */
export function tightestOf(slack: readonly EdgeSlack[]): Tightest | null {
  let best: Tightest | null = null;
  for (const [edge, { earlier, later }] of slack.entries()) {
    const room = earlier + later;
    if (best === null || room < best.room) best = { edge, room, isMore: earlier >= SLACK_LIMIT || later >= SLACK_LIMIT };
  }
  return best;
}
