import { TICK } from '../../engine/index.ts';
import { easySpeed, recoilBlur } from './assumptions.ts';
import { startAxis } from './doomed.ts';
import { followPipes } from './pipe.ts';
import type { About, PipeGrid, Proof } from './proof.ts';
import { soonOverReason } from './say.ts';
import { CONTINUOUS, type Setting, type Thing } from './setting.ts';

/** Ticks per step, and the number of parts of half a turn by which sets are separated. */
const FRAMES = 2;
const TURNS = 8;

/** Side of a cell when everything ends within a second, px; it grows with the horizon. */
const CELL = 3.5;

/** The longest horizon by fineness, s. Sets grow with time, so longer ones are not tried. */
const LONGEST = [2.5, 4] as const;

/** Horizons to try: how much later than the longest sampled play everything may have ended, as a factor and s. */
const HORIZONS = [
  [1.1, 0.1],
  [1.3, 0.3],
] as const;

/** The most sets and parts by fineness; beyond them the prover gives up, so that certificates stay small. */
const MOST = [
  { sets: 2000, parts: 25_000 },
  { sets: 10_000, parts: 100_000 },
] as const;

/** The greatest fineness at which `flowpipe` differs from a lower one. */
export const FINEST_PIPES = MOST.length - 1;

/** The most sets and parts of any proof. */
export const MOST_PIPES = MOST[1];

/** Whether `flowpipe` may find a proof with this fineness. */
export function mayFlow(setting: Setting, fineness: number): boolean {
  const { level, rules, jump } = setting;
  const { vx, vy } = level.astronaut;
  const strongest = setting.strongest + recoilBlur(setting);
  const fastest = Math.sqrt(vx * vx + vy * vy) + 2 * strongest * LONGEST[Math.min(fineness, FINEST_PIPES)];
  // At rest she can wait for any time.
  return jump === 0 && (vx !== 0 || vy !== 0) && fastest <= easySpeed(rules);
}

/**
 * `flowpipe`: from a moving start, every run ends at a hazard, at an alien or out of range within seconds, and none comes near
 * the object. It covers continuous time.
 *
 * Like `doomed` it computes a reachable set, but much more tightly: sets are described by drift places ({@link followPipes}),
 * which preserve how place and velocity depend on each other, the angle of her box is followed, and aliens are included. The
 * sets would need much room, so the certificate carries hints instead: where sets are cut, which strips hazards take off, and
 * which parts are joined. The checker computes the sets by itself and tests each hint. It is tried last, and only if random
 * plays all end within 2.5 s. Rests on the lemmas `reach`, `pushes`, `recoil in steps`, `chasers`, `drift`,
 * `speed limit` and `mouths`.
 * @param fineness 0, or 1 for plays of up to 4 s and larger certificates
 */
export function proveFlowpipe(setting: Setting, about: About, goal: Thing, fineness = 0): Proof | null {
  const most = MOST[Math.min(fineness, FINEST_PIPES)];
  const { level, maxTime } = setting;
  if (!mayFlow(setting, fineness)) return null;
  const last = setting.longestPlay(LONGEST[Math.min(fineness, FINEST_PIPES)]);
  if (last === null) return null;
  for (const [share, more] of HORIZONS) {
    const horizon = share * last + more;
    const grid: PipeGrid = {
      axis: startAxis(setting),
      cell: CELL * Math.sqrt(Math.max(1, horizon)),
      frames: FRAMES,
      steps: Math.ceil(horizon / (FRAMES * TICK)),
      turns: TURNS,
    };
    const { closed, hopeless, layers, endedBy } = followPipes(setting, about, goal, grid, most);
    if (hopeless) return null;
    if (!closed) continue;
    const seconds = layers.length * grid.frames * TICK;
    return {
      code: 'flowpipe',
      about,
      reason: soonOverReason(about, seconds, endedBy),
      covers: CONTINUOUS,
      maxTime: level.recoil ? maxTime : null,
      certificate: { kind: 'flowpipe', grid, layers },
    };
  }
  return null;
}
