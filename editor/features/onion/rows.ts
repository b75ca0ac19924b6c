import { bodyInWords, reasonInWords } from '../../../check/words/index.ts';
import { pixels, seconds, type Tightest } from '../../core/figures/index.ts';
import type { NearMiss } from '../../core/proof/index.ts';
import type { Figures, SlackKnown } from './former.ts';

/** How a figure differs from the former one. `other`: neither better nor worse. `unknown`: one of them is not known. */
export type Difference = 'better' | 'worse' | 'same' | 'other' | 'unknown';

/** One figure, before and after. */
export interface Row {
  readonly label: string;
  readonly before: string;
  readonly after: string;
  /** By how much they differ, `+0.15 s`; '' if that says nothing. */
  readonly by: string;
  readonly difference: Difference;
}

const MINUS = '−';

/** `+2`, `−0.15 s`; '' for 0. @param words of the amount without its sign */
const signed = (difference: number, words: (amount: number) => string): string =>
  difference === 0 ? '' : `${difference > 0 ? '+' : MINUS}${words(Math.abs(difference))}`;

const moreIsBetter = (before: number, after: number): Difference =>
  before === after ? 'same' : after > before ? 'better' : 'worse';

function outcomeRow({ end: then, range: formerRange }: Known, { end: now, range }: Known): Row {
  const before = reasonInWords(then, formerRange) ?? 'completes';
  const after = reasonInWords(now, range) ?? 'completes';
  const [did, does] = [then.outcome === 'completed', now.outcome === 'completed'];
  const difference = did === does ? (before === after ? 'same' : 'other') : does ? 'better' : 'worse';
  return { label: 'run', before, after, by: '', difference };
}

function timeRow({ end: then }: Known, { end: now }: Known): Row {
  const [before, after] = [seconds(then.time), seconds(now.time)];
  // the difference of what is shown, so that it can be checked by eye
  const shown = Number(after.slice(0, -2)) - Number(before.slice(0, -2));
  const by = before === after && then.time !== now.time ? 'by less than 0.01 s' : signed(shown, seconds);
  return { label: 'time', before, after, by, difference: then.time === now.time ? 'same' : 'other' };
}

const roomInWords = ({ room, isMore }: Tightest): string =>
  `${room}${isMore ? '+' : ''} ${room === 1 && !isMore ? 'tick' : 'ticks'}`;

function slackInWords(slack: SlackKnown): string {
  switch (slack.is) {
    case 'measuring':
      return '…';
    case 'fails':
      return 'none: it fails';
    case 'unknown':
      return 'not known';
    case 'measured':
      return slack.tightest === null ? 'no holds' : roomInWords(slack.tightest);
  }
}

function slackRow(then: SlackKnown, now: SlackKnown): Row {
  const row = { label: 'least slack', before: slackInWords(then), after: slackInWords(now), by: '' };
  if (then.is === 'fails' && now.is === 'fails') return { ...row, difference: 'same' };
  if (then.is !== 'measured' || now.is !== 'measured') {
    const isKnown = [then, now].every(({ is }) => is === 'measured' || is === 'fails');
    return { ...row, difference: isKnown ? (now.is === 'measured' ? 'better' : 'worse') : 'unknown' };
  }
  if (then.tightest === null || now.tightest === null) {
    return { ...row, difference: then.tightest === now.tightest ? 'same' : 'other' };
  }
  const [old, own] = [then.tightest, now.tightest];
  // of what reaches the limit of the measurement, the excess is not known
  if (old.isMore && own.isMore) return { ...row, difference: old.room === own.room ? 'same' : 'unknown' };
  if (old.isMore ? own.room >= old.room : own.isMore && old.room >= own.room) return { ...row, difference: 'unknown' };
  const by = old.isMore || own.isMore ? '' : signed(own.room - old.room, String);
  return { ...row, by, difference: moreIsBetter(old.room, own.room) };
}

/** px between her box and the hazard; 0 where they overlap */
const gapOf = ({ gap }: NearMiss): number => Math.max(0, gap);

const gapInWords = (closest: NearMiss): string => `${pixels(gapOf(closest))} from ${bodyInWords(closest)}`;

function clearanceRow({ closest: then }: Known, { closest: now }: Known): Row[] {
  if (then === null && now === null) return [];
  const row = { label: 'clearance', before: then === null ? 'no hazard' : gapInWords(then), by: '' };
  if (then === null || now === null) {
    return [{ ...row, after: now === null ? 'no hazard' : gapInWords(now), difference: now === null ? 'better' : 'worse' }];
  }
  const isSameHazard = then.kind === now.kind && then.index === now.index;
  return [
    {
      ...row,
      before: isSameHazard ? pixels(gapOf(then)) : row.before,
      after: gapInWords(now),
      by: signed(gapOf(now) - gapOf(then), pixels),
      difference: moreIsBetter(gapOf(then), gapOf(now)),
    },
  ];
}

/** Minerals are told only where they differ. */
function mineralRow(then: Figures, now: Figures): Row[] {
  if (then.taken === now.taken && then.minerals === now.minerals) return [];
  const [before, after] = [then, now].map(({ taken, minerals }) => `${taken} of ${minerals}`);
  const difference = then.taken === now.taken ? 'other' : moreIsBetter(then.taken, now.taken);
  return [{ label: 'minerals', before, after, by: signed(now.taken - then.taken, String), difference }];
}

interface Known extends Figures {
  readonly end: NonNullable<Figures['end']>;
}

const isKnown = (figures: Figures): figures is Known => figures.end !== null;

const endOf = (figures: Figures): string =>
  isKnown(figures) ? (reasonInWords(figures.end, figures.range) ?? 'completes') : 'not known';

/** The figures of a run before and after a change. What is not known of one of them is not compared. */
export function rowsOf(
  then: Figures,
  now: Figures,
  slack: { readonly before: SlackKnown; readonly now: SlackKnown },
): readonly Row[] {
  if (!isKnown(then) || !isKnown(now))
    return [{ label: 'run', before: endOf(then), after: endOf(now), by: '', difference: 'unknown' }];
  return [
    outcomeRow(then, now),
    timeRow(then, now),
    slackRow(slack.before, slack.now),
    ...clearanceRow(then, now),
    ...mineralRow(then, now),
  ];
}

/** Why something is not compared; null: everything is. */
export const whyUnknown = (then: Figures, now: Figures): string | null =>
  isKnown(now) ? (isKnown(then) ? null : then.unknown) : now.unknown;

const SAID: Readonly<Record<Difference, string>> = {
  better: ', better',
  worse: ', worse',
  same: '',
  other: '',
  unknown: '',
};

function rowInWords({ label, before, after, by, difference }: Row): string {
  if (difference === 'same' || (before === after && by === '')) return `${label} ${after}, as before`;
  return `${label} ${before}, now ${after}${by === '' ? '' : `, ${by.replace(MINUS, 'minus ').replace('+', 'plus ')}`}${SAID[difference]}`;
}

/** All differences as one sentence, for a screen reader. */
export function rowsInWords(rows: readonly Row[], unknown: string | null): string {
  if (unknown !== null) return `Before and after can't be compared: ${unknown}.`;
  const told = rows.filter(({ after }) => after !== '…');
  if (told.every(({ difference }) => difference === 'same'))
    return `As before: ${told.map(({ label, after }) => `${label} ${after}`).join('; ')}.`;
  return `Before and after: ${told.map(rowInWords).join('; ')}.`;
}
