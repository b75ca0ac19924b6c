import { type Motion, SLOTS } from '../../motion/index.ts';
import { driftsBy, untilTick } from './orbits.ts';

const { START, AWAKE_COUNT, CROSSED, CROSSED_BEFORE } = SLOTS;

/**
 * She swings on a line through the centre, faster than the ticks. After two crossings everything but the time is as before, so
 * whole periods are skipped up to the next tick.
 */
export function skipPeriods(m: Motion): void {
  const { s } = m;
  const period = s[CROSSED] > 0 ? s[START] - s[CROSSED_BEFORE] : 0;
  if (s[CROSSED_BEFORE] > 0 && period > 0 && s[AWAKE_COUNT] === 0) {
    const skipped = Math.floor(untilTick(s[START]) / period) - 1;
    if (skipped > 0 && (!m.recoil || driftsBy(m, skipped * period, period))) {
      s[START] += skipped * period;
      m.modeSeconds[m.mode] += skipped * period;
      s[CROSSED] += skipped * period;
    }
  }
  s[CROSSED_BEFORE] = s[CROSSED];
  s[CROSSED] = s[START];
}
