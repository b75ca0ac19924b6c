import { type EventRule, type Motion, ONSETS, type Parts, SLOTS } from '../motion/index.ts';

const { FROM, NEXT, EVENT, EVENT_A, EVENT_B, LAST_EVENT, LAST_A, LENGTH_H, ONSET } = SLOTS;
const { COMES, STANDS, TOUCHES } = ONSETS;

/**
 * Makes a kind of event: an {@link EventRule} in which what is left out has a default. A set of effects sets its place in the
 * order.
 */
export function eventRule(rule: Pick<EventRule, 'name' | 'fire'> & Partial<Omit<EventRule, 'kind'>>): EventRule {
  // written out, so that all have the same hidden class and V8 finds properties fast
  return {
    name: rule.name,
    kind: 0,
    ends: rule.ends ?? null,
    passing: rule.passing ?? false,
    keepsPeriod: rule.keepsPeriod ?? false,
    list: rule.list ?? null,
    guard: rule.guard ?? null,
    isOver: rule.isOver ?? null,
    quiet: rule.quiet ?? null,
    first: rule.first ?? null,
    latest: rule.latest ?? null,
    always: rule.always ?? null,
    alwaysQuiet: rule.alwaysQuiet ?? null,
    fire: rule.fire,
  };
}

/**
 * Lays out the kinds of events of the chosen effects.
 * @param all - every kind there is, in order
 * @param listedFirst - those with which the neighbour list begins, if they are chosen
 * @param chosen - those that can happen
 */
export function layOutRules(
  all: readonly EventRule[],
  listedFirst: readonly EventRule[],
  chosen: readonly EventRule[],
): Pick<Parts, 'byKind' | 'list' | 'first' | 'latest' | 'always' | 'alwaysQuiet'> {
  const used = all.filter((rule) => chosen.includes(rule));
  const byKind: EventRule[] = [];
  for (const rule of all) byKind[rule.kind] = rule;
  return {
    byKind,
    list: [...new Set([...listedFirst, ...all])].filter((rule) => used.includes(rule) && rule.list !== null),
    first: used.filter((rule) => rule.first !== null),
    latest: used.filter((rule) => rule.latest !== null),
    always: used.filter((rule) => rule.always !== null),
    alwaysQuiet: used.filter((rule) => rule.alwaysQuiet !== null),
  };
}

/**
 * Offers an event: it is kept if it is earlier than the best so far, or at the same instant and first in the order; of two
 * events of one kind, that with the object that comes first in the list.
 * @param time - s after the start of the piece; negative if there is no event
 * @param kind - the kind of event; the smaller goes first
 * @param a - index of the object concerned
 * @param b - index of a second object
 */
export const offer = (m: Motion, time: number, kind: number, a: number, b: number): void =>
  offerFrom(m, time, kind, a, b, -1, false);

/**
 * The same for an event that may be there where the search for events begins: what stands there comes before everything that
 * only begins at the same instant; what only touches there waits for the button.
 * @param from - where the search begins, s after the start of the piece
 * @param stands - whether it stands there, if it is there
 */
export function offerFrom(m: Motion, time: number, kind: number, a: number, b: number, from: number, stands: boolean): void {
  if (time < 0) return;
  const { s } = m;
  const same = m.sameInstant;
  if (time > s[LENGTH_H]) return;
  const onset = time !== from ? COMES : stands ? STANDS : TOUCHES;
  const isFirst = kind < s[EVENT] || (kind === s[EVENT] && a < s[EVENT_A]);
  if ((onset === STANDS) === (s[ONSET] === STANDS)) {
    if (!(time < s[NEXT] - same) && !(time <= s[NEXT] + same && isFirst)) return;
  } else if (onset !== STANDS) {
    return;
  }
  // the instant begins as the earliest of its events does
  if (onset === STANDS || time <= s[NEXT]) {
    s[NEXT] = Math.min(s[NEXT], time);
    s[ONSET] = onset;
  }
  s[EVENT] = kind;
  s[EVENT_A] = a;
  s[EVENT_B] = b;
}

/** Whether this event has just happened to `a`, at the very start of the piece. Then its guard is 0 there. */
export function justFired(m: Motion, event: number, a: number): boolean {
  const { s } = m;
  return s[FROM] === 0 && s[LAST_EVENT] === event && s[LAST_A] === a;
}
