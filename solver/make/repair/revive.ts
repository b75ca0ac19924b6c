import type { Level } from '../../../schema/basics/index.ts';
import type { Steps } from '../../steps.ts';
import type { ObjectRef, Vector } from './change.ts';
import { dropOf, type Family, HOLE, moveFamily, movers, rangeFamily, resizeFamily, START, velocityFamily } from './family.ts';
import { fitChange, lengthOf, scaled } from './fit-change.ts';
import type { Task, Tried } from './task.ts';
import type { Attempt } from './trial-runs.ts';

/**
 * Seeks changes of the level with which a run completes it, the most likely ones first: of what the run hits, of the black
 * hole, and of whatever decides how she flies.
 */
export function* revive(task: Task, tried: Tried): Steps<void> {
  const { level } = task;
  const attempt = task.trials.play(level, tried.holds);
  const touched = touchedBy(attempt);
  if (touched !== null) yield* clear(task, touched, tried);
  yield* moveHole(task, tried, attempt);
  for (const family of familiesOfFlight(level)) yield* fitChange(task, family, tried);
}

/** Seeks changes of a hazard that let a run pass. */
export function* clear(task: Task, hazard: ObjectRef, tried: Tried): Steps<void> {
  const { level } = task;
  task.offer(dropOf(level, hazard), tried);
  yield null;
  yield* fitChange(task, resizeFamily(level, hazard), tried);
  yield* fitChange(task, moveFamily(level, hazard), tried);
}

/** Seeks changes of the black hole with which it lies on the way of a run. */
export function* moveHole(task: Task, tried: Tried, { nearest, miss }: Attempt): Steps<void> {
  const { level } = task;
  const length = lengthOf(nearest);
  const towards: Vector = length === 0 ? nearest : scaled(nearest, (Math.min(miss, length) + 1) / length);
  yield* fitChange(task, moveFamily(level, HOLE), tried, [towards]);
  yield* fitChange(task, resizeFamily(level, HOLE), tried, [{ x: miss + 1, y: 0 }]);
}

function familiesOfFlight(level: Level): Family[] {
  const objects = movers(level);
  return [
    rangeFamily(level),
    velocityFamily(level),
    moveFamily(level, START),
    ...objects.map((object) => moveFamily(level, object)),
    // The radius of an asteroid decides nothing but its recoil.
    ...objects.filter(({ kind }) => kind !== 'asteroid' || level.recoil).map((object) => resizeFamily(level, object)),
  ];
}

/** What ended a run before it was completed. */
export function touchedBy({ ending }: Attempt): ObjectRef | null {
  const touched = ending?.outcome === 'collided' ? ending.with : null;
  return touched === null || touched.kind === 'blackHole' ? null : { kind: touched.kind, index: touched.index };
}
