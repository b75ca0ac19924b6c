import { TICK_RATE } from '../constants.ts';
import { type Motion, SLOTS } from '../motion/index.ts';
import type { Ending } from '../simulation.ts';

const { OUTCOME, TOUCHED, END_TIME } = SLOTS;

/** How the run ended, or null while it goes on. */
export function endingOf({ s, parts }: Motion): Ending | null {
  const ends = s[OUTCOME] === 0 ? null : parts.byKind[s[OUTCOME]].ends;
  if (ends === null) return null;
  const { outcome, touches } = ends;
  const time = s[END_TIME];
  return {
    outcome,
    with: touches === null ? null : { kind: touches, index: s[TOUCHED] },
    time,
    tick: Math.floor(time * TICK_RATE + 1e-9),
  };
}
