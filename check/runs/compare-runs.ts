import { type Outcome, type RunEvent, TICK } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { eventInWords, plural } from '../words/index.ts';
import { compareHolds, firstDifference } from './compare-holds.ts';

// Two runs of a level: what differs in their holds and figures, where they part and meet, and all that in words.

/** What is compared of a run. */
export interface ComparableRun {
  /** Sorted and disjoint. */
  readonly holds: readonly Hold[];
  readonly outcome: Outcome;
  /** s */
  readonly time: number;
  /** How many different minerals it collects. */
  readonly minerals: number;
  /** The least distance to a hazard, px; null if there is none. */
  readonly clearance: number | null;
  /** The smallest room of a press or release, both directions together, ticks; null if it is not known or the run fails. */
  readonly slack: number | null;
}

/** A hold of the one run, of the other, or of both. */
export interface HoldPair {
  readonly one: Hold | null;
  readonly other: Hold | null;
  /** How much later the other run presses and releases, ticks; null unless both have the hold. */
  readonly press: number | null;
  readonly release: number | null;
}

/** Which of two runs does better; null: neither, or it can't be said. */
export type Better = 'one' | 'other' | null;

/** A figure of both runs. */
export interface Comparison<T> {
  readonly one: T;
  readonly other: T;
  readonly better: Better;
}

/** The difference of two runs. */
export interface RunsDifference {
  /** The first tick at which the scripts differ; null: they are the same. */
  readonly from: number | null;
  /** In order of time. */
  readonly holds: readonly HoldPair[];
  readonly outcome: Comparison<Outcome>;
  /** Less is better where both complete the level. */
  readonly time: Comparison<number>;
  readonly minerals: Comparison<number>;
  readonly clearance: Comparison<number | null>;
  readonly slack: Comparison<number | null>;
}

/** @param sign 1 if more is better, -1 if less is */
function compared<T extends number | null>(one: T, other: T, sign: 1 | -1): Comparison<T> {
  const by = one === null || other === null ? 0 : sign * (one - other);
  return { one, other, better: by > 0 ? 'one' : by < 0 ? 'other' : null };
}

/** All holds of both runs; those of each are in order of time. */
function pairsOf(one: readonly Hold[], other: readonly Hold[]): HoldPair[] {
  const all: HoldPair[] = [];
  let [i, j] = [0, 0];
  const alone = (untilOne: number, untilOther: number) => {
    while (i < untilOne || j < untilOther) {
      const isOne = j >= untilOther || (i < untilOne && one[i][0] <= other[j][0]);
      if (isOne) all.push({ one: one[i++], other: null, press: null, release: null });
      else all.push({ one: null, other: other[j++], press: null, release: null });
    }
  };
  for (const [a, b] of compareHolds(one, other).pairs) {
    alone(a, b);
    all.push({ one: one[a], other: other[b], press: other[b][0] - one[a][0], release: other[b][1] - one[a][1] });
    [i, j] = [a + 1, b + 1];
  }
  alone(one.length, other.length);
  return all;
}

/** Compares two runs of a level. */
export function compareRuns(one: ComparableRun, other: ComparableRun): RunsDifference {
  const from = firstDifference(one.holds, other.holds);
  const [a, b] = [one.outcome === 'completed', other.outcome === 'completed'];
  const time = compared(one.time, other.time, -1);
  return {
    from: Number.isFinite(from) ? from : null,
    holds: pairsOf(one.holds, other.holds),
    outcome: { one: one.outcome, other: other.outcome, better: a === b ? null : a ? 'one' : 'other' },
    time: a && b ? time : { ...time, better: null },
    minerals: compared(one.minerals, other.minerals, 1),
    clearance: compared(one.clearance, other.clearance, 1),
    slack: compared(one.slack, other.slack, 1),
  };
}

/** px by which two runs must be apart to have parted. */
export const APART = 1;

/** px: two runs that were farther from each other than `AWAY` meet again where they are at most `TOGETHER` apart. */
export const TOGETHER = 8;
export const AWAY = 16;

/** Her way in a run, and what happened on it. */
export interface RunWay {
  /** x, y in px at every tick and at the end, alternating. */
  readonly points: ArrayLike<number>;
  readonly events: readonly RunEvent[];
}

/** How the ways of two runs of the same level go apart. */
export interface WaysApart {
  /** px at every tick, as long as both last */
  readonly distances: Float64Array;
  readonly partings: Partings;
  /** The contact or switch by which they begin to go different ways; null: none. */
  readonly decided: FirstDifferent | null;
}

/** Compares the ways of two runs, tick by tick. */
export function waysApart({ points: one, events }: RunWay, { points: other, events: others }: RunWay): WaysApart {
  // the last entry of each is at its end, which is no tick
  const count = Math.max(0, Math.min(one.length, other.length) / 2 - 1);
  const distances = Float64Array.from({ length: count }, (_, tick) => {
    const [dx, dy] = [one[2 * tick] - other[2 * tick], one[2 * tick + 1] - other[2 * tick + 1]];
    return Math.sqrt(dx * dx + dy * dy);
  });
  return { distances, partings: partingsOf(distances), decided: firstDifferentEvent(events, others) };
}

