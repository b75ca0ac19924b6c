import type { Circle, Level } from '../schema/index.ts';
import { ACCURACIES, type Accuracy, type AccuracyName, DEFAULT_ACCURACY } from './accuracy.ts';
import { chooseEffects, type EffectChoice } from './effects/index.ts';
import { explosionsAtStart } from './explosions-at-start.ts';
import { indexCircles, type SpatialIndex } from './spatial-index.ts';

/** Circles as parallel arrays, px. `index` is the place in the level's own list of that kind. */
export interface Circles {
  readonly count: number;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly r: Float64Array;
  readonly index: Int32Array;
}

/** A list of circles as the level has them, with an index where there are many. */
export interface IndexedCircles extends Circles {
  readonly spatial: SpatialIndex | null;
}

/** The aliens as the level has them. */
export interface Aliens extends IndexedCircles {
  /** Pairs that overlap there, two indices each, in the order in which they explode. */
  readonly explosions: Int32Array;
}

/** A level made ready to simulate at one accuracy. Never written to after `compile`; share it freely. */
export interface Scene {
  readonly level: Level;
  readonly accuracy: Accuracy;
  /** What the level calls for and what it doesn't, with the reason. */
  readonly effects: EffectChoice;
  /** Everything the gun can target: cold asteroids in level order, then hot ones (the order in which ties are broken). */
  readonly targets: IndexedCircles;
  /** The first so many of `targets` are cold. */
  readonly coldCount: number;
  readonly novae: IndexedCircles;
  readonly repulsors: IndexedCircles;
  readonly aliens: Aliens;
  readonly minerals: IndexedCircles;
}

function indexed(circles: Circles): IndexedCircles {
  const { count, x, y, r, index } = circles;
  // one by one: `...` would give every list a shape of its own, which V8 then has to search
  return { count, x, y, r, index, spatial: indexCircles(circles) };
}

function circles(list: readonly Circle[], order: readonly number[]): Circles {
  const pick = (f: (c: Circle) => number) => Float64Array.from(order, (i) => f(list[i]));
  return {
    count: order.length,
    x: pick((c) => c.x),
    y: pick((c) => c.y),
    r: pick((c) => c.radius),
    index: Int32Array.from(order),
  };
}

/**
 * Makes a valid level ready to simulate: chooses the effects it calls for and lays its objects out in typed arrays.
 * @param level a level from `schema`; the engine trusts its numbers to be finite and its radii positive
 * @param accuracy a name, or a full setting of one's own
 */
export function compile(level: Level, accuracy: AccuracyName | Accuracy = DEFAULT_ACCURACY): Scene {
  const all = (list: readonly Circle[]) => circles(list, [...list.keys()]);
  const cold: number[] = [];
  const hot: number[] = [];
  for (const [i, a] of level.asteroids.entries()) (a.hot ? hot : cold).push(i);
  const aliens = indexed(all(level.aliens));
  const chosen = typeof accuracy === 'string' ? ACCURACIES[accuracy] : accuracy;
  // continuous time has places relative to where she starts
  const origin = chosen.integrator === 'arcade' ? { x: 0, y: 0 } : level.astronaut;
  const explosions = explosionsAtStart(aliens, origin.x, origin.y);
  return {
    level,
    accuracy: chosen,
    effects: chooseEffects(level),
    targets: indexed(circles(level.asteroids, [...cold, ...hot])),
    coldCount: cold.length,
    novae: indexed(all(level.novae)),
    repulsors: indexed(all(level.repulsors)),
    aliens: { ...aliens, explosions },
    minerals: indexed(all(level.minerals)),
  };
}
