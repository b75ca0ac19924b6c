import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile, type Ending, joinHolds, type Simulation } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { certifyWith } from '../../../solver/measure/robustness/certify.ts';
import { clustersOf, judgeAll, ShiftBox, shiftHolds, shiftsUpTo, type Trials } from '../../../solver/measure/robustness/index.ts';
import { slackOf } from '../../../solver/measure/robustness/slack.ts';
import { finish } from '../../../solver/steps.ts';
import { expectDeep } from '../../depth.ts';
import { fallThrough } from '../search/solvable-levels.ts';
import { ANY } from './scenes.ts';

// In a real level, shifts by one tick nearly always succeed where shifts by two do, so a level cannot show that every
// combination is tried. Here a hash of the button's whole history decides whether a run succeeds and when it ends.

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

/** Games that may end after the longest run, or always before it. */
const arbitraryGame = (failing: fc.Arbitrary<number>) =>
  fc.tuple(fc.nat(2 ** 31), failing, fc.integer({ min: 8, max: 400 }), fc.constantFrom(LAST, LAST, LAST, 40)).map(
    ([salt, one, ending, maxTicks]) =>
      (): Trials => ({ ...trialsOf(new HashGame(salt, one, ending)), maxTicks }),
  );

/** Simulated tick by tick from the start. */
function succeeds(game: () => Trials, holds: readonly Hold[]): boolean {
  const { simulation, maxTicks } = game();
  for (let tick = 0; tick < maxTicks; tick++)
    simulation.advance(
      1,
      holds.some(([press, release]) => press <= tick && tick < release),
    );
  return simulation.ending?.outcome === 'completed';
}

/** The state of the button in each tick until the run ends, as text. */
function history(game: () => Trials, holds: readonly Hold[]): string {
  const { simulation, maxTicks } = game();
  let text = '';
  for (let tick = 0; tick < maxTicks && simulation.ending === null; tick++) {
    const held = holds.some(([press, release]) => press <= tick && tick < release);
    simulation.advance(1, held);
    text += held ? '#' : '.';
  }
  return text;
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
      expect(counterexample === null).toBe(ticks === 2);
      if (counterexample === null) return;
      expect(succeeds(game, counterexample)).toBe(false);
      // It is one of the combinations, as far as it was simulated.
      const played = history(game, counterexample);
      expect((itself ? all(largest + 1) : [holds]).some((run) => history(game, run) === played)).toBe(true);
    }),
    { numRuns: 150 },
  );
  // Every answer has occurred.
  for (const times of proved) expectDeep(times).toBeGreaterThan(4);
});

it('the slack of an edge is how far it can move alone, each way', () => {
  const found = new Set<number>();
  fc.assert(
    fc.property(
      arbitraryGame(fc.constantFrom(3, 30, 300)),
      arbitraryScript,
      fc.integer({ min: 1, max: 6 }),
      (game, holds, limit) => {
        const shifted = (edge: number, by: number) =>
          shiftHolds(
            holds,
            holds.flatMap((_, i) => [2 * i, 2 * i + 1]).map((one) => (one === edge ? by : 0)),
          );
        const byHand = (edge: number, direction: number): number => {
          let by = 0;
          while (by < limit && succeeds(game, holds) && succeeds(game, shifted(edge, (by + 1) * direction))) by++;
          found.add(by);
          return by;
        };
        const edges = [...holds.flat().keys()];
        expect(finish(slackOf(game(), holds, limit))).toEqual(
          edges.map((edge) => ({ earlier: byHand(edge, -1), later: byHand(edge, 1) })),
        );
      },
    ),
    { numRuns: 300 },
  );
  for (const slack of [0, 1, 2, 6]) expect(found).toContain(slack);
});

