import { TICK_RATE } from '../constants.ts';
import { recordTarget } from '../effects/index.ts';
import { quietTime } from '../events/index.ts';
import {
  arriveAndTurnAt,
  COAST,
  directionAt,
  GOES_ON,
  isInCentre,
  type Motion,
  movesAlong,
  nearest,
  PIECE_END,
  RECORDS,
  SLIDE,
  SLOTS,
  straightenBody,
} from '../motion/index.ts';
import type { Ending } from '../simulation.ts';
import { begin, locate, proceed } from './begin.ts';

const { START, FROM, NEXT, EVENT, EVENT_A, EVENT_B, LIMIT_X, LIMIT_Y, OUTCOME, TOUCHED, END_TIME } = SLOTS;
const { LAST_EVENT, CROSSED, RIM, HELD, TARGET, COVER, MOVES, KIND, COS, SIN, DEGREE, FIELD, BASE, BASE_X } = SLOTS;
const { BASE_Y, AWAKE_COUNT } = SLOTS;
const { ROCK } = RECORDS;

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
  else endRun(m, rule.kind, touched, time);
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

function endRun(m: Motion, kind: number, index: number, time: number): void {
  const { s, recorder } = m;
  s[OUTCOME] = kind;
  s[TOUCHED] = index;
  s[END_TIME] = time;
  const ending = endingOf(m);
  if (ending !== null) recorder?.event({ time, type: ending.outcome, with: ending.with });
}

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

/**
 * Makes the fixed steps up to `until` during which nothing can happen, without looking for events: the number of steps she
 * needs at least to reach the nearest guard. The bits are the same as piece after piece.
 */
function skipQuietSteps(m: Motion, until: number): void {
  const { s, ux, uy, flow, integrator, work } = m;
  const { rate } = m.scene.accuracy;
  if (integrator.glide === null || rate === null || m.recoil || s[KIND] === COAST || s[KIND] === SLIDE || flow.isSteady) return;
  // orbits may be skipped at the end of any piece, so no piece may be left out
  if (m.parts.mayRepeat.some((mayRepeat) => mayRepeat(m))) return;
  const end = Math.min(until, s[START] + quietTime(m));
  const from = s[START];
  m.steps[0] = 0;
  const start = integrator.glide(flow, ux, uy, from, end, rate, m.steps);
  const steps = m.steps[0];
  if (steps === 0) return;
  s[START] = start;
  s[DEGREE] = 1;
  directionAt(m, 0);
  s[COS] = m.facing[0];
  s[SIN] = m.facing[1];
  m.modeSeconds[m.mode] += start - from;
  work.pieces += steps;
  work.forceEvaluations += steps * integrator.evaluations;
}

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

/** Ends the piece after `t`: moves everything to where it is then; the next piece begins at `time`. */
function stop(m: Motion, t: number, time: number): void {
  const { s, her, base, facing, ux, uy, px, py } = m;
  m.recorder?.piece(m, t);
  m.modeSeconds[m.mode] += t;
  arriveAndTurnAt(m, t);
  s[COS] = facing[0];
  s[SIN] = facing[1];
  // while all chasers sleep they cost nothing
  if (s[AWAKE_COUNT] > 0 || m.recoils) m.parts.following?.arrive(m, t);
  ux[0] = her[0];
  uy[0] = her[1];
  ux[1] = her[2];
  uy[1] = her[3];
  if (m.recoil) {
    const dragged = s[HELD] === 1 && s[FIELD] >= 0 ? s[TARGET] : -1;
    for (const i of m.stirred) {
      const o = m.rocks + ROCK * i;
      if (i === s[BASE] || i === dragged) continue;
      s[o] += s[o + 2] * t;
      s[o + 1] += s[o + 3] * t;
      if (movesAlong(m, i)) straightenBody(m, o);
    }
    s[BASE_X] += base[0];
    s[BASE_Y] += base[1];
    px[0] = 0;
    py[0] = 0;
    px[1] = base[2];
    py[1] = base[3];
    if (s[BASE] >= 0) {
      const o = m.rocks + ROCK * s[BASE];
      s[o] = s[BASE_X];
      s[o + 1] = s[BASE_Y];
      s[o + 2] = base[2];
      s[o + 3] = base[3];
      if (movesAlong(m, s[BASE])) {
        straightenBody(m, o);
        s[BASE_X] = s[o];
        s[BASE_Y] = s[o + 1];
      }
    }
  }
  s[START] = time;
  s[FROM] = 0;
  if (t > 0) s[LAST_EVENT] = 0;
}
