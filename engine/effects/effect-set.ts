import type { Level, Rules } from '../../schema/basics/index.ts';
import type { HazardList } from '../clearance.ts';
import { layOutRules } from '../events/index.ts';
import type { FrameRule } from '../frames.ts';
import { type IndexedCircles, type Indexing, NO_CIRCLES } from '../indexed-circles.ts';
import type { Chase, EventRule, Parts } from '../motion/index.ts';
import type { ChosenEffect, EffectChoice, Scene } from '../scene.ts';
import type { Effect, EngineEffect } from './effect.ts';
import { EFFECTS_IN_ORDER, EVENTS_IN_ORDER, FORCES_IN_ORDER, HAZARDS_IN_ORDER, LISTED_FIRST } from './order.ts';

/** Chosen effects, and what follows from them once somebody has asked for it. */
interface Chosen {
  readonly effects: readonly EngineEffect[];
  parts: Parts | null;
  frameRules: readonly FrameRule[] | null;
}

/** The effects that a program includes: all of them, or what its levels call for. */
export class EffectSet {
  private readonly all: readonly EngineEffect[];
  /** Those whose objects end the run by touch. */
  private readonly deadly: readonly EngineEffect[];
  private readonly rules: readonly EventRule[];
  // found again by the choice itself: a level is simulated more than once, at more than one accuracy
  private readonly chosen = new WeakMap<EffectChoice, Chosen>();
  private readonly known = new Map<string, Chosen>();

  /**
   * @param effects - the effects, in any order
   * @param indexing - finds objects where there are many
   * @throws Error when an effect, or one of its events, has no place in the order: it would never act
   */
  constructor(
    effects: readonly Effect[],
    readonly indexing: Indexing,
  ) {
    const rules = effects.flatMap(({ events }) => events ?? []);
    this.all = byName(effects, EFFECTS_IN_ORDER);
    this.deadly = byName(this.all, HAZARDS_IN_ORDER);
    this.rules = byName(rules, EVENTS_IN_ORDER);
    const missing = [...effects, ...rules].find((one) => ![...this.all, ...this.rules].includes(one as never));
    if (missing !== undefined) throw new Error(`expected a place for "${missing.name}" in engine/effects/order.ts, found none`);
    for (const rule of this.rules) rule.kind = EVENTS_IN_ORDER.indexOf(rule.name) + 1;
  }

  /** Chooses the effects that a level calls for. */
  choose(level: Level): EffectChoice {
    const simulated: ChosenEffect[] = [];
    const notCalledFor: ChosenEffect[] = [];
    for (const effect of this.all) {
      const { called, because } = effect.calledFor(level);
      (called ? simulated : notCalledFor).push({ name: effect.name, because });
    }
    return { simulated, notCalledFor };
  }

  /** The effects that are part of a scene. */
  of(choice: EffectChoice): readonly EngineEffect[] {
    return this.chosenBy(choice).effects;
  }

  /** What these effects contribute to a motion, laid out. Motions with the same effects share it. */
  partsOf(choice: EffectChoice): Parts {
    const chosen = this.chosenBy(choice);
    chosen.parts ??= this.layOut(chosen.effects);
    return chosen.parts;
  }

  /** What `arcade` calls in its frames for these effects. */
  frameRulesOf(choice: EffectChoice): readonly FrameRule[] {
    const chosen = this.chosenBy(choice);
    chosen.frameRules ??= chosen.effects.flatMap(({ frame }) => frame ?? []);
    return chosen.frameRules;
  }

  /** Whether the objects of a kind chase her. */
  hasChaser(kind: string): boolean {
    return this.all.some(({ chase }) => chase?.kind === kind);
  }

  /** What chases her in a scene with these effects; null if nothing does. */
  chaseOf(choice: EffectChoice): Chase | null {
    return chaseOf(this.chosenBy(choice).effects);
  }

  /** The objects of a scene that end the run by touch, a list for each effect that has any; the list of one that is not called for is empty. */
  hazardsOf(scene: Scene): readonly HazardList[] {
    const lists: HazardList[] = [];
    for (let k = 0; k < this.deadly.length; k++) {
      const list = this.deadly[k].hazard?.(scene);
      if (list !== undefined) lists.push(list);
    }
    return lists;
  }

  /** The objects of a scene that she collects by touch. */
  collectedOf(scene: Scene): IndexedCircles {
    return this.all.find(({ collects }) => collects !== undefined)?.collects?.(scene) ?? NO_CIRCLES;
  }

  private chosenBy(choice: EffectChoice): Chosen {
    let chosen = this.chosen.get(choice);
    if (chosen === undefined) {
      let key = '';
      for (const { name } of choice.simulated) key += `${name} `;
      chosen = this.known.get(key);
      if (chosen === undefined) {
        const names = new Set(choice.simulated.map(({ name }) => name));
        chosen = { effects: this.all.filter(({ name }) => names.has(name)), parts: null, frameRules: null };
        this.known.set(key, chosen);
      }
      this.chosen.set(choice, chosen);
    }
    return chosen;
  }

  private layOut(effects: readonly EngineEffect[]): Parts {
    const hooks = <K extends 'moved' | 'beforePiece' | 'turn' | 'repeat' | 'mayRepeat'>(name: K) =>
      effects.flatMap((effect) => {
        const hook = effect[name];
        return hook === undefined ? [] : [hook];
      });
    const forces = byName(effects, FORCES_IN_ORDER).flatMap(({ force }) => force ?? []);
    return {
      ...layOutRules(
        this.rules,
        byName(this.rules, LISTED_FIRST),
        effects.flatMap(({ events }) => events ?? []),
      ),
      chase: chaseOf(effects),
      sliding: effects.find(({ sliding }) => sliding !== undefined)?.sliding ?? null,
      following: effects.flatMap(({ following }) => following ?? []).at(-1) ?? null,
      central: forces.filter((force) => force.acts === 'instead'),
      steady: forces.filter((force) => force.acts === 'beside'),
      circles: effects.flatMap(({ circles }) => circles ?? []),
      // of all effects, so that every motion has them in one shape, which V8 reads fast
      own: this.all.flatMap((effect) => {
        const { name, stateLength } = effect;
        return stateLength === undefined ? [] : [{ name, length: effects.includes(effect) ? stateLength : () => 0 }];
      }),
      indexing: this.indexing,
      moved: hooks('moved'),
      beforePiece: hooks('beforePiece'),
      turn: hooks('turn'),
      repeat: hooks('repeat'),
      mayRepeat: hooks('mayRepeat'),
    };
  }
}

const chaseOf = (effects: readonly EngineEffect[]): Chase | null =>
  effects.find(({ chase }) => chase !== undefined)?.chase ?? null;

/** Those of a list that an order names, in that order. */
const byName = <T extends { readonly name: string }>(list: readonly T[], order: readonly string[]): readonly T[] =>
  order.flatMap((name) => list.find((one) => one.name === name) ?? []);

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
