import { type Motion, RECORDS, SLOTS } from '../../motion/index.ts';
import { SHORTEST_BOUNCE } from '../../tolerances.ts';
import { actingField } from './fields.ts';

const { HELD, TARGET, BASE_X, BASE_Y, LIMIT_X, LIMIT_Y, RIM, OUTER } = SLOTS;
const { ROCK } = RECORDS;

/** This near to its centre the force outside has no reliable direction, px. */
const NO_DIRECTION = 1e-7;

/** Sets `m.rim`, the forces on the rim that she slides along, from the state at the start of the piece. */
export function setRim(m: Motion): void {
  aim(m, m.s[RIM], m.s[OUTER]);
}

function aim(m: Motion, field: number, outer: number): void {
  const { s, rim, scene } = m;
  const { repulsors } = scene;
  const cx = repulsors.x[field] - m.originX;
  const cy = repulsors.y[field] - m.originY;
  rim.radius = repulsors.r[field];
  rim.push = m.rules.push;
  rim.freeX = s[LIMIT_X] === 0;
  rim.freeY = s[LIMIT_Y] === 0;
  rim.qvx = rim.qvy = rim.kappa = 0;
  if (outer >= 0) {
    rim.alpha = m.rules.push;
    rim.beta = 0;
    rim.qx = repulsors.x[outer] - m.originX - cx;
    rim.qy = repulsors.y[outer] - m.originY - cy;
    return;
  }
  rim.alpha = -m.rules.pull;
  rim.beta = m.rules.pull / scene.level.range;
  const target = s[TARGET];
  if (m.recoil) {
    const o = m.rocks + ROCK * target;
    rim.qx = s[o] - cx;
    rim.qy = s[o + 1] - cy;
    rim.qvx = s[o + 2];
    rim.qvy = s[o + 3];
    rim.kappa = m.kappa;
  } else {
    rim.qx = m.targetX[target] - cx;
    rim.qy = m.targetY[target] - cy;
  }
}

/** The first field besides this one that contains her; -1 if there is none. */
function fieldBeside(m: Motion, field: number): number {
  for (let i = 0; i < m.scene.repulsors.count; i++) if (i !== field && m.s[m.own.repulsor + i] === 1) return i;
  return -1;
}

/**
 * Whether she is held on the rim of a field that contains her: it must be the field that acts inside, and from outside she must
 * be driven in more strongly than she flies out. Leaves the forces in `m.rim`.
 */
export function holdsOnRim(m: Motion, field: number): boolean {
  const { s, rim, ux, uy, px, py, scene } = m;
  // under a steady force she bounces instead; see rimTolerance
  if (actingField(m) !== field || m.flow.isSteady) return false;
  const outer = fieldBeside(m, field);
  if (outer < 0 && (s[HELD] === 0 || s[TARGET] < 0)) return false;
  s[OUTER] = outer;
  aim(m, field, outer);
  const x = s[BASE_X] + ux[0] - (scene.repulsors.x[field] - m.originX);
  const y = s[BASE_Y] + uy[0] - (scene.repulsors.y[field] - m.originY);
  const wx = x - rim.qx;
  const wy = y - rim.qy;
  if (wx * wx + wy * wy < NO_DIRECTION * NO_DIRECTION) return false;
  rim.weigh(x, y, ux[1] + px[1], uy[1] + py[1], wx, wy);
  return rim.pressesIn > 0;
}

/**
 * Whether she begins to slide as she crosses the rim of a field that contains her. Where the force outside drives her in and
 * the push drives her out, she bounces on the rim endlessly, and her bounces keep their height; at rest across the rim she
 * slides along it. A bounce has a mean velocity along the rim, with which she goes on.
 */
export function beginsToSlide(m: Motion, field: number): boolean {
  const { s, rim, ux, uy, px, py, scene } = m;
  const { repulsors } = scene;
  const x = s[BASE_X] + ux[0] - (repulsors.x[field] - m.originX);
  const y = s[BASE_Y] + uy[0] - (repulsors.y[field] - m.originY);
  const r = Math.sqrt(x * x + y * y);
  const across = (x * (ux[1] + px[1]) + y * (uy[1] + py[1])) / r;
  // at this speed across the rim a bounce takes too long, however strongly she is pressed back
  if (Math.abs(across) > (SHORTEST_BOUNCE * 5 * m.rules.push) / 2) return false;
  if (!holdsOnRim(m, field)) return false;
  const { pressesIn, pressesOut } = rim;
  if (2 * Math.abs(across) * (1 / pressesIn + 1 / pressesOut) > SHORTEST_BOUNCE) return false;
  if (rim.freeX && rim.freeY) {
    const nx = x / r;
    const ny = y / r;
    const outside = rim.forceX * nx + rim.forceY * ny;
    // she is faster than the mean as she comes in and slower as she goes out, by half of what the force outside adds in its
    // share of the time
    const gain = across / (pressesIn + pressesOut);
    ux[1] += gain * (rim.forceX - outside * nx) - across * nx;
    uy[1] += gain * (rim.forceY - outside * ny) - across * ny;
  }
  s[RIM] = field;
  return true;
}
