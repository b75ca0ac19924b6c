import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { INDEXING } from '../../engine/box-index.ts';
import { EffectSet } from '../../engine/effects/index.ts';
import { EFFECTS_IN_ORDER } from '../../engine/effects/order.ts';
import { compile, createSimulation, EFFECTS, STATE_SIZE, simulate, TICK, WorkBudget } from '../../engine/index.ts';
import { KINDS, type Level, LISTED_KINDS, listOf, OBJECT_LISTS, RULE_NAMES } from '../../schema/index.ts';
import { expectDeep } from '../depth.ts';
import { windyDegenerateScene, windyScene } from '../scenes/windy-scene.ts';
import { accuracyNames } from './accuracies.ts';
import { arbitraryLevel, arbitraryPlayableLevel } from './arbitrary-level.ts';
import { plainLevel } from './plain-level.ts';

// Provers and warnings rely on the declarations of effects, which must be true.

describe('the declaration of an effect', () => {
  it.each(EFFECTS)('$name: it kills if one of its events ends a run badly', ({ kills, events = [] }) => {
    expect(kills === true).toBe(events.some(({ ends }) => ends?.outcome === 'collided'));
  });

  it('each rule belongs to one effect, or to the collision box', () => {
    const rules = EFFECTS.flatMap(({ rules: own = [] }) => own);
    expect([...rules, 'boxWidth', 'boxHeight'].sort()).toEqual([...RULE_NAMES].sort());
  });

  it('event types have unique order numbers, from 1 on', () => {
    const kinds = EFFECTS.flatMap(({ events = [] }) => events.map(({ kind }) => kind));
    expect(kinds.sort((a, b) => a - b)).toEqual(kinds.map((_, i) => i + 1));
  });
});

// A property does not cover a kind of object that its levels never contain.
describe('random levels', () => {
  const many = (levels: fc.Arbitrary<Level>) => fc.sample(levels, 200);
  const additions = LISTED_KINDS.filter((kind) => KINDS[kind].original === null).map(listOf);

  it.each([
    ['arbitraryLevel', OBJECT_LISTS, many(arbitraryLevel)],
    ['arbitraryPlayableLevel', OBJECT_LISTS, many(arbitraryPlayableLevel)],
    ['windyScene', additions, Array.from({ length: 50 }, (_, seed) => windyScene(seed).level)],
    ['windyDegenerateScene', additions, Array.from({ length: 50 }, (_, seed) => windyDegenerateScene(seed).level)],
  ])('of %s have objects of every kind', (_, lists, levels) => {
    expect(lists.filter((list) => levels.every((level) => level[list].length === 0))).toEqual([]);
  });
});

describe.each(accuracyNames)('at %s', (accuracy) => {
  it('her acceleration never exceeds the bound of the scene', () => {
    let fastest = 0;
    fc.assert(
      fc.property(fc.nat(1_000_000), (seed) => {
        const { level, holds } = windyScene(seed);
        const scene = compile(level, accuracy);
        const { trajectory } = simulate(scene, holds, { maxTime: 4, budget: new WorkBudget(30_000) });
        const states = [new Float64Array(STATE_SIZE), new Float64Array(STATE_SIZE)];
        // a fixed step makes a little more of a force, and contacts of `arcade` end a run by stopping her
        const most = 1.06 * scene.strongest * TICK + 1e-6;
        for (let tick = 0; (tick + 1) * TICK < trajectory.duration - TICK; tick++) {
          trajectory.at(tick * TICK, states[0]);
          trajectory.at((tick + 1) * TICK, states[1]);
          const gain = Math.hypot(states[1][2] - states[0][2], states[1][3] - states[0][3]);
          fastest = Math.max(fastest, gain / (scene.strongest * TICK));
          expect(gain).toBeLessThan(most);
        }
      }),
      { numRuns: 40 },
    );
    // and the bound is not far too large
    expectDeep(fastest).toBeGreaterThan(0.7);
  });

  it('an effect is part of a simulation exactly if the level calls for it', () => {
    const numbers = (level: Level) => createSimulation(compile(level, accuracy)).snapshot().length;
    const plain = plainLevel();
    const wind = { id: null, x: 500, y: 0, radius: 20, ax: 1, ay: 0 };
    const wormhole = { id: null, x: 500, y: 0, toX: 700, toY: 0, radius: 20 };
    // in continuous time, winds have a counter as well
    const own = accuracy === 'arcade' ? 0 : 1;
    expect(numbers({ ...plain, winds: [wind, wind] }) - numbers(plain)).toBe(own + 2);
    expect(numbers({ ...plain, wormholes: [wormhole, wormhole] }) - numbers(plain)).toBe(2);
  });
});

it('the list of all effects has the order in which they act', () => {
  expect(EFFECTS.map(({ name }) => name)).toEqual(EFFECTS_IN_ORDER);
});

it('an effect or event without a place in the order is refused, since it would never act', () => {
  const more = { ...EFFECTS[0], name: 'drag' };
  expect(() => new EffectSet([more], INDEXING)).toThrow('expected a place for "drag" in engine/effects/order.ts, found none');
  const event = { ...(EFFECTS[0].events ?? [])[0], name: 'stall' };
  expect(() => new EffectSet([{ ...EFFECTS[0], events: [event] }], INDEXING)).toThrow('"stall"');
  expect(() => new EffectSet([...EFFECTS].reverse(), INDEXING)).not.toThrow();
});
