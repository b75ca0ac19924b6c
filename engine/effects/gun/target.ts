import { type Motion, nearest, SLOTS } from '../../motion/index.ts';

const { HELD, TARGET, COVER } = SLOTS;

/** Reports to the recorder which asteroid is the target from now on. */
export function recordTarget(m: Motion, time: number): void {
  m.recorder?.event({ time, type: 'target', index: m.scene.targets.index[m.s[TARGET]] });
}

/** Chooses the target anew after she was moved: another asteroid may be the nearest. */
export function holdNearest(m: Motion, time: number): void {
  const { s } = m;
  if (s[HELD] === 0) return;
  const before = s[TARGET];
  s[TARGET] = nearest(m);
  s[COVER] = s[TARGET];
  if (s[TARGET] !== before) recordTarget(m, time);
}
