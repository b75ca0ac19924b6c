import type { Circle, Level } from '../schema/basics/index.ts';
import { rulesOf } from '../schema/basics/index.ts';
import type { Accuracy } from './accuracy.ts';
import { boxOf } from './contact/index.ts';
import { type EffectSet, explosionsAtStart, strongestOf } from './effects/index.ts';
import { circlesOf, indexed } from './indexed-circles.ts';
import type { Scene } from './scene.ts';

/** The places in a list of all circles, without those that equal an earlier one. */
function unlike(list: readonly Circle[]): number[] {
  const seen = new Set<string>();
  const kept: number[] = [];
  for (const [i, { x, y, radius }] of list.entries()) {
    const circle = `${x} ${y} ${radius}`;
    if (!seen.has(circle)) kept.push(i);
    seen.add(circle);
  }
  return kept;
}

/** Prepares a level for simulation with the effects that a program includes; see {@link compile}. */
export function compileWith(included: EffectSet, level: Level, accuracy: Accuracy): Scene {
  const { indexing } = included;
  const rules = rulesOf(level);
  const effects = included.choose(level);
  const parts = included.of(effects);
  const all = (list: readonly Circle[]) => circlesOf(list, [...list.keys()]);
  const cold: number[] = [];
  const hot: number[] = [];
  for (const [i, a] of level.asteroids.entries()) (a.hot ? hot : cold).push(i);
  const aliens = indexed(all(level.aliens), indexing);
  // continuous time has places relative to where she starts
  const origin = accuracy.integrator === 'arcade' ? { x: 0, y: 0 } : level.astronaut;
  const explosions = explosionsAtStart(aliens, origin.x, origin.y);
  return {
    level,
    rules,
    box: boxOf(rules),
    accuracy,
    effects,
    strongest: strongestOf(parts, level, rules),
    targets: indexed(circlesOf(level.asteroids, [...cold, ...hot]), indexing),
    coldCount: cold.length,
    novae: indexed(all(level.novae), indexing),
    repulsors: indexed(circlesOf(level.repulsors, unlike(level.repulsors)), indexing),
    aliens: { ...aliens, explosions },
    minerals: indexed(all(level.minerals), indexing),
    own: Object.fromEntries(
      parts.flatMap(({ name, prepare }) => (prepare === undefined ? [] : [[name, prepare(level, indexing)]])),
    ),
  };
}