it('a certificate with few runs claims no more than is true, and takes no more runs', () => {
  let [undecided, decided, refuted] = [0, 0, 0];
  fc.assert(
    fc.property(
      arbitraryGame(fc.constantFrom(30, 300, 3000)),
      arbitraryScript,
      fc.integer({ min: 1, max: 700 }),
      (game, holds, most) => {
        const trials = game();
        // Runs tried before by others do not count.
        trials.runs = 5000;
        const { ticks, exhausted, counterexample, runs } = certifyWith(trials, holds, most, 2);
        const whole = certifyWith(game(), holds, 1e6, 2);
        expect(runs).toBe(trials.runs - 5000);
        expect(runs).toBeLessThanOrEqual(Math.max(most, 1));
        expect(ticks).toBeLessThanOrEqual(whole.ticks);
        if (counterexample !== null) expect(succeeds(game, counterexample)).toBe(false);
        if (exhausted) {
          undecided++;
          expect(counterexample).toBeNull();
          return;
        }
        decided++;
        expect(ticks).toBe(whole.ticks);
        if (counterexample !== null) refuted++;
        expect(counterexample === null).toBe(ticks === 2);
      },
    ),
    { numRuns: 400 },
  );
  for (const times of [undecided, decided, refuted]) expectDeep(times).toBeGreaterThan(20);
});

it('a certificate by default tries 200,000 runs, and shifts by one second at most', () => {
  const end = 6000;
  // Nothing that the button does changes anything.
  const simulation = {
    tick: 0,
    mineralCount: 0,
    get ending() {
      return this.tick < end ? null : { outcome: 'completed' };
    },
    reset() {
      this.tick = 0;
    },
    snapshot() {
      return Float64Array.of(this.tick);
    },
    restore([tick]: Float64Array) {
      this.tick = tick;
    },
    advance(ticks: number) {
      this.tick += ticks;
      return ticks;
    },
  };
  const certain = (): Trials => ({ ...trialsOf(new HashGame(1, 1, 1)), maxTicks: end, simulation: simulation as never });
  const holds: Hold[] = [
    [500, 1000],
    [1500, 2000],
    [2500, 3000],
  ];
  // By 3 ticks there are 7 to the power of 6 combinations, by 4 more than 200,000.
  expect(certifyWith(certain(), holds)).toEqual({ ticks: 3, exhausted: true, runs: 200_000, counterexample: null });
  expect(certifyWith(certain(), holds.slice(0, 1))).toMatchObject({ ticks: 60, exhausted: false, counterexample: null });
  expect(certifyWith(certain(), [], 10)).toEqual({ ticks: 60, exhausted: false, runs: 1, counterexample: null });
});

it('edges that shifts can bring out of order are read together, if there are not too many combinations', () => {
  const holds: Hold[] = [
    [10, 14],
    [19, 30],
  ];
  // 10 and 14 are 4 apart, 14 and 19 are 5, 19 and 30 are 11.
  const clusters = (k: number, most: number) => clustersOf(holds, k, shiftsUpTo(k), most)?.map(({ ways }) => ways.length > 0);
  expect(clusters(1, 1e6)).toHaveLength(4);
  expect(clusters(2, 1e6)).toHaveLength(3);
  expect(clusters(3, 1e6)).toHaveLength(2);
  expect(clusters(5, 1e6)).toHaveLength(2);
  expect(clusters(6, 1e6)).toHaveLength(1);
  expect(clusters(2, 25)).toHaveLength(3);
  expect(clusters(2, 24)).toBeUndefined();
  expect(clusters(3, 7 ** 3)).toHaveLength(2);
  expect(clusters(3, 7 ** 3 - 1)).toBeUndefined();
  expect(clustersOf(holds, 2, shiftsUpTo(2), 25)?.map(({ heldBefore }) => heldBefore)).toEqual([false, false, true]);
});

it('a box tried in pieces gives the same as in one go', () => {
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
          // Others use the simulation meanwhile.
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

it('runs judged together are judged like each one alone', () => {
  fc.assert(
    fc.property(
      arbitraryGame(fc.constantFrom(2, 5)),
      fc.array(arbitraryScript, { minLength: 1, maxLength: 40 }),
      (game, runs) => {
        const trials = game();
        const all = [...runs, [], runs[0]];
        expect([...judgeAll(trials, all)]).toEqual(all.map((run) => (succeeds(game, run) ? 1 : 0)));
        // What some have in common at their beginning is simulated once.
        const beginnings = new Set(
          all.flatMap((run) => [...history(game, run)].map((_, i, ticks) => ticks.slice(0, i + 1).join(''))),
        );
        expect(trials.ticks).toBe(beginnings.size);
      },
    ),
    { numRuns: 200 },
  );
});
