import { type Motion, SLOTS } from '../../motion/index.ts';

const { TARGET } = SLOTS;

/** Tells the recorder which asteroid the gun holds from now on. */
export function recordTarget(m: Motion, time: number): void {
  m.recorder?.event({ time, type: 'target', index: m.scene.targets.index[m.s[TARGET]] });
}
