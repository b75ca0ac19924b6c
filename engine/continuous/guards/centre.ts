import { bisect } from '../bracket.ts';
import { safeStep } from '../march.ts';
import type { Motion } from '../motion.ts';
import { pairAt } from '../polynomial.ts';
import { SLOTS } from '../state.ts';

const { SIDE, LINE_X, LINE_Y, DEGREE, LENGTH_H, ACCELERATION } = SLOTS;

/**
 * When she comes through the centre on a straight line.
 * @param from s from the start of the piece
 * @returns s from there, too; -1: not before the piece ends
 */
export function centreTime(m: Motion, from: number): number {
  const { s, e, work } = m;
  const side = s[SIDE];
  const horizon = Math.min(m.horizon, s[LENGTH_H]);
  let t = from;
  let before = from;
  work.guards++;
  for (let n = 0; ; n++) {
    m.budget.look(1);
    pairAt(m.ux, m.uy, s[DEGREE], t, e, 0);
    const g = side * (e[0] * s[LINE_X] + e[1] * s[LINE_Y]);
    const slope = side * (e[2] * s[LINE_X] + e[3] * s[LINE_Y]);
    if (n === 0 && g <= 0 && slope >= 0) {
      // on the centre, on the way out
    } else if (g < 0) {
      return n === 0 ? t : centreBetween(m, before, t);
    }
    if (t >= horizon) return -1;
    const step = safeStep(Math.max(g, 0), slope, s[ACCELERATION]);
    if (!(t + step < horizon)) return -1;
    before = t;
    t = Math.min(horizon, t + Math.max(step, s[LENGTH_H] * 1e-9));
  }
}

function centreBetween(m: Motion, before: number, behind: number): number {
  const { s, e } = m;
  m.work.roots++;
  return bisect(before, behind, (t) => {
    pairAt(m.ux, m.uy, s[DEGREE], t, e, 0);
    return s[SIDE] * (e[0] * s[LINE_X] + e[1] * s[LINE_Y]) < 0;
  });
}
