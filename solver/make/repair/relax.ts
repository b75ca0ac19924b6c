import { type Hold, isVariant, type Level } from '../../../schema/basics/index.ts';
import type { Steps } from '../../steps.ts';
import { applyChange, type Change, type ObjectRef, objectAt, type Vector } from './change.ts';
import {
  dropOf,
  type Family,
  groupOf,
  HOLE,
  hasRadius,
  hazards,
  isSame,
  moveFamily,
  movers,
  rangeFamily,
  resizeFamily,
  START,
  velocityFamily,
} from './family.ts';
import { clear, directionsOf, lengthOf, scaled, shrink } from './revive.ts';
import type { Task, Tried } from './task.ts';

/** Ticks of the search after each change, in the rounds. */
const ROUNDS = [20_000, 60_000, 180_000];

/** How far things are moved, px. */
const FAR = [48, 144];
/** By how much her velocity is changed, px/s. */
const FASTER = [30, 90];
/** Factors of the range. */
const WIDER = [1.2, 1.6, 2.5];

/** A large change that may make the level completable, and how to make it smaller. */
interface Relaxation {
  readonly change: Change;
  /** null: the object is removed. */
  readonly along: { readonly family: Family; readonly by: Vector } | null;
}

/**
 * Seeks changes after which a search finds a run: large ones first, in rounds of longer searches, until there are as many
 * proposals as wanted. What works is made smaller, with a search wherever the run that was found does not do.
 * @param suspects the objects to begin with
 */
export function* relax(task: Task, suspects: readonly ObjectRef[]): Steps<void> {
  const relaxations = relaxationsOf(task.level, suspects);
  const done = new Set<Relaxation>();
  for (const ticks of ROUNDS) {
    for (const relaxation of relaxations) {
      const { change, along } = relaxation;
      // A removal leads to smaller changes of the same object.
      if (done.has(relaxation) || (along !== null && lengthOf(along.by) >= task.boundOf(groupOf(change)))) continue;
      const { found } = yield* task.trials.search(applyChange(task.level, change), task.nextSeed(), ticks);
      if (found === null) continue;
      done.add(relaxation);
      const tried: Tried = { holds: found, origin: { from: 'search' } };
      if (along === null) {
        if (change.what === 'drop') yield* clear(task, change.object, tried);
      } else {
        task.offer(change, tried);
        yield* shrinkBySearch(task, along.family, along.by, found, ticks);
      }
    }
    if (task.isFull) return;
  }
}

/** Halves a change as long as a search finds a run. */
function* shrinkBySearch(task: Task, family: Family, by: Vector, holds: readonly Hold[], ticks: number): Steps<void> {
  const length = lengthOf(by);
  let run = holds;
  let low = 0;
  let high = 1;
  while ((high - low) * length > 2) {
    const middle = (low + high) / 2;
    const change = family.make(scaled(by, middle));
    if (change === null) break;
    const level = applyChange(task.level, change);
    const isSameRun = task.trials.play(level, run).completed;
    const found: readonly Hold[] | null = isSameRun ? run : (yield* task.trials.search(level, task.nextSeed(), ticks)).found;
    if (found === null) low = middle;
    else {
      high = middle;
      run = found;
    }
    yield null;
  }
  yield* shrink(task, family, scaled(by, high), { holds: run, origin: { from: 'search' } });
}

function relaxationsOf(level: Level, suspects: readonly ObjectRef[]): Relaxation[] {
  const others = [...movers(level), ...hazards(level)].filter((object) => !suspects.some((other) => isSame(object, other)));
  return [
    ...suspects.filter(isListed).flatMap((object) => removal(level, object)),
    ...along(
      rangeFamily(level),
      WIDER.map((factor) => ({ x: level.range * (factor - 1), y: 0 })),
    ),
    ...suspects.flatMap((object) => moves(level, object)),
    ...towards(level, START, HOLE),
    ...moves(level, START),
    ...around(velocityFamily(level), FASTER),
    ...towards(level, HOLE, START),
    ...moves(level, HOLE),
    ...along(
      resizeFamily(level, HOLE),
      FAR.map((x) => ({ x, y: 0 })),
    ),
    ...others
      .filter(({ kind }) => kind === 'asteroid')
      .flatMap((object) => [...towards(level, object, HOLE), ...towards(level, object, START), ...moves(level, object)]),
    ...others.flatMap((object) => removal(level, object)),
  ];
}

const isListed = ({ kind }: ObjectRef): boolean => kind !== 'astronaut' && kind !== 'blackHole';

/** What pulls her is never removed. */
const removal = (level: Level, object: ObjectRef): Relaxation[] =>
  object.kind === 'asteroid' && !isVariant(object.kind, objectAt(level, object))
    ? []
    : [{ change: dropOf(level, object), along: null }];

const moves = (level: Level, object: ObjectRef): Relaxation[] => [
  ...around(moveFamily(level, object), FAR),
  ...(hasRadius(level, object) && isListed(object)
    ? along(resizeFamily(level, object), [{ x: -objectAt(level, object).radius / 2, y: 0 }])
    : []),
];

const around = (family: Family, sizes: readonly number[]): Relaxation[] =>
  along(
    family,
    sizes.flatMap((size) => directionsOf(family).map((direction) => scaled(direction, size))),
  );

function towards(level: Level, object: ObjectRef, goal: ObjectRef): Relaxation[] {
  const from = objectAt(level, object);
  const to = objectAt(level, goal);
  return along(moveFamily(level, object), [{ x: (to.x - from.x) / 2, y: (to.y - from.y) / 2 }]);
}

const along = (family: Family, vectors: readonly Vector[]): Relaxation[] =>
  vectors.flatMap((by) => {
    const change = family.make(by);
    return change === null ? [] : [{ change, along: { family, by } }];
  });
