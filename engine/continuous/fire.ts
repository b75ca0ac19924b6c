import { GOES_ON, isInCentre, type Motion, PIECE_END, SLOTS } from '../motion/index.ts';
import { begin, proceed } from './begin.ts';
import { endingOf } from './ending.ts';
import { locate } from './locate.ts';
import { skipQuietSteps } from './skip.ts';
import { stop } from './stop.ts';

const { START, FROM, NEXT, EVENT, EVENT_A, EVENT_B, LIMIT_X, LIMIT_Y, OUTCOME, TOUCHED, END_TIME, LAST_EVENT, CROSSED, RIM } =
  SLOTS;

/** Carries out the event that was located. */
export function fire(m: Motion, until: number): void {
  const { s } = m;
  if (s[EVENT] === PIECE_END) {
    goOn(m, until);
    return;
  }
  const rule = m.parts.byKind[s[EVENT]];
  const a = s[EVENT_A];
  const b = s[EVENT_B];
  const time = s[START] + s[NEXT];
  if (rule.passing) {
    s[FROM] = s[NEXT];
    rule.fire(m, a, b, time);
    locate(m);
    return;
  }
  stop(m, s[NEXT], time);
  s[LAST_EVENT] = 0;
  if (!rule.keepsPeriod) s[CROSSED] = 0;
  const touched = rule.fire(m, a, b, time);
  if (touched === GOES_ON) begin(m);
  else end(m, rule.kind, touched, time);
}

/** The natural end of a piece: begins the next one of the same flow. */
function goOn(m: Motion, until: number): void {
  const { s, parts, integrator, recorder } = m;
  stop(m, s[NEXT], s[START] + s[NEXT]);
  s[LAST_EVENT] = 0;
  for (const repeat of parts.repeat) repeat(m);
  if (integrator.glide !== null && (recorder === null || !recorder.keeps)) skipQuietSteps(m, until);
  // on a rim, what holds her there is determined anew; under a steady force and close to a centre, whether she passes it
  if (s[LIMIT_X] === 0 && s[LIMIT_Y] === 0 && s[RIM] < 0 && !m.flow.isSteady && !isInCentre(m.flow, m.ux, m.uy)) proceed(m);
  else begin(m);
}

function end(m: Motion, kind: number, index: number, time: number): void {
  const { s, recorder } = m;
  s[OUTCOME] = kind;
  s[TOUCHED] = index;
  s[END_TIME] = time;
  const ending = endingOf(m);
  if (ending !== null) recorder?.event({ time, type: ending.outcome, with: ending.with });
}
