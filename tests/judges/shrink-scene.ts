import { type Level, OBJECT_LISTS, type RuleName } from '../../schema/index.ts';
import type { RandomScene } from '../scenes/random-scene.ts';

/**
 * Makes a scene smaller as long as it still fails: fewer objects, rules and holds, a shorter time, rounder numbers.
 * @param fails - whether a scene shows the same fault
 */
export function shrinkScene(scene: RandomScene, fails: (scene: RandomScene) => boolean): RandomScene {
  let smallest = scene;
  for (let again = true; again; ) {
    again = false;
    for (const smaller of smallerThan(smallest)) {
      if (!fails(smaller)) continue;
      smallest = smaller;
      again = true;
      break;
    }
  }
  return smallest;
}

/** Scenes that are smaller than a scene by one thing, those first that are smaller by much. */
function* smallerThan(scene: RandomScene): Generator<RandomScene> {
  const { level, holds, maxTime } = scene;
  const of = (changed: Partial<Level>): RandomScene => ({ ...scene, level: { ...level, ...changed } });
  for (const list of OBJECT_LISTS) {
    if (level[list].length > 1) yield of({ [list]: [] });
    for (const i of level[list].keys()) yield of({ [list]: level[list].filter((_, j) => j !== i) });
  }
  const rules = Object.keys(level.rules ?? {}) as RuleName[];
  for (const name of rules) {
    const left = rules.filter((other) => other !== name).map((other) => [other, level.rules?.[other]]);
    const { rules: _, ...bare } = level;
    yield { ...scene, level: left.length === 0 ? bare : { ...level, rules: Object.fromEntries(left) } };
  }
  if (level.recoil) yield of({ recoil: false });
  for (const time of [maxTime / 2, maxTime - 1, maxTime - 0.5]) {
    if (time >= 0.5) yield { ...scene, maxTime: Math.round(time * 60) / 60, holds: holds.filter(([press]) => press < time * 60) };
  }
  const last = Math.round(maxTime * 60);
  if (holds.length > 1 || (holds.length === 1 && (holds[0][0] > 0 || holds[0][1] !== last))) {
    yield { ...scene, holds: [[0, last]] };
  }
  if (holds.length > 0) yield { ...scene, holds: [] };
  for (let size = Math.floor(holds.length / 2); size >= 1; size = Math.floor(size / 2)) {
    for (let from = 0; from < holds.length; from += size) {
      yield { ...scene, holds: [...holds.slice(0, from), ...holds.slice(from + size)] };
    }
  }
  yield* rounder(scene);
}

/** The scene about the origin, and scenes with one number rounded. */
function* rounder(scene: RandomScene): Generator<RandomScene> {
  const { level } = scene;
  const { x, y } = level.astronaut;
  if (x !== 0 || y !== 0) yield { ...scene, level: moved(level, -x, -y) };
  const round = function* (object: object, put: (object: object) => Partial<Level>): Generator<RandomScene> {
    for (const [key, number] of Object.entries(object)) {
      if (typeof number !== 'number') continue;
      for (const digits of [1, 2, 3, 5, 8]) {
        const rounded: number = Number(number.toPrecision(digits));
        if (rounded === number) break;
        yield { ...scene, level: { ...level, ...put({ ...object, [key]: rounded }) } };
      }
    }
  };
  yield* round(level.astronaut, (astronaut) => ({ astronaut: astronaut as Level['astronaut'] }));
  yield* round(level.blackHole, (blackHole) => ({ blackHole: blackHole as Level['blackHole'] }));
  yield* round({ range: level.range }, (range) => range);
  if (level.rules !== undefined) yield* round(level.rules, (rules) => ({ rules }));
  for (const list of OBJECT_LISTS) {
    for (const [i, object] of level[list].entries()) {
      yield* round(object, (rounded) => ({ [list]: level[list].map((other, j) => (j === i ? rounded : other)) }));
    }
  }
}

/** A level, moved as a whole. */
function moved(level: Level, dx: number, dy: number): Level {
  const move = <T extends { x: number; y: number }>(object: T): T => ({ ...object, x: object.x + dx, y: object.y + dy });
  const lists = Object.fromEntries(OBJECT_LISTS.map((list) => [list, level[list].map(move)]));
  const wormholes = level.wormholes.map((w) => ({ ...move(w), toX: w.toX + dx, toY: w.toY + dy }));
  return { ...level, ...lists, wormholes, astronaut: move(level.astronaut), blackHole: move(level.blackHole) };
}
