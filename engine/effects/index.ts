import type { Level, Rules } from '../../schema/index.ts';
import { layOutRules, putInOrder } from '../events/index.ts';
import type { EventRule, Parts } from '../motion/index.ts';
import type { ChosenEffect, EffectChoice } from '../scene.ts';
import type { RunEvent } from '../simulation.ts';
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
import { enterWind, leaveWind, winds } from './winds/index.ts';
import { enterMouth, leaveMouth, wormholes } from './wormholes/index.ts';

export { explosionsAtStart } from './aliens/index.ts';
export type { Effect } from './effect.ts';
export { recordTarget } from './gun/index.ts';

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

/** Every kind of event, in the order in which events at the same instant are handled. */
const EVENTS_IN_ORDER: readonly EventRule[] = [
  collect,
  touchNova,
  touchHot,
  touchAlien,
  touchBlackHole,
  leaveRange,
  enterMouth,
  leaveMouth,
  passCentre,
  meetTarget,
  switchTarget,
  enterField,
  leaveField,
  enterWind,
  leaveWind,
  wake,
  fallAsleep,
  explode,
  holdAxis,
  freeAxis,
  comeOffRim,
];
putInOrder(EVENTS_IN_ORDER);

/**
 * The neighbour list begins with these. The order matters: the last digit of a tie between two of them can depend on which is
 * examined first.
 */
const LISTED_FIRST: readonly EventRule[] = [touchNova, collect, enterField, touchBlackHole, touchAlien, touchHot, switchTarget];

/** The effects that accelerate her. Of the central forces only the first that is active acts. */
const FORCES_IN_ORDER: readonly Effect[] = [repulsor, gun, winds];

/** Chooses the effects that a level calls for. */
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

const layouts = new Map<string, Parts>();

/** What these effects contribute to a motion, laid out. Motions with the same effects share it. */
export function partsOf(effects: readonly Effect[]): Parts {
  const key = effects.map(({ name }) => name).join(' ');
  const known = layouts.get(key);
  if (known !== undefined) return known;
  const parts = layOut(effects);
  layouts.set(key, parts);
  return parts;
}

function layOut(effects: readonly Effect[]): Parts {
  const hooks = <K extends 'moved' | 'beforePiece' | 'turn' | 'setRim' | 'repeat' | 'mayRepeat'>(name: K) =>
    effects.flatMap((effect) => {
      const hook = effect[name];
      return hook === undefined ? [] : [hook];
    });
  const forces = FORCES_IN_ORDER.filter((effect) => effects.includes(effect)).flatMap(({ force }) => force ?? []);
  return {
    ...layOutRules(
      EVENTS_IN_ORDER,
      LISTED_FIRST,
      effects.flatMap(({ events }) => events ?? []),
    ),
    central: forces.filter((force) => force.acts === 'instead'),
    steady: forces.filter((force) => force.acts === 'beside'),
    own: effects.flatMap(({ name, stateLength }) => (stateLength === undefined ? [] : [{ name, length: stateLength }])),
    moved: hooks('moved'),
    beforePiece: hooks('beforePiece'),
    turn: hooks('turn'),
    setRim: hooks('setRim'),
    repeat: hooks('repeat'),
    mayRepeat: hooks('mayRepeat'),
  };
}

/**
 * Upper bound of her acceleration by all forces together, px/s². Only the strongest of the central forces counts, since one
 * acts at a time; steady forces add up.
 */
export function strongestOf(effects: readonly Effect[], level: Level, rules: Rules): number {
  let instead = 0;
  let beside = 0;
  for (const { force } of effects) {
    if (force === undefined) continue;
    const strongest = force.strongest(level, rules);
    if (force.acts === 'instead') instead = Math.max(instead, strongest);
    else beside += strongest;
  }
  return instead + beside;
}

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
