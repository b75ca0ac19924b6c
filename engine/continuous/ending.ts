import { TICK_RATE } from '../constants.ts';
import type { BodyKind, Ending } from '../simulation.ts';
import type { Motion } from './motion.ts';
import { SLOTS } from './state.ts';

const { OUTCOME, TOUCHED, END_TIME } = SLOTS;

// by the kind of event that ended the run
const OUTCOME_OF: readonly (Ending['outcome'] | null)[] = [null, null, 'collided', 'collided', 'collided', 'completed', 'lost'];
const TOUCH_KIND: readonly (BodyKind | null)[] = [null, null, 'nova', 'asteroid', 'alien', 'blackHole', null];

/** How the run ended, or null while it goes on. */
export function endingOf({ s }: Motion): Ending | null {
  const code = s[OUTCOME];
  const outcome = OUTCOME_OF[code];
  if (outcome === null) return null;
  const time = s[END_TIME];
  const kind = TOUCH_KIND[code];
  return {
    outcome,
    with: kind === null ? null : { kind, index: s[TOUCHED] },
    time,
    tick: Math.floor(time * TICK_RATE + 1e-9),
  };
}
