import type { EdgeSlack } from '../../../solver/index.ts';

/** `3 presses`, `1 press` */
export const plural = (count: number, one: string, many = `${one}s`): string =>
  `${count.toLocaleString('en')} ${count === 1 ? one : many}`;

/** `3.22 s` */
export const seconds = (time: number): string => `${time.toFixed(2)} s`;

/** A share from 0 to 1: `97.1 %`. A share that is not exactly 0 or 1 is never rounded to it. */
export function percent(share: number): string {
  if (share === 0 || share === 1) return `${100 * share} %`;
  const rounded = (100 * share).toFixed(1);
  if (rounded === '0.0') return '< 0.1 %';
  return rounded === '100.0' ? '> 99.9 %' : `${rounded} %`;
}

/** A length over many powers of ten: `0.42 px`, `3.1e-7 px`, `0 px`. */
export function pixels(length: number): string {
  if (length === 0) return '0 px';
  if (length >= 100) return `${Math.round(length).toLocaleString('en')} px`;
  if (length >= 0.01) return `${Number(length.toPrecision(2))} px`;
  return `${length.toExponential(0)} px`;
}

/** A large count in short: `1.4 M`, `320 k`, `950`. */
export function about(count: number): string {
  if (count >= 1e6) return `${(count / 1e6).toFixed(1)} M`;
  if (count >= 1e4) return `${Math.round(count / 1e3)} k`;
  return String(Math.round(count));
}

/** What collecting all minerals costs beyond the measured run: `3.10 s slower, 1 press more`. */
export function extraInWords(time: number, presses: number): string {
  const slower = `${seconds(Math.abs(time))} ${time < 0 ? 'quicker' : 'slower'}`;
  const more = `${plural(Math.abs(presses), 'press', 'presses')} ${presses < 0 ? 'fewer' : 'more'}`;
  return [Math.abs(time) < 0.005 ? 'as quick' : slower, presses === 0 ? 'as many presses' : more].join(', ');
}

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

/** A labelled value. */
export interface Fact {
  readonly label: string;
  readonly value: string;
  /** The tick that it refers to: a click moves the timeline there. */
  readonly tick?: number;
  readonly tone?: 'good' | 'bad' | 'warn';
}
