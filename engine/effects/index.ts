import { INDEXING } from '../box-index.ts';
import type { RunEvent } from '../simulation.ts';
import { alienChase, alienExplosion } from './aliens/index.ts';
import { blackHole } from './black-hole/index.ts';
import type { Effect } from './effect.ts';
import { EffectSet } from './effect-set.ts';
import { gun, recoil } from './gun/index.ts';
import { hotAsteroids, novae } from './hazards/index.ts';
import { minerals } from './minerals/index.ts';
import { range } from './range/index.ts';
import { repulsor } from './repulsor/index.ts';
import { speedLimit } from './speed-limit/index.ts';
import { winds } from './winds/index.ts';
import { wormholes } from './wormholes/index.ts';

export { explosionsAtStart } from './aliens/index.ts';
export type { Effect } from './effect.ts';
export { EffectSet, strongestOf } from './effect-set.ts';
export { recordTarget } from './gun/index.ts';
export * from './parts.ts';

/** Every effect of the game, in the order in which `gq inspect` lists them. */
export const EFFECTS: readonly Effect[] = [
  gun,
  recoil,
  repulsor,
  winds,
  wormholes,
  alienChase,
  alienExplosion,
  speedLimit,
  novae,
  hotAsteroids,
  minerals,
  blackHole,
  range,
];

/** All effects, for scenes with any of them. */
export const ALL_EFFECTS: EffectSet = /* @__PURE__ */ new EffectSet(EFFECTS, INDEXING);

/**
 * Puts an effect's own event into words.
 *
 * @param event - an event of type `effect`
 * @returns a sentence without its subject, which is the astronaut: `goes through wormhole 1`
 */
export function effectEventInWords({ effect, what, index }: Extract<RunEvent, { type: 'effect' }>): string {
  const tell = EFFECTS.find(({ name }) => name === effect)?.tells?.[what];
  return tell === undefined ? `${effect} ${index + 1}: ${what}` : tell(index);
}
