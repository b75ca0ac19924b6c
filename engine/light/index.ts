import type { Level } from '../../schema/basics/index.ts';
import { compileWith } from '../compile.ts';
import { ContinuousSimulation, EventRecorder, type Method } from '../continuous/index.ts';
import { BASE, EffectSet, type GamePart, LISTS_OF_BASE } from '../effects/index.ts';
import { INDEX_FROM, type Indexing } from '../indexed-circles.ts';
import { taylorOf } from '../integrators/index.ts';
import { objectLists, type Scene } from '../scene.ts';
import type { RunEvent, Simulation } from '../simulation.ts';
import { DEFAULT_TERMS } from '../terms.ts';
import { unlimited } from '../work-budget.ts';

// The engine in parts, for games that are small. `engine/index.ts` has all of it.
export { aliens, type GamePart, manyObjects, recoil, repulsors, winds, wormholes } from '../effects/index.ts';

/** An engine that plays levels with some parts of the game, at the default accuracy. */
interface LightEngine {
  /**
   * Prepares a level.
   *
   * @param level - a valid level
   * @returns the scene
   * @throws {RangeError} when the level calls for a part of the game that is not included
   */
  compile(level: Level): Scene;
  /**
   * Creates a simulation at the start of a scene.
   *
   * @param scene - a scene that this engine compiled
   * @param events - receives what happens; null if nobody listens
   * @returns the simulation
   */
  createSimulation(scene: Scene, events: RunEvent[] | null): Simulation;
}

const without = (name: string, what: string): RangeError =>
  new RangeError(`expected a level without ${what}, since the part "${name}" is not included; found one. Include ${name}.`);

/** Where there are never many objects, nothing is worth an index. */
const NO_INDEX: Indexing = {
  circles({ count }) {
    if (count >= INDEX_FROM) throw without('manyObjects', `${INDEX_FROM} objects of a kind or more`);
    return null;
  },
  boxes: (boxes) => (k) => {
    const found: number[] = [];
    for (let i = k + 1; 4 * i < boxes.length; i++) {
      const isApartX = boxes[4 * i] > boxes[4 * k + 2] || boxes[4 * i + 2] < boxes[4 * k];
      const isApartY = boxes[4 * i + 1] > boxes[4 * k + 3] || boxes[4 * i + 3] < boxes[4 * k + 1];
      if (!isApartX && !isApartY) found.push(i);
    }
    return found;
  },
};

/**
 * Composes an engine of the parts of the game that levels call for. What is not named does not get into a bundle. It gives the
 * same results as the whole engine, bit for bit.
 *
 * @param parts - the parts, in any order
 * @returns the engine
 */
export function composeEngine(parts: readonly GamePart[]): LightEngine {
  const effects = new EffectSet(
    [...BASE, ...parts.flatMap((part) => part.effects)],
    parts.find(({ indexing }) => indexing !== undefined)?.indexing ?? NO_INDEX,
  );
  const method: Method = { effects, integratorOf: taylorOf };
  const included: readonly string[] = [...LISTS_OF_BASE, ...parts.flatMap((part) => part.lists)];
  const hasRecoil = parts.some(({ name }) => name === 'recoil');
  return {
    compile(level) {
      for (const [name, objects] of objectLists(level)) {
        if (objects.length > 0 && !included.includes(name)) throw without(name, name);
      }
      if (level.recoil && !hasRecoil) throw without('recoil', 'recoil');
      return compileWith(effects, level, DEFAULT_TERMS);
    },
    createSimulation: (scene, events) =>
      new ContinuousSimulation(method, scene, events === null ? null : new EventRecorder(events), unlimited()),
  };
}
