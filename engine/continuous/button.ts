import { recordTarget } from '../effects/index.ts';
import { type Motion, nearest, SLOTS } from '../motion/index.ts';
import { begin } from './begin.ts';
import { stop } from './stop.ts';

const { START, HELD, TARGET, COVER, MOVES, CROSSED } = SLOTS;

/** Presses or releases at `time`, s. */
export function button(m: Motion, held: boolean, time: number): void {
  const { s, recorder } = m;
  stop(m, time - s[START], time);
  s[HELD] = held ? 1 : 0;
  s[CROSSED] = 0;
  if (held && m.recoils) s[MOVES] = 1;
  s[TARGET] = held ? nearest(m) : -1;
  if (held) s[COVER] = s[TARGET];
  if (recorder !== null) {
    recorder.event({ time, type: held ? 'press' : 'release' });
    if (held) recordTarget(m, time);
  }
  begin(m);
}
