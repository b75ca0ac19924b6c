/** The four directions in which reach is measured. */
const DIRECTIONS = ['left', 'right', 'up', 'down'] as const;
type Direction = (typeof DIRECTIONS)[number];

const STEPS: Readonly<Record<Direction, readonly [x: number, y: number]>> = {
  left: [-1, 0],
  right: [1, 0],
  up: [0, -1],
  down: [0, 1],
};

/** How far the objects can be moved in a direction until the run ends otherwise. Every px up to there was simulated. */
export interface Reach {
  readonly direction: Direction;
  /** px at all of which the run ends as where the objects are now */
  readonly same: number;
  /** Whether it ends otherwise one px farther; false: not examined yet, or `MOST_REACH` px are all the same. */
  readonly isEnd: boolean;
}

/** The largest distance that is examined in a direction, px. */
export const MOST_REACH = 400;
/** At most so many cells are examined first. */
const MOST_COARSE = 320;
/** The survey ends after so many samples. */
const MOST_SAMPLES = 40_000;
/** A cell in which all samples agree is examined after mixed ones that were halved so many times more. */
const UNIFORM_WAITS = 3;

interface SurveyParts {
  /** The run with the lead on a place of the lattice. */
  readonly sampleAt: (i: number, j: number) => Sample;
  /** The run with the objects moved by whole px. */
  readonly sampleBy: (dx: number, dy: number) => Sample;
  /** What is examined, units of the lattice. */
  readonly region: Omit<Cell, 'depth'>;
  /** Units between places on which objects snap. */
  readonly base: number;
  /** Units between samples that agree, in the end. */
  readonly finest: number;
}

/** Keys of places: their coordinates are far below 2^25. */
const HALF = 2 ** 25;
const keyOf = (i: number, j: number): number => (i + HALF) * 2 * HALF + (j + HALF);

/**
 * Samples where a run completes a level: a coarse grid first, the nearest cells before farther ones; then how far the objects can
 * go in four directions; then finer and finer where samples differ, and less fine where they agree.
 */
export class Survey {
  /** What is found where the objects are now; null: not known yet. */
  base: Sample | null = null;
  samples = 0;
  isFinished = false;
  private readonly known = new Map<number, Sample>();
  private readonly states = new Map<Cell, CellState>();
  private readonly reaches = new Map<Direction, Reach>();
  /** Cells to be halved, by the order in which that is done. */
  private readonly queues: Cell[][] = [];
  private readonly roots: readonly Cell[];

  constructor(private readonly parts: SurveyParts) {
    const { region, base } = parts;
    let side = base;
    while (((region.right - region.left) / side + 1) * ((region.bottom - region.top) / side + 1) > MOST_COARSE) side *= 2;
    this.roots = coarseCells(region, side);
    for (const cell of this.roots) this.states.set(cell, 'unsampled');
  }

  /** Yields after each sample. */
  *work(): Generator<null, void, void> {
    this.base = this.parts.sampleBy(0, 0);
    this.samples++;
    yield null;
    if (this.base !== 'unknown') {
      for (const cell of this.roots) yield* this.examine(cell);
      for (const direction of DIRECTIONS) yield* this.reachOut(direction);
      for (let cell = this.next(); cell !== null && this.samples < MOST_SAMPLES; cell = this.next()) {
        this.states.delete(cell);
        const parts = partsOf(cell);
        for (const part of parts) this.states.set(part, 'unsampled');
        for (const part of parts) yield* this.examine(part);
      }
    }
    this.isFinished = true;
  }

  /** What is known of every cell: `CELL_NUMBERS` numbers each. */
  cells(): Int32Array {
    const cells = new Int32Array(CELL_NUMBERS * this.states.size);
    let o = 0;
    for (const [cell, state] of this.states) {
      const { left, top, right, bottom } = cell;
      cells.set([left, top, right, bottom, codeOf(cell, state, (i, j) => this.known.get(keyOf(i, j)) ?? null)], o);
      o += CELL_NUMBERS;
    }
    return cells;
  }

  /** The longest side of cells in which samples agree, and of those in which they do not, units; 0: there are none. */
  sides(): { readonly uniform: number; readonly mixed: number; readonly isCovered: boolean } {
    let [uniform, mixed, isCovered] = [0, 0, true];
    for (const [cell, state] of this.states) {
      if (state === 'unsampled') isCovered = false;
      else if (state === 'mixed' || state === 'corners') mixed = Math.max(mixed, sideOf(cell));
      else uniform = Math.max(uniform, sideOf(cell));
    }
    return { uniform, mixed, isCovered };
  }

  reach(): readonly Reach[] {
    return DIRECTIONS.map((direction) => this.reaches.get(direction) ?? { direction, same: 0, isEnd: false });
  }

  /** Whether all four directions have been examined. */
  get isReachKnown(): boolean {
    return DIRECTIONS.every((direction) => {
      const reach = this.reaches.get(direction);
      return reach !== undefined && (reach.isEnd || reach.same === MOST_REACH);
    });
  }

