import { compile, STATE_SIZE, simulate, TICK } from '../../../engine/index.ts';
import { type LevelFile, LISTED_KINDS, listOf, resolveLevel } from '../../../schema/index.ts';

/** How much the levels of a set differ. Distances are from 0, the same up to symmetry, to 1. */
export interface Variety {
  /** The mean distance over all pairs. */
  readonly mean: number;
  /** The smallest distance, and the indices of the two levels. */
  readonly closest: { readonly distance: number; readonly first: number; readonly second: number };
}

/** What a level is compared by. */
export interface Traits {
  /** Where solid objects and her path are, from 0 to 1, on a square grid; first objects, then the path. */
  readonly grid: Float64Array;
  /** Numbers of the run and the level, each from 0 to 1. */
  readonly numbers: readonly number[];
}

// Cells of the grid on each side.
const SIDE = 6;

// Ticks between two places of her path.
const EVERY = 6;

/**
 * Measures the traits of a level: a grid of 6 x 6 cells stretched over its objects and her path, which says where objects are
 * and where her first run leads; and presses, length, targets, turns to either side, and the share of each kind of object.
 * @param file a level with a run
 */
export function traitsOf(file: LevelFile): Traits {
  const level = resolveLevel(file);
  const run = simulate(compile(level), level.runs[0]?.holds ?? []);
  const state = new Float64Array(STATE_SIZE);
  const path: { x: number; y: number }[] = [];
  for (let tick = 0; tick * TICK <= run.time; tick += EVERY) {
    run.trajectory.at(tick * TICK, state);
    path.push({ x: state[0], y: state[1] });
  }
  const kinds = LISTED_KINDS.filter((kind) => kind !== 'mineral').map((kind) => level[listOf(kind)]);
  const objects = [level.blackHole, ...kinds.flat()].map(({ x, y }) => ({ x, y }));

  const all = [...objects, ...path];
  const left = Math.min(...all.map(({ x }) => x));
  const top = Math.min(...all.map(({ y }) => y));
  const width = Math.max(1, Math.max(...all.map(({ x }) => x)) - left);
  const height = Math.max(1, Math.max(...all.map(({ y }) => y)) - top);
  const grid = new Float64Array(2 * SIDE * SIDE);
  const cell = (share: number) => Math.min(SIDE - 1, Math.floor(share * SIDE));
  const mark = (places: readonly { x: number; y: number }[], from: number) => {
    for (const { x, y } of places) grid[from + cell((y - top) / height) * SIDE + cell((x - left) / width)] = 1;
  };
  mark(objects, 0);
  mark(path, SIDE * SIDE);

  let turns = 0;
  let clockwise = 0;
  for (let i = 2; i < path.length; i++) {
    const [a, b, c] = [path[i - 2], path[i - 1], path[i]];
    const cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    turns += Math.abs(cross);
    clockwise += Math.max(0, cross);
  }
  // turning left throughout and turning right throughout are the same up to a mirror
  const oneSided = turns < 1e-9 ? 0 : Math.abs((2 * clockwise) / turns - 1);
  const targets = new Set(run.events.flatMap((event) => (event.type === 'target' ? [event.index] : [])));
  const presses = level.runs[0]?.holds.length ?? 0;
  const share = (count: number, half: number) => count / (count + half);
  return {
    grid,
    numbers: [
      share(presses, 3),
      share(run.time, 12),
      share(targets.size, 3),
      oneSided,
      share(level.asteroids.filter(({ hot }) => hot).length, 1),
      ...kinds.map((list, i) => share(list.length, i < 2 ? 5 : 1)),
    ],
  };
}

/** Where each cell of the grid goes in each of its eight symmetries. */
const SYMMETRIES: readonly Int32Array[] = Array.from({ length: 8 }, (_, symmetry) =>
  Int32Array.from({ length: 2 * SIDE * SIDE }, (_, i) => {
    const from = i < SIDE * SIDE ? 0 : SIDE * SIDE;
    let [row, column] = [Math.floor((i - from) / SIDE), (i - from) % SIDE];
    if ((symmetry & 1) !== 0) column = SIDE - 1 - column;
    if ((symmetry & 2) !== 0) row = SIDE - 1 - row;
    if ((symmetry & 4) !== 0) [row, column] = [column, row];
    return from + row * SIDE + column;
  }),
);

/**
 * The distance between two levels: half of it is the share of cells that differ among those that either level uses (Jaccard
 * distance), in the most similar of the eight turns and mirror images; the other half is the mean difference of the numbers.
 * @returns from 0, the same up to symmetry, to 1
 */
export function distanceBetween(a: Traits, b: Traits): number {
  let closest = 1;
  for (const to of SYMMETRIES) {
    let both = 0;
    let either = 0;
    for (let i = 0; i < to.length; i++) {
      const there = b.grid[to[i]];
      both += a.grid[i] * there;
      either += Math.max(a.grid[i], there);
    }
    closest = Math.min(closest, either === 0 ? 0 : 1 - both / either);
  }
  const off = a.numbers.reduce((sum, number, i) => sum + Math.abs(number - b.numbers[i]), 0) / a.numbers.length;
  return (closest + off) / 2;
}

/**
 * Measures how much levels differ.
 * @param files levels, each with a run
 * @returns the mean distance and the closest pair; null for fewer than two levels
 */
export function varietyOf(files: readonly LevelFile[]): Variety | null {
  const traits = files.map(traitsOf);
  let sum = 0;
  let pairs = 0;
  let closest: Variety['closest'] | null = null;
  for (let first = 0; first < traits.length; first++) {
    for (let second = first + 1; second < traits.length; second++) {
      const distance = distanceBetween(traits[first], traits[second]);
      sum += distance;
      pairs++;
      if (closest === null || distance < closest.distance) closest = { distance, first, second };
    }
  }
  return closest === null ? null : { mean: sum / pairs, closest };
}

/**
 * Measures how far each level is from the one that is most like it.
 * @param files at least two levels, each with a run
 * @returns a distance for each level, in the same order
 */
export function nearestDistances(files: readonly LevelFile[]): number[] {
  const traits = files.map(traitsOf);
  return traits.map((one, i) => Math.min(...traits.filter((_, k) => k !== i).map((other) => distanceBetween(one, other))));
}
