import { type AccuracyName, compile, simulate, TICK_RATE } from '../../engine/index.ts';
import { createSearch, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { seeded } from '../scenes/seeded.ts';
import { windyScene } from '../scenes/windy-scene.ts';
import { otherRules, ownRules } from './own-rules.ts';

/** Results for levels that were not made for a proof. */
export interface SolvableTally {
  levels: number;
  /** Levels that a script or a search completes. */
  completed: number;
  /** Minerals that a script collects. */
  collected: number;
  /** Levels proved impossible, in which a run was searched for all the same; none without a search. */
  proved: number;
  /** Certificates of such a level's twin, in which the black hole is out of reach, that were given to the checker. */
  twins: number;
  /**
   * Seeds of levels in which something that a run touches was proved to be out of reach, or a certificate of that was accepted.
   */
  readonly accepted: number[];
}

export const emptySolvable = (): SolvableTally => ({
  levels: 0,
  completed: 0,
  collected: 0,
  proved: 0,
  twins: 0,
  accepted: [],
});

/**
 * A random level with a script; every other one has winds and wormholes, three of four have rules of their own. What a run
 * touches must never be proved to be out of reach. Without a search, the provers are asked only about what the script touches:
 * about anything else, either answer may be right.
 */
export function attackSolvable(seed: number, accuracy: AccuracyName, searchTicks: number, tally: SolvableTally): void {
  const random = seeded(seed + 77_003);
  const scene = seed % 2 === 0 ? randomScene(seed) : windyScene(seed);
  const { holds, maxTime } = scene;
  const level = random() < 0.75 ? { ...scene.level, rules: ownRules(random) } : scene.level;
  const options = { accuracy, maxTime };
  tally.levels++;
  const compiled = compile(level, accuracy);
  const run = simulate(compiled, holds, { maxTime });
  const proof = run.outcome === 'completed' || searchTicks > 0 ? proveImpossible(level, options) : null;
  tally.collected += run.minerals.length;
  const collected = run.minerals.map(({ index }) => index);
  let isWrong = collected.length > 0 && proveMineralsUnreachable(level, options, collected).length > 0;
  if (proof !== null) tally.proved++;
  const isCompleted = run.outcome === 'completed' || (proof !== null && searchTicks > 0 && isFound());
  if (isCompleted) {
    tally.completed++;
    isWrong ||= proof !== null;
    // twins in which she does not reach it: at another place, and under other rules
    const { x, y } = level.blackHole;
    const off = [0.001, 0.1, 5, 100, 2000][Math.floor(random() * 5)];
    const turn = 6.2832 * random();
    const moved = { ...level, blackHole: { ...level.blackHole, x: x + off * Math.cos(turn), y: y + off * Math.sin(turn) } };
    for (const twin of [
      moved,
      otherRules(level, random),
      { ...level, winds: [], wormholes: [] },
      { ...level, range: 0.9 * level.range },
    ]) {
      const like = proveImpossible(twin, options);
      if (like === null) continue;
      tally.twins++;
      isWrong ||= verifyProof(level, like).ok;
    }
  }
  if (isWrong) tally.accepted.push(seed);

  function isFound(): boolean {
    const search = createSearch(compiled, { seed, maxTicks: maxTime * TICK_RATE });
    search.advance(searchTicks);
    return search.solutions.length > 0;
  }
}
