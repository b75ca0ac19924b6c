import { compile, type Scene } from '../../engine/index.ts';
import { resolveLevel } from '../../schema/index.ts';
import { createGenerator, createSearch, type Goal, type WantedDifficulty } from '../../solver/index.ts';
import { RANDOM_SET_SIZE, randomLevel } from '../../tests/scenes/random-set/index.ts';
import type { NamedLevel } from '../harness/index.ts';

export const ANY: Goal = { minerals: 'any' };

/** A level to measure. Minerals are left out: the goal does not ask for them, and a search for all of them would take time. */
export interface MeasuredScene {
  readonly name: string;
  readonly kind: 'pack' | 'random' | 'generated';
  readonly scene: Scene;
}

/** Ticks in which a random level must be completed by a plain search to be taken. */
const FIRST_RUN = 200_000;

/** Ticks for a layout of a generated level. */
const GENERATION = 40_000_000;

/** Some levels, then random levels that can be completed, then generated ones. */
export function scenesToMeasure(asked: readonly NamedLevel[], random: number, generated: number): MeasuredScene[] {
  const sceneOf = (level: Parameters<typeof compile>[0]): Scene => compile({ ...level, minerals: [] });
  const scenes: MeasuredScene[] = asked.map(({ name, level }) => ({ name, kind: 'pack', scene: sceneOf(level) }));
  let taken = 0;
  for (let seed = 0; seed < RANDOM_SET_SIZE && taken < random; seed++) {
    const scene = sceneOf(resolveLevel(randomLevel(seed)));
    const search = createSearch(scene, { goal: ANY });
    search.advance(FIRST_RUN);
    if (search.solutions.length === 0) continue;
    scenes.push({ name: `random ${seed}`, kind: 'random', scene });
    taken++;
  }
  const wanted: readonly WantedDifficulty[] = ['easy', 'medium', 'hard'];
  for (let i = 0; i < generated; i++) {
    const generator = createGenerator({ seed: 1000 + i, difficulty: wanted[i % wanted.length], size: 'small' });
    generator.advance(GENERATION);
    if (generator.result !== null) {
      scenes.push({ name: `generated ${1000 + i}`, kind: 'generated', scene: sceneOf(resolveLevel(generator.result.level)) });
    }
  }
  return scenes;
}