/** Where two runs are nearest again. */
interface Meeting {
  readonly tick: number;
  /** px */
  readonly distance: number;
}

/** Where two runs part and meet. */
export interface Partings {
  /** The first tick at which they are more than `APART` from each other; null: they never are. */
  readonly parts: number | null;
  /** Their nearest moments after they were away from each other, in order of time. */
  readonly meets: readonly Meeting[];
}

/** Finds where two runs part and meet again. @param distances px at every tick */
export function partingsOf(distances: ArrayLike<number>): Partings {
  let parts: number | null = null;
  let isAway = false;
  let near: Meeting | null = null;
  const meets: Meeting[] = [];
  for (let tick = 0; tick < distances.length; tick++) {
    const distance = distances[tick];
    if (distance > APART) parts ??= tick;
    if (distance > AWAY) isAway = true;
    if (isAway && distance <= TOGETHER && (near === null || distance < near.distance)) near = { tick, distance };
    else if (near !== null && distance > AWAY) {
      meets.push(near);
      near = null;
    }
  }
  return { parts, meets: near === null ? meets : [...meets, near] };
}

/** The first events in which two runs differ; undefined where one of them has no more. */
export interface FirstDifferent {
  readonly one: RunEvent | undefined;
  readonly other: RunEvent | undefined;
}

/** What happens to what, apart from when. */
const happening = ({ time: _, ...what }: RunEvent): string => JSON.stringify(what);

/** Finds the contact, or the switch of a target, by which two runs of the same holds begin to go different ways; null: none. */
export function firstDifferentEvent(one: readonly RunEvent[], other: readonly RunEvent[]): FirstDifferent | null {
  const [a, b] = [one, other].map((events) => events.filter(({ type }) => type !== 'press' && type !== 'release'));
  const at = Array.from({ length: Math.max(a.length, b.length) }, (_, i) => i).find(
    (i) => i >= a.length || i >= b.length || happening(a[i]) !== happening(b[i]),
  );
  return at === undefined ? null : { one: a[at], other: b[at] };
}

/** Which contact or switch decided: `first otherwise: mineral: mineral 1 at 0.11 s, at precise nothing more`. @param one the name of the first */
export function decidedInWords(decided: FirstDifferent, one: string): string {
  const text = (event: RunEvent | undefined): string =>
    event === undefined ? 'nothing more' : `${eventInWords(event)} at ${event.time.toFixed(2)} s`;
  return `first otherwise: ${text(decided.other)}, at ${one} ${text(decided.one)}`;
}

/** `3 ticks later`, `as early` */
const shiftInWords = (ticks: number): string =>
  ticks === 0 ? 'at the same tick' : `${plural(Math.abs(ticks), 'tick')} ${ticks > 0 ? 'later' : 'earlier'}`;

/** A pair of holds in words. @param names of both runs */
export function pairInWords({ one, other, press, release }: HoldPair, names: readonly [one: string, other: string]): string {
  if (one === null || other === null) return `only in ${one === null ? names[1] : names[0]}`;
  if (press === 0 && release === 0) return 'the same';
  if (press === release && press !== null) return `${shiftInWords(press)} as a whole`;
  return `press ${shiftInWords(press ?? 0)}, release ${shiftInWords(release ?? 0)}`;
}

const at = (tick: number): string => `tick ${tick} (${(tick * TICK).toFixed(2)} s)`;

/** Meetings that are named; more are counted. */
const MOST = 3;

/** Where two runs part and meet, in sentences. @param partings null: not known yet */
export function partingsInWords({ from }: Pick<RunsDifference, 'from'>, partings: Partings | null): string {
  if (from !== null) return `Their holds differ from ${at(from)} on.${partings === null ? '' : ` ${waysInWords(partings)}`}`;
  const same = 'Both press and release at the same ticks.';
  // at one accuracy, they go the same way, too
  return partings === null || partings.parts === null ? same : `${same} ${waysInWords(partings)}`;
}

/** Where the ways of two runs part and meet, in a sentence. */
export function waysInWords({ parts, meets }: Partings): string {
  if (parts === null) return 'They are never more than 1 px apart while both last.';
  const ways = `They are more than 1 px apart from ${at(parts)} on`;
  if (meets.length === 0) return `${ways}, and do not meet again.`;
  const named = meets.slice(0, MOST).map(({ tick, distance }) => `${distance.toFixed(1)} px at ${at(tick)}`);
  const more = meets.length > MOST ? ` and ${meets.length - MOST} times more` : '';
  return `${ways}, and come near each other again: ${named.join(', ')}${more}.`;
}
