import { ALIEN_PULL, ALIEN_SIGHT, HALF_DIAGONAL } from '../constants.ts';
import type { IndexedCircles } from '../scene.ts';
import type { Motion } from './motion.ts';
import { targetsAround } from './rocks.ts';
import { ALERTNESS, EVENTS, RECORDS, SLOTS } from './state.ts';

const { TARGET } = SLOTS;
const { MINERAL, NOVA, HOT, ALIEN_TOUCH, HOLE, SWITCH, ENTER, WAKE } = EVENTS;
const { CHASER, ROCK } = RECORDS;
const { AWAKE } = ALERTNESS;

/** Makes the neighbour list anew around (x, y) for a path of length `reach`. */
export function refresh(m: Motion, x: number, y: number, reach: number): void {
  const { s, scene, near, recoil } = m;
  const { targets, novae, minerals, repulsors, aliens, level } = scene;
  // places of rocks change under recoil: then the list serves one piece
  const skin = recoil ? reach : Math.max(2 * reach, 64);
  near.restart(x, y, skin, s[TARGET]);
  const levelX = x + m.originX;
  const levelY = y + m.originY;
  const margin = HALF_DIAGONAL + 1e-6;
  const distance = (cx: number, cy: number) => Math.sqrt((cx - x) * (cx - x) + (cy - y) * (cy - y));
  const touching = (kind: number, circles: IndexedCircles, i: number) =>
    near.add(kind, i, distance(circles.x[i] - m.originX, circles.y[i] - m.originY) - circles.r[i] - margin);
  const each = (circles: IndexedCircles, within: number, visit: (i: number) => void) => {
    const { spatial } = circles;
    if (spatial !== null) {
      const found = spatial.around(levelX, levelY, within);
      m.budget.look(found.length >> 2);
      for (const i of found) visit(i);
    } else for (let i = 0; i < circles.count; i++) visit(i);
  };
  each(novae, skin + margin, (i) => touching(NOVA, novae, i));
  each(minerals, skin + margin, (i) => touching(MINERAL, minerals, i));
  each(repulsors, skin + margin, (i) => {
    const d = distance(repulsors.x[i] - m.originX, repulsors.y[i] - m.originY);
    near.add(ENTER, i, Math.abs(d - repulsors.r[i]) - 1e-6);
  });
  const hole = level.blackHole;
  near.add(HOLE, 0, distance(hole.x - m.originX, hole.y - m.originY) - hole.radius - margin);
  if (aliens.count > 0) {
    m.crowd.eachSleeperNear(x, y, skin, (i, d) => {
      near.add(WAKE, i, d - ALIEN_SIGHT - 1e-6);
      near.add(ALIEN_TOUCH, i, d - aliens.r[i] - margin);
    });
  }
  const target = s[TARGET];
  const own = target < 0 ? 0 : rockDistance(m, target, x, y);
  const rock = (i: number) => {
    if (i < scene.coldCount && (target < 0 || i === target)) return;
    const d = rockDistance(m, i, x, y);
    if (i >= scene.coldCount) near.add(HOT, i, d - targets.r[i] - margin);
    if (target >= 0 && i !== target) near.add(SWITCH, i, (d - own) / 2 - 1e-6);
  };
  const within = Math.max(skin + margin, 2 * skin + own + 1e-3);
  if (recoil && targets.spatial !== null) for (const i of targetsAround(m, x, y, within)) rock(i);
  else each(targets, within, rock);
  m.budget.look(near.count >> 2);
}

/** Distance of a target from (x, y) at the start of the piece, px. */
function rockDistance(m: Motion, i: number, x: number, y: number): number {
  const { s } = m;
  const dx = (m.recoil ? s[m.rocks + ROCK * i] : m.targetX[i]) - x;
  const dy = (m.recoil ? s[m.rocks + ROCK * i + 1] : m.targetY[i]) - y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** Farthest any drifting or recoiling rock moves in `h`, px. */
export function farthestRockTravel(m: Motion, h: number): number {
  const { s } = m;
  let fastest = 0;
  for (const i of m.stirred) {
    const o = m.rocks + ROCK * i;
    fastest = Math.max(fastest, s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]);
  }
  const v = Math.sqrt(fastest);
  const a = m.kappa;
  return v > 0 || a > 0 ? (v + a * h) * h : 0;
}

/** Farthest a target moves in `h`, px. */
export function rockTravel(m: Motion, i: number, h: number): number {
  const { s } = m;
  if (!m.recoil) return 0;
  const o = m.rocks + ROCK * i;
  const v = Math.sqrt(s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]);
  const a = i === s[TARGET] ? m.kappa : 0;
  return v > 0 || a > 0 ? (v + a * h) * h : 0;
}

/** Farthest an alien moves in `h`, px. */
export function alienTravel(m: Motion, i: number, h: number): number {
  const { s } = m;
  const o = m.chasers + CHASER * i;
  if (s[o + 4] !== AWAKE) return 0;
  return (Math.sqrt(s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]) + ALIEN_PULL * h) * h;
}
