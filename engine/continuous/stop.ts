import {
  ALERTNESS,
  awakeAt,
  type Motion,
  movesAlong,
  pairAt,
  RECORDS,
  SLOTS,
  settleAndTurnAt,
  straightenBody,
} from '../motion/index.ts';

const { START, FROM, HELD, TARGET, FIELD, BASE, BASE_X, BASE_Y, COS, SIN, LAST_EVENT, AWAKE_COUNT } = SLOTS;
const { CHASER, ROCK } = RECORDS;
const { ASLEEP, AWAKE } = ALERTNESS;

/** Ends the piece after `t`: moves everything to where it is then; the next piece begins at `time`. */
export function stop(m: Motion, t: number, time: number): void {
  const { s, her, base, facing, ux, uy, px, py } = m;
  m.recorder?.piece(m, t);
  m.modeSeconds[m.mode] += t;
  settleAndTurnAt(m, t);
  s[COS] = facing[0];
  s[SIN] = facing[1];
  const awake = s[AWAKE_COUNT];
  for (let k = 0; k < awake; k++) settleChaser(m, awakeAt(m, k), t);
  const drag = m.chasers + CHASER * m.chaserCount;
  if (m.recoils && s[drag + 4] === AWAKE) {
    settleChaser(m, m.chaserCount, t);
    const rock = m.rocks + ROCK * s[TARGET];
    for (let k = 0; k < ROCK; k++) s[rock + k] = s[drag + k];
    if (movesAlong(m, s[TARGET])) straightenBody(m, rock);
    s[drag + 4] = ASLEEP;
  }
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

function settleChaser(m: Motion, i: number, t: number): void {
  const { s } = m;
  const qx = m.chaserX[i];
  const qy = m.chaserY[i];
  const o = m.chasers + CHASER * i;
  pairAt(qx, qy, m.integrator.degree, t, s, o);
  // the series begins here too, in case it is read before the next piece is made
  qx[0] = s[o];
  qy[0] = s[o + 1];
}
