import { compile, type Scene } from '../engine/index.ts';
import { KINDS, type Level, LISTED_KINDS } from '../schema/index.ts';
import { applyChange, type Candidate, createRetime, type ObjectRef, type Vector, verifyRun } from '../solver/index.ts';
import { askedLevels, atLeast, atMost, define, LEVELS, lowerRank, type NamedLevel, text } from './harness/index.ts';

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

const alive = ({ broken }: Moves): Tried[] => broken.filter(({ isAlive }) => isAlive);
const share = (part: number, all: number): number => (all === 0 ? 1 : part / all);
const kept = (row: Moves): number => share(alive(row).length, row.broken.length);
/** Thousand ticks that a share of the searches takes at most; null of none. */
function thousands(ticks: readonly number[], part: number): number | null {
  const found = lowerRank(ticks, part);
  return found === undefined ? null : Math.round(found / 100) / 10;
}

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
    thousands(firsts, 0.5),
    thousands(firsts, 0.95),
    thousands(
      row.broken.map(({ all }) => all),
      0.5,
    ),
  ];
}

/** Moves each object of a level in each direction, at once and in a drag. */
function moveAll({ name, level }: NamedLevel, single: ReadonlyMap<number, Moves>, dragged: Moves): void {
  const { holds } = level.runs[0];
  const before = verifyRun(compile(level), holds);
  if (before === null) throw new Error(`expected the first run of ${name} to complete it`);
  for (const object of refsIn(level)) {
    for (const direction of DIRECTIONS) {
      for (const [size, row] of single) {
        const scene = moved(level, object, { x: size * direction.x, y: size * direction.y });
        row.moves++;
        if (!completes(scene, holds)) row.broken.push(keepAlive(scene, level, before, LAST, null).tried);
      }
      let warm: Candidate['holds'] | null = null;
      for (let by = STRIDE; by <= SIZES[SIZES.length - 1]; by += STRIDE) {
        const scene = moved(level, object, { x: by * direction.x, y: by * direction.y });
        dragged.moves++;
        if (completes(scene, holds)) continue;
        const found = keepAlive(scene, level, before, LIVE, warm);
        dragged.broken.push(found.tried);
        warm = found.holds ?? warm;
      }
    }
  }
}

export const bench = define({
  what: 'how many runs are kept alive while single objects of the levels are moved by 4 to 32 px, in ticks; a minute',
  options: { ...LEVELS, only: text('levels whose names contain this') },
  claims: {
    4: atLeast(0.95, 'share kept alive, 4 px'),
    8: atLeast(0.8, 'share kept alive, 8 px'),
    16: atLeast(0.8, 'share kept alive, 16 px'),
    32: atLeast(0.7, 'share kept alive, 32 px'),
    minerals: atLeast(0.85, 'share of those that keep all minerals'),
    live: atLeast(0.95, 'share of those found with live effort'),
    drag: atMost(40, 'thousand ticks to a first result in a drag, median'),
  },
  run({ only, ...asked }) {
    const [by4, by8, by16, by32, dragged] = Array.from({ length: SIZES.length + 1 }, (): Moves => ({ moves: 0, broken: [] }));
    const single = new Map([by4, by8, by16, by32].map((row, i) => [SIZES[i], row]));
    for (const entry of askedLevels(asked).filter(({ name }) => only === null || name.includes(only))) {
      moveAll(entry, single, dragged);
    }
    const all: Moves = { moves: 0, broken: [...single.values()].flatMap(({ broken }) => broken) };
    const ofAlive = (holds: (tried: Tried) => boolean) => share(alive(all).filter(holds).length, alive(all).length);
    return {
      title: 'Runs kept alive while single objects of the levels are moved',
      columns: [
        ...['move', 'moves', 'break the run', 'kept alive', 'with live effort', 'with all minerals', 'first, kticks'],
        ...['first, 95 %', 'whole search'],
      ],
      rows: [
        ...[...single].map(([size, row]) => rowOf(`${size} px`, row)),
        rowOf(`dragged to ${SIZES[SIZES.length - 1]} px, each ${STRIDE} px`, dragged),
      ],
      measured: {
        4: kept(by4),
        8: kept(by8),
        16: kept(by16),
        32: kept(by32),
        minerals: ofAlive(({ isWhole }) => isWhole),
        live: ofAlive(({ first }) => first <= LIVE),
        drag:
          thousands(
            alive(dragged).map(({ first }) => first),
            0.5,
          ) ?? 0,
      },
      notes: [
        `Each object, in four directions, at precise. Effort in simulated ticks: ${LAST / 1e6} million at most for a move, ${LIVE / 1e6} million while something is dragged.`,
        'Every result is simulated again from the start. Where nothing is found, no timing may help: the levels are tight.',
      ],
    };
  },
});
