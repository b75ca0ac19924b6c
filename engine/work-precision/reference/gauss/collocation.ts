import { add, type Dd, dd, divide, multiply, ONE, subtract, times, type Vector } from '../double-double.ts';
import type { Mover } from '../world.ts';
import { type Column, column, dotOf, integralsAt, put, rule, STAGES } from './quadrature.ts';

/** Accelerations of bodies, px/s², from where all of them are and how fast. */
export type Accelerations = (at: readonly Vector[], velocity: readonly Vector[]) => Vector[];

/** Iterations after which a step is taken to be too long. */
const MOST_ITERATIONS = 80;

/** A change of the accelerations below this is rounding, of their size. */
const CONVERGED = 1e-30;

/** How far the motion may be from the truth at the end of a step, px. */
export const GAUSS_TOLERANCE = 1e-21;

/** Where bodies are at a moment, and how fast. */
export interface Places {
  readonly at: Vector[];
  readonly velocity: Vector[];
}

/** The motion of bodies during a step: polynomials whose second derivatives interpolate the accelerations at Gauss nodes. */
export class Step {
  readonly #bodies: readonly Mover[];
  readonly #length: number;
  /** Legendre coefficients of the accelerations: x and y of each body in turn. */
  readonly #coefficients: readonly Column[];

  private constructor(bodies: readonly Mover[], length: number, coefficients: readonly Column[]) {
    this.#bodies = bodies;
    this.#length = length;
    this.#coefficients = coefficients;
  }

  /**
   * Makes a step by Gauss collocation, which is symplectic and of order 32, solved by fixed-point iteration.
   * @param bodies - at the start
   * @param length - of the step, s; a power of 2
   * @returns null if the step is too long
   */
  static of(bodies: readonly Mover[], accelerations: Accelerations, length: number): Step | null {
    const { nodes, once, twice, toLegendre } = rule();
    const half = length / 2;
    const starts = bodies.flatMap(({ at, velocity }) => [
      { at: at.x, velocity: velocity.x },
      { at: at.y, velocity: velocity.y },
    ]);
    const first = accelerations(
      bodies.map(({ at }) => at),
      bodies.map(({ velocity }) => velocity),
    );
    const stages = first.flatMap(({ x, y }) => [filled(x), filled(y)]);
    let before = Number.POSITIVE_INFINITY;
    for (let n = 0; ; n++) {
      if (n === MOST_ITERATIONS) return null;
      const found: Vector[][] = nodes.map((node, j) => {
        const t = times(node, length);
        const places = starts.map(({ at, velocity }, i) =>
          add(add(at, multiply(t, velocity)), times(dotOf(twice[j], stages[i]), half * half)),
        );
        const speeds = starts.map(({ velocity }, i) => add(velocity, times(dotOf(once[j], stages[i]), half)));
        return accelerations(inPairs(places), inPairs(speeds));
      });
      let change = 0;
      let size = 0;
      for (const [j, vectors] of found.entries()) {
        for (const [b, { x, y }] of vectors.entries()) {
          for (const [i, value] of [x, y].entries()) {
            const stage = stages[2 * b + i];
            change = Math.max(change, Math.abs(value.hi - stage.hi[j] + (value.lo - stage.lo[j])));
            size = Math.max(size, Math.abs(value.hi));
            put(stage, j, value);
          }
        }
      }
      if (!Number.isFinite(change)) return null;
      if (change <= CONVERGED * size) break;
      // the last digits may go on to change for ever
      if (change >= before) {
        if (change <= 100 * CONVERGED * size) break;
        if (n > 3) return null;
      }
      before = change;
    }
    const coefficients = stages.map((stage) => {
      const made = column();
      for (const [k, row] of toLegendre.entries()) put(made, k, dotOf(row, stage));
      return made;
    });
    return coefficients.every((c) => fades(c, length)) ? new Step(bodies, length, coefficients) : null;
  }

  /** @param time - since the start of the step, s */
  at(time: Dd): Places {
    const half = this.#length / 2;
    const { once, twice } = integralsAt(subtract(divide(time, dd(half)), ONE));
    const at: Vector[] = [];
    const velocity: Vector[] = [];
    for (const [b, body] of this.#bodies.entries()) {
      const cx = this.#coefficients[2 * b];
      const cy = this.#coefficients[2 * b + 1];
      const along = (start: Dd, speed: Dd, c: Column) =>
        add(add(start, multiply(time, speed)), times(dotOf(twice, c), half * half));
      at.push({ x: along(body.at.x, body.velocity.x, cx), y: along(body.at.y, body.velocity.y, cy) });
      velocity.push({
        x: add(body.velocity.x, times(dotOf(once, cx), half)),
        y: add(body.velocity.y, times(dotOf(once, cy), half)),
      });
    }
    return { at, velocity };
  }
}

/** Whether the last coefficients are so small that those left out are below the tolerance. */
function fades({ hi }: Column, length: number): boolean {
  const last = Math.max(Math.abs(hi[STAGES - 1]), Math.abs(hi[STAGES - 2]));
  return last * length * (1 + length) <= GAUSS_TOLERANCE * Math.max(1, 1e-3 * Math.abs(hi[0]));
}

function filled(value: Dd): Column {
  const made = column();
  made.hi.fill(value.hi);
  made.lo.fill(value.lo);
  return made;
}

function inPairs(values: readonly Dd[]): Vector[] {
  const made: Vector[] = [];
  for (let i = 0; i < values.length; i += 2) made.push({ x: values[i], y: values[i + 1] });
  return made;
}