  private *examine(cell: Cell): Generator<null, void, void> {
    const samples: Sample[] = [];
    for (const [i, j] of placesIn(cell)) {
      const key = keyOf(i, j);
      let sample = this.known.get(key);
      if (sample === undefined) {
        sample = this.parts.sampleAt(i, j);
        this.known.set(key, sample);
        this.samples++;
        yield null;
      }
      samples.push(sample);
    }
    const state = stateOf(cell, samples);
    this.states.set(cell, state);
    if (state === 'corners' || state === 'unsampled') return;
    if (state !== 'mixed' && sideOf(cell) <= this.parts.finest) return;
    const order = cell.depth + (state === 'mixed' ? 0 : UNIFORM_WAITS);
    while (this.queues.length <= order) this.queues.push([]);
    this.queues[order].push(cell);
  }

  private *reachOut(direction: Direction): Generator<null, void, void> {
    const [x, y] = STEPS[direction];
    for (let same = 0; same < MOST_REACH; same++) {
      const sample = this.parts.sampleBy(x * (same + 1), y * (same + 1));
      this.samples++;
      const isEnd = sample !== this.base;
      this.reaches.set(direction, { direction, same: isEnd ? same : same + 1, isEnd });
      yield null;
      if (isEnd) return;
    }
  }

  /** The next cell to be halved: one of the largest; null: none is left. */
  private next(): Cell | null {
    for (const queue of this.queues) {
      const cell = queue.shift();
      if (cell !== undefined) return cell;
    }
    return null;
  }
}

/** What was found at a place: whether the run completes the level; `unknown`: it takes too much work. */
export type Sample = 'completes' | 'fails' | 'unknown';

/** A rectangle of the lattice: between places, in units. */
interface Cell {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  /** how often it was halved */
  readonly depth: number;
}

/**
 * What is known of a cell. `completes`, `fails`: its corners and its middle agree; the rest of it is a guess. `mixed`: they do not.
 * `corners`: they do not, and there is no place between its corners. `unsampled`: it has not been examined, or takes too much work.
 */
export type CellState = 'completes' | 'fails' | 'mixed' | 'corners' | 'unsampled';

/** The places of a cell that are sampled: its corners, row by row, and its middle if there is one. */
function placesIn({ left, top, right, bottom }: Cell): readonly (readonly [i: number, j: number])[] {
  const corners = [
    [left, top],
    [right, top],
    [left, bottom],
    [right, bottom],
  ] as const;
  return isFinest({ left, top, right, bottom }) ? corners : [...corners, [(left + right) >> 1, (top + bottom) >> 1]];
}

/** Whether there is no place between its corners. */
const isFinest = ({ left, top, right, bottom }: Omit<Cell, 'depth'>): boolean => right - left <= 1 && bottom - top <= 1;

/** The longer side of a cell, units. */
const sideOf = ({ left, top, right, bottom }: Cell): number => Math.max(right - left, bottom - top);

/** The quarters of a cell; halves of one that is a unit wide or high. */
function partsOf({ left, top, right, bottom, depth }: Cell): Cell[] {
  const halves = (from: number, to: number): [number, number][] => {
    const middle = (from + to) >> 1;
    return to - from > 1
      ? [
          [from, middle],
          [middle, to],
        ]
      : [[from, to]];
  };
  return halves(top, bottom).flatMap(([above, below]) =>
    halves(left, right).map(([west, east]) => ({ left: west, top: above, right: east, bottom: below, depth: depth + 1 })),
  );
}

/** @param samples at the places of the cell */
function stateOf(cell: Cell, samples: readonly Sample[]): CellState {
  const [first, ...others] = samples;
  if (samples.includes('unknown')) return 'unsampled';
  if (first !== 'unknown' && others.every((sample) => sample === first)) return first;
  return isFinest(cell) ? 'corners' : 'mixed';
}

/** The cells of equal size that cover a rectangle, those nearest to the origin first. @param side of a cell, units */
function coarseCells({ left, top, right, bottom }: Omit<Cell, 'depth'>, side: number): Cell[] {
  const cells: Cell[] = [];
  for (let j = Math.floor(top / side); j < Math.ceil(bottom / side); j++) {
    for (let i = Math.floor(left / side); i < Math.ceil(right / side); i++)
      cells.push({ left: i * side, top: j * side, right: (i + 1) * side, bottom: (j + 1) * side, depth: 0 });
  }
  const away = (cell: Cell) => {
    const x = (cell.left + cell.right) / 2;
    const y = (cell.top + cell.bottom) / 2;
    return x * x + y * y;
  };
  return cells.sort((a, b) => away(a) - away(b));
}

/** Numbers per cell: left, top, right, bottom in units, and its state. */
export const CELL_NUMBERS = 5;

const STATES: readonly CellState[] = ['completes', 'fails', 'mixed', 'unsampled', 'corners'];
const CORNERS = STATES.indexOf('corners');

/** The state of a cell as a number; of `corners` also which of them complete. */
function codeOf(cell: Cell, state: CellState, sampleAt: (i: number, j: number) => Sample | null): number {
  if (state !== 'corners') return STATES.indexOf(state);
  const bits = placesIn(cell).reduce((sum, [i, j], k) => sum + (sampleAt(i, j) === 'completes' ? 1 << k : 0), 0);
  return CORNERS + STATES.length * bits;
}

export const stateOfCode = (code: number): CellState => STATES[code % STATES.length];

/** Whether a corner completes: 0 left above, 1 right above, 2 left below, 3 right below. */
export const cornerCompletes = (code: number, corner: number): boolean =>
  ((Math.floor(code / STATES.length) >> corner) & 1) === 1;
