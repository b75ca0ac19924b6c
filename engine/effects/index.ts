import type { Level } from '../../schema/index.ts';
import { alienChase } from './alien-chase.ts';
import { alienExplosion } from './alien-explosion.ts';
import { blackHole, range, speedLimit } from './always.ts';
import type { Effect } from './effect.ts';
import { gun } from './gun.ts';
import { hotAsteroids } from './hot-asteroids.ts';
import { minerals } from './minerals.ts';
import { novae } from './novae.ts';
import { recoil } from './recoil.ts';
import { repulsor } from './repulsor.ts';

export type { Effect } from './effect.ts';

/** Every effect of the game, in the order in which `gq inspect` lists them. */
export const EFFECTS: readonly Effect[] = [
  gun,
  recoil,
  repulsor,
  alienChase,
  alienExplosion,
  speedLimit,
  novae,
  hotAsteroids,
  minerals,
  blackHole,
  range,
];

export interface ChosenEffect {
  readonly name: string;
  readonly because: string;
}

export interface EffectChoice {
  readonly simulated: readonly ChosenEffect[];
  readonly notCalledFor: readonly ChosenEffect[];
}

/** Which effects a level calls for. */
export function chooseEffects(level: Level): EffectChoice {
  const simulated: ChosenEffect[] = [];
  const notCalledFor: ChosenEffect[] = [];
  for (const effect of EFFECTS) {
    const { called, because } = effect.calledFor(level);
    (called ? simulated : notCalledFor).push({ name: effect.name, because });
  }
  return { simulated, notCalledFor };
}
