import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile, type Ending, joinHolds, type Simulation } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { certifyWith } from '../../../solver/robustness/certify.ts';
import { clustersOf, judgeAll, ShiftBox, shiftHolds, shiftsUpTo, type Trials } from '../../../solver/robustness/index.ts';
import { fallThrough } from '../search/solvable-levels.ts';
import { ANY } from './scenes.ts';

// In a real level shifts by one tick succeed where shifts by two do, nearly always, so it can't show that every combination
// is tried. Here the button's whole history decides, by a hash, whether a run succeeds, and when it ends.

const LAST = 48;

/** A game whose outcome is a hash of what the button did in every tick so far. */
class HashGame implements Pick<Simulation, 'tick' | 'ending' | 'mineralCount' | 'advance' | 'snapshot' | 'restore' | 'reset'> {
  readonly mineralCount = 0;
  /** tick, hash, ended */
  private state = new Float64Array(3);
  private readonly salt: number;
  private readonly failing: number;
  private readonly ending_: number;

  /** @param failing one run in so many fails; @param ending one tick in so many ends a run */
  constructor(salt: number, failing: number, ending: number) {
    this.salt = salt;
    this.failing = failing;
    this.ending_ = ending;
    this.reset();
  }

  get tick(): number {
    return this.state[0];
  }

  get ending(): Ending | null {
    if (this.state[2] === 0) return null;
    const completed = (this.state[1] >>> 5) % this.failing !== 0;
    return { outcome: completed ? 'completed' : 'lost', with: null, time: this.tick / 60, tick: this.tick - 1 };
  }

  reset(): void {
    this.state = Float64Array.of(0, this.salt, 0);
  }

  snapshot(): Float64Array {
    return this.state.slice();
  }

  restore(snapshot: Float64Array): void {
    this.state.set(snapshot);
  }

  advance(ticks: number, held: boolean): number {
    for (let i = 0; i < ticks; i++) {
      if (this.state[2] !== 0) return i;
      let hash = Math.imul(this.state[1] ^ (held ? 0x9e3779b9 : 0x7f4a7c15), 0x85ebca6b);
      hash = (hash ^ (hash >>> 13)) >>> 0;
      this.state[0]++;
      this.state[1] = hash;
      if (this.state[0] === LAST || (this.state[0] > 25 && hash % this.ending_ === 0)) this.state[2] = 1;
    }
    return ticks;
  }
}

const scene = compile(fallThrough(), 'arcade');

const trialsOf = (game: HashGame): Trials => ({
  scene,
  goal: ANY,
  maxTicks: LAST,
  simulation: game as unknown as Simulation,
  runs: 0,
  ticks: 0,
});

const arbitraryGame = (failing: fc.Arbitrary<number>) =>
  fc.tuple(fc.nat(2 ** 31), failing, fc.integer({ min: 8, max: 400 })).map((args) => () => trialsOf(new HashGame(...args)));

/** Played tick by tick from the start. */
function succeeds(game: () => Trials, holds: readonly Hold[]): boolean {
  const { simulation } = game();
  for (let tick = 0; tick < LAST; tick++)
    simulation.advance(
      1,
      holds.some(([press, release]) => press <= tick && tick < release),
    );
  return simulation.ending?.outcome === 'completed';
}

const arbitraryScript = fc
  .array(
    fc.tuple(fc.nat(LAST), fc.integer({ min: 1, max: 12 })).map(([press, ticks]): Hold => [press, press + ticks]),
    {
      minLength: 1,
      maxLength: 2,
    },
  )
  .map((holds) => joinHolds(holds));

function combinations(n: number, k: number): number[][] {
  if (n === 0) return [[]];
  return combinations(n - 1, k).flatMap((rest) => shiftsUpTo(k).map((shift) => [...rest, shift]));
}

it('a certificate tries every combination, and nothing else', () => {
  const proved = [0, 0, 0];
  fc.assert(
    fc.property(arbitraryGame(fc.constantFrom(3, 30, 300, 3000)), arbitraryScript, (game, holds) => {
      const all = (k: number) => combinations(2 * holds.length, k).map((shifts) => shiftHolds(holds, shifts));
      let largest = 0;
      while (largest < 2 && all(largest + 1).every((run) => succeeds(game, run))) largest++;
      const itself = succeeds(game, holds);
      const { ticks, exhausted, counterexample } = certifyWith(game(), holds, 1e6, 2);
      expect(exhausted).toBe(false);
      expect(ticks).toBe(itself ? largest : 0);
      proved[ticks]++;
      if (counterexample !== null) expect(succeeds(game, counterexample)).toBe(false);
      expect(counterexample === null).toBe(ticks === 2);
    }),
    { numRuns: 400 },
  );
  // every answer has come up
  for (const times of proved) expect(times).toBeGreaterThan(10);
});

it('a box tried bit by bit gives what it gives in one go', () => {
  fc.assert(
    fc.property(
      arbitraryGame(fc.constantFrom(30, 3000)),
      arbitraryScript,
      fc.integer({ min: 1, max: 9 }),
      (game, holds, part) => {
        const box = (trials: Trials) => new ShiftBox(trials, clustersOf(holds, 2, shiftsUpTo(2), 1e6) ?? []);
        const whole = game();
        const expected = box(whole).run(1e6);
        const parts = game();
        const slow = box(parts);
        let result = slow.run(part);
        while (result === 'unfinished') {
          // somebody else uses the simulation meanwhile
          parts.simulation.reset();
          parts.simulation.advance(7, true);
          result = slow.run(part);
        }
        expect(result).toEqual(expected);
        expect(parts.runs).toBe(whole.runs);
      },
    ),
    { numRuns: 100 },
  );
});

it('runs judged together are judged as each on its own', () => {
  fc.assert(
    fc.property(
      arbitraryGame(fc.constantFrom(2, 5)),
      fc.array(arbitraryScript, { minLength: 1, maxLength: 40 }),
      (game, runs) => {
        expect([...judgeAll(game(), [...runs, [], runs[0]])]).toEqual(
          [...runs, [], runs[0]].map((run) => (succeeds(game, run) ? 1 : 0)),
        );
      },
    ),
    { numRuns: 200 },
  );
});
