import { type Motion, SLOTS } from '../motion/index.ts';

const { FROM, NEXT, EVENT, EVENT_A, EVENT_B, LAST_EVENT, LAST_A, LENGTH_H } = SLOTS;

/**
 * Takes an event if it is earlier than the best so far, or of the same instant and goes first.
 * @param time s from the start of the piece; negative where there is none
 * @param kind its code, of which the smaller goes first
 * @param a what it happens to; `b` likewise
 */
export function offer(m: Motion, time: number, kind: number, a: number, b: number): void {
  if (time < 0) return;
  const { s } = m;
  const same = m.sameInstant;
  if (time > s[LENGTH_H]) return;
  const earlier = time < s[NEXT] - same;
  if (!earlier && !(time <= s[NEXT] + same && kind < s[EVENT])) return;
  s[NEXT] = Math.min(s[NEXT], time);
  s[EVENT] = kind;
  s[EVENT_A] = a;
  s[EVENT_B] = b;
}

/** Whether this event has just happened to `a`, at the very start of the piece: its guard stands at 0 there. */
export function justFired(m: Motion, event: number, a: number): boolean {
  const { s } = m;
  return s[FROM] === 0 && s[LAST_EVENT] === event && s[LAST_A] === a;
}
