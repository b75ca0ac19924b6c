import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import { type Candidate, createReplay, mineralsNeeded } from '../../verified-run.ts';
import { CellSearch, type SearchTask } from './cell-search.ts';
import { MineralSet } from './cells.ts';
import { Guide } from './guide.ts';
import { HeatTally } from './heat-map.ts';
import { Lingering } from './lingering.ts';
import { Reports } from './records.ts';
import type { Closest, Effort, Explored, Moment, Search, SearchOptions } from './search.ts';

/** Ticks after which the guided search joins in. By then almost every level that has a run is solved. */
const HEAD_START = 500_000;

/** Makes the seed of the guided search another one than that of the plain search. */
const GUIDED_SEED = 0.5;

/**
 * Interleaves two searches: a plain one, and one that is guided along the ways to the goal ({@link Guide}). The plain one is alone
 * at first. Then {@link Lingering} has its few plays. Later the two take turns, a stretch at a time, such that both have simulated
 * equally many ticks since then. What is next depends on these counts only, so the result does not depend on how `advance` is split.
 */
class LaneSearch implements Search {
  readonly scene: Scene;
  private readonly task: SearchTask;
  private readonly seed: number;
  private readonly plain: CellSearch;
  private guided: CellSearch | null = null;
  private lingering: Lingering | null = null;
  private isLingering = false;
  private joined = false;
  private asked = 0;

  constructor(scene: Scene, options: SearchOptions) {
    const { goal = { minerals: 'any' }, seed = 0, maxTicks = maxTicksOf(scene.terms), after = null } = options;
    const reports = new Reports(createReplay(scene, goal, maxTicks));
    this.scene = scene;
    this.task = { scene, needed: mineralsNeeded(goal, scene.minerals.count), maxTicks, after, reports };
    this.seed = seed;
    this.plain = new CellSearch(this.task, seed, null);
  }

  get solutions(): readonly Candidate[] {
    return this.task.reports.solutions;
  }

  get effort(): Effort {
    const { plain, guided, lingering } = this;
    return {
      runs: plain.effort.runs + (guided?.effort.runs ?? 0) + (lingering?.runs ?? 0),
      ticks: plain.effort.ticks + (guided?.effort.ticks ?? 0) + (lingering?.ticks ?? 0),
    };
  }

  get closest(): Closest | null {
    const one = this.plain.closest;
    const other = this.guided?.closest ?? null;
    return one === null || (other !== null && other.distance < one.distance) ? other : one;
  }

  get explored(): Explored {
    const { plain, guided } = this;
    return guided === null ? plain.heat.explored() : new HeatTally().explored(plain.heat.explored(), guided.heat.explored());
  }

  get exhausted(): boolean {
    return this.plain.exhausted;
  }

  get latest(): number {
    return Math.max(this.plain.latest, this.guided?.latest ?? 0);
  }

  moments(count: number): Moment[] {
    return this.plain.moments(count);
  }

  advance(ticks: number): number {
    const before = this.solutions.length;
    this.asked += ticks;
    while (this.effort.ticks < this.asked && this.step());
    return this.solutions.length - before;
  }

  private step(): boolean {
    const { plain } = this;
    if (!this.joined && plain.effort.ticks >= HEAD_START) this.join();
    const { guided, lingering } = this;
    if (this.isLingering && lingering !== null) {
      this.isLingering = lingering.step();
      if (this.isLingering) return true;
    }
    return guided !== null && guided.effort.ticks < plain.effort.ticks - HEAD_START ? guided.step() : plain.step();
  }

  private join(): void {
    this.joined = true;
    const { scene, needed, after, maxTicks, reports } = this.task;
    if (after === null) {
      this.lingering = Lingering.of(scene, maxTicks, reports);
      this.isLingering = this.lingering !== null;
    }
    const guide = Guide.of(scene, new MineralSet(scene, needed).aims);
    if (guide !== null) this.guided = new CellSearch(this.task, this.seed + GUIDED_SEED, guide);
  }
}

/**
 * Creates a search for runs that meet a goal. It simulates nothing before the first call of `advance`.
 * @param scene the compiled level
 * @param options the goal, the seed and the longest run
 * @returns a search at its start
 * @example
 * ```ts
 * import { compile } from 'gravity-quest-toolkit';
 * import { createSearch } from 'gravity-quest-toolkit/solver';
 *
 * const search = createSearch(compile(level), { goal: { minerals: 'all' } });
 * while (search.solutions.length === 0 && search.effort.ticks < 2_000_000) search.advance(50_000);
 * console.log(search.solutions[0]?.holds ?? search.closest);
 * ```
 */
export function createSearch(scene: Scene, options: SearchOptions = {}): Search {
  return new LaneSearch(scene, options);
}
