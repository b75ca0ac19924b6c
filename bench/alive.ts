import { compile, type Scene } from '../engine/index.ts';
import { KINDS, type Level, LISTED_KINDS } from '../schema/index.ts';
import { applyChange, type Candidate, createRetime, type ObjectRef, type Vector, verifyRun } from '../solver/index.ts';
import { atLeast, atMost, optionValue, publish } from './harness.ts';
import { askedLevels } from './levels.ts';

/** px */
const SIZES = [4, 8, 16, 32] as const;
const DIRECTIONS: readonly Vector[] = [
  { x: 1, y: 0 },
  { x: 0, y: 1 },
  { x: -1, y: 0 },
  { x: 0, y: -1 },
];

/** Ticks that the editor simulates for a place that is dragged over. */
const LIVE = 400_000;

/** Ticks for a place by itself; the editor takes four times as many for the last one. */
const LAST = 1_000_000;

/** Ticks between two looks for a first result. */
const SLICE = 1000;

/** px between two places of a drag */
const STRIDE = 8;

/** What became of one move that broke the run. */
interface Tried {
  readonly isAlive: boolean;
  /** Whether all minerals are collected that were before. */
  readonly isWhole: boolean;
  /** Ticks to the first result; infinite if there is none. */
  readonly first: number;
  /** Ticks of the whole search. */
  readonly all: number;
}

/** All moves by one size. */
interface Moves {
  moves: number;
  readonly broken: Tried[];
}

const refsIn = (level: Level): ObjectRef[] => [
  { kind: 'astronaut', index: 0 },
  { kind: 'blackHole', index: 0 },
  ...LISTED_KINDS.flatMap((kind) => {
    const { list } = KINDS[kind];
    const objects = (level as unknown as Record<string, readonly unknown[]>)[list as string];
    return objects.map((_, index) => ({ kind, index }));
  }),
];

function placeOf(level: Level, { kind, index }: ObjectRef): Vector {
  const { list } = KINDS[kind];
  const found = (level as unknown as Record<string, unknown>)[list ?? kind];
  return (list === null ? found : (found as readonly unknown[])[index]) as Vector;
}

/** The scene with one object moved. */
function moved(level: Level, object: ObjectRef, by: Vector): Scene {
  const from = placeOf(level, object);
  return compile(applyChange(level, { what: 'move', object, from, to: { x: from.x + by.x, y: from.y + by.y } }));
}

const completes = (scene: Scene, holds: Candidate['holds']): boolean => (verifyRun(scene, holds)?.time ?? 0) > 0;

/** Seeks holds in one place. @param warm those of the place before; null: none */
function keepAlive(scene: Scene, level: Level, before: Candidate, most: number, warm: Candidate['holds'] | null) {
  const retime = createRetime(scene, level.runs[0].holds, { minerals: before.minerals, formerEnd: before.tick, warm });
  let first = Number.POSITIVE_INFINITY;
  while (!retime.finished && retime.effort.ticks < most) {
    retime.advance(SLICE);
    if (retime.best !== null) first = Math.min(first, retime.effort.ticks);
  }
  const { best } = retime;
  // the claim is not believed
  const isAlive = best !== null && completes(scene, best.holds);
  const tried: Tried = { isAlive, isWhole: isAlive && best.lost.length === 0, first, all: retime.effort.ticks };
  return { tried, holds: isAlive ? best.holds : null };
}

const single = new Map(SIZES.map((size) => [size, { moves: 0, broken: [] } as Moves]));
const dragged: Moves = { moves: 0, broken: [] };
const only = optionValue('--only');
for (const { name, level } of askedLevels().filter((entry) => only === null || entry.name.includes(only))) {
  const before = verifyRun(compile(level), level.runs[0].holds);
  if (before === null) throw new Error(`expected the first run of ${name} to complete it`);
  for (const object of refsIn(level)) {
    for (const direction of DIRECTIONS) {
      for (const [size, row] of single) {
        const scene = moved(level, object, { x: size * direction.x, y: size * direction.y });
        row.moves++;
        if (!completes(scene, level.runs[0].holds)) row.broken.push(keepAlive(scene, level, before, LAST, null).tried);
      }
      let warm: Candidate['holds'] | null = null;
      for (let by = STRIDE; by <= SIZES[SIZES.length - 1]; by += STRIDE) {
        const scene = moved(level, object, { x: by * direction.x, y: by * direction.y });
        dragged.moves++;
        if (completes(scene, level.runs[0].holds)) continue;
        const { tried, holds } = keepAlive(scene, level, before, LIVE, warm);
        dragged.broken.push(tried);
        warm = holds ?? warm;
      }
    }
  }
}

const alive = ({ broken }: Moves): Tried[] => broken.filter(({ isAlive }) => isAlive);
const share = (part: number, all: number): number => (all === 0 ? 1 : part / all);
const kept = (row: Moves): number => share(alive(row).length, row.broken.length);
const quantile = (values: readonly number[], p: number): number | null =>
  [...values].sort((a, b) => a - b)[Math.floor(p * (values.length - 1))] ?? null;
const thousands = (ticks: number | null): number | null => (ticks === null ? null : Math.round(ticks / 100) / 10);

function rowOf(what: string, row: Moves) {
  const found = alive(row);
  const firsts = found.map(({ first }) => first);
  return [
    what,
    row.moves,
    row.broken.length,
    found.length,
    found.filter(({ first }) => first <= LIVE).length,
    found.filter(({ isWhole }) => isWhole).length,
    thousands(quantile(firsts, 0.5)),
    thousands(quantile(firsts, 0.95)),
    thousands(
      quantile(
        row.broken.map(({ all }) => all),
        0.5,
      ),
    ),
  ];
}

const all: Moves = { moves: 0, broken: [...single.values()].flatMap(({ broken }) => broken) };
const sizes = [...single.entries()];
publish({
  title: 'Runs kept alive while single objects of the levels are moved',
  columns: [
    'move',
    'moves',
    'break the run',
    'kept alive',
    'with live effort',
    'with all minerals',
    'first, kticks',
    'first, 95 %',
    'whole search',
  ],
  rows: [
    ...sizes.map(([size, row]) => rowOf(`${size} px`, row)),
    rowOf(`dragged to ${SIZES[SIZES.length - 1]} px, each ${STRIDE} px`, dragged),
  ],
  claims: [
    ...sizes.map(([size, row]) =>
      atLeast(`share kept alive, ${size} px`, kept(row), { 4: 0.95, 8: 0.8, 16: 0.8, 32: 0.7 }[size]),
    ),
    atLeast(
      'share of those that keep all minerals',
      share(all.broken.filter(({ isWhole }) => isWhole).length, alive(all).length),
      0.85,
    ),
    atLeast(
      'share of those found with live effort',
      share(alive(all).filter(({ first }) => first <= LIVE).length, alive(all).length),
      0.95,
    ),
    atMost(
      'thousand ticks to a first result in a drag, median',
      thousands(
        quantile(
          alive(dragged).map(({ first }) => first),
          0.5,
        ),
      ) ?? 0,
      40,
    ),
  ],
  notes: [
    `Each object, in four directions, at precise. Effort in simulated ticks: ${LAST / 1e6} million at most for a move, ${LIVE / 1e6} million while something is dragged.`,
    'Every result is simulated again from the start. Where nothing is found, no timing may help: the levels are tight.',
  ],
});
