import type { Level } from '../../schema/index.ts';
import { layOutRules, putInOrder } from '../events/index.ts';
import type { EventRule, EventRules } from '../motion/index.ts';
import type { ChosenEffect, EffectChoice } from '../scene.ts';
import { alienChase, alienExplosion, explode, fallAsleep, touchAlien, wake } from './aliens/index.ts';
import { blackHole, touchBlackHole } from './black-hole/index.ts';
import type { Effect } from './effect.ts';
import { gun, meetTarget, passCentre, switchTarget } from './gun/index.ts';
import { hotAsteroids, novae, touchHot, touchNova } from './hazards/index.ts';
import { collect, minerals } from './minerals/index.ts';
import { leaveRange, range } from './range/index.ts';
import { recoil } from './recoil/index.ts';
import { comeOffRim, enterField, leaveField, repulsor } from './repulsor/index.ts';
import { freeAxis, holdAxis, speedLimit } from './speed-limit/index.ts';

export { explosionsAtStart } from './aliens/index.ts';
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

/** Every kind of event, in the order in which they happen when they fall on the same instant. */
const EVENTS_IN_ORDER: readonly EventRule[] = [
  collect,
  touchNova,
  touchHot,
  touchAlien,
  touchBlackHole,
  leaveRange,
  passCentre,
  meetTarget,
  switchTarget,
  enterField,
  leaveField,
  wake,
  fallAsleep,
  explode,
  holdAxis,
  freeAxis,
  comeOffRim,
];
putInOrder(EVENTS_IN_ORDER);

/** With these the neighbour list begins: the last digit of a tie between two of them can depend on which is looked at first. */
const LISTED_FIRST: readonly EventRule[] = [touchNova, collect, enterField, touchBlackHole, touchAlien, touchHot, switchTarget];

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

/** The effects that are part of a scene. */
export function effectsOf({ simulated }: EffectChoice): readonly Effect[] {
  const names = new Set(simulated.map(({ name }) => name));
  return EFFECTS.filter(({ name }) => names.has(name));
}

/** The kinds of events that these effects bring with them, laid out for a motion. */
export function eventsOf(effects: readonly Effect[]): EventRules {
  return layOutRules(
    EVENTS_IN_ORDER,
    LISTED_FIRST,
    effects.flatMap(({ events }) => events ?? []),
  );
}

/** The most that all these forces together can accelerate her, px/s2. */
export function strongestOf(effects: readonly Effect[], level: Level): number {
  let instead = 0;
  let beside = 0;
  for (const { force } of effects) {
    if (force === undefined) continue;
    if (force.acts === 'instead') instead = Math.max(instead, force.strongest(level));
    else beside += force.strongest(level);
  }
  return instead + beside;
}
