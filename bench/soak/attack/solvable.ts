import { type AccuracyName, compile, simulate, TICK_RATE } from '../../../engine/index.ts';
import { createSearch, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../../solver/index.ts';
import { seeded } from '../../scenes/seeded.ts';
import { randomScene } from '../random-scene.ts';
import { windyScene } from '../windy-scene.ts';
import { otherRules, ownRules } from './own-rules.ts';

/** What came of levels that nobody made for a proof. */
export interface SolvableTally {
  levels: number;
  /** that a script or a search completes */
  completed: number;
  /** minerals that a script collects */
  collected: number;
  /** levels proved impossible, searched for a run all the same */
  proved: number;
  /** certificates of such a level's twin, in which it is out of reach, given to the checker */
  twins: number;
  /** seeds of levels in which what a run touches is proved, or a certificate accepted, to be out of reach */
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

/** A random level with a script, every other one with winds and wormholes, three of four with rules of its own: what a run touches is never proved to be out of reach. */
export function attackSolvable(seed: number, accuracy: AccuracyName, searchTicks: number, tally: SolvableTally): void {
  const random = seeded(seed + 77_003);
  const scene = seed % 2 === 0 ? randomScene(seed) : windyScene(seed);
  const { holds, maxTime } = scene;
  const level = random() < 0.75 ? { ...scene.level, rules: ownRules(random) } : scene.level;
  const options = { accuracy, maxTime };
  tally.levels++;
  const compiled = compile(level, accuracy);
  const run = simulate(compiled, holds, { maxTime });
  const proof = proveImpossible(level, options);
  tally.collected += run.minerals.length;
  const lost = proveMineralsUnreachable(level, options).flatMap(({ about }) => (about.kind === 'mineral' ? [about.index] : []));
  let isWrong = run.minerals.some(({ index }) => lost.includes(index));
  if (proof !== null) tally.proved++;
  const isCompleted = run.outcome === 'completed' || (proof !== null && isFound());
  if (isCompleted) {
    tally.completed++;
    isWrong ||= proof !== null;
    // twins in which she does not come to it: elsewhere, and under other rules
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
    if (searchTicks === 0) return false;
    const search = createSearch(compiled, { seed, maxTicks: maxTime * TICK_RATE });
    search.advance(searchTicks);
    return search.solutions.length > 0;
  }
}
