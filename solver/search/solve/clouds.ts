import type { Hold } from '../../../schema/basics/index.ts';
import { createRandom, type Random } from '../../random.ts';
import { type CloudRun, CloudSearch } from './cloud-search.ts';
import { isSameWay } from './solution.ts';
import type { SolverSession } from './solver-session.ts';

/**
 * Standard deviations of the noise of clouds, ms. They are below the noise by which runs are judged, because so few attempts must
 * not all be unlucky. Where the level is so hard that a cloud finds nothing, every other one has less noise.
 */
const SIGMAS = [30, 20, 12, 7];

/** Ticks in the life of one cloud, and of one that only seeks another end for a known run. */
const LIFE = 4_000_000;
const END_LIFE = 400_000;

/** Ticks of clouds that seek other ends, per tick of the others. */
const END_SHARE = 0.5;

/** A cloud abandons paths whose share is lower than the best run's by more than this. */
const MARGIN = 0.15;

/** Clouds that may be started for one harvest. */
const MOST_STARTS = 8;

/**
 * The clouds of a solver, one after the other, each with seed and settings of its own. Some of them begin as one of the best runs
 * does and seek another end for it (a large neighbourhood search).
 */
export class Clouds {
  /** Ticks of all clouds so far. */
  ticks = 0;
  private readonly session: SolverSession;
  private cloud: CloudSearch | null = null;
  private count = 0;
  private whole = 0;
  private sigma = 0;
  private readonly random: Random;
  private endTicks = 0;
  private seeksEnd = false;
  /** Which of the lower noises is next. */
  private less = 0;
  private found = 0;

  constructor(session: SolverSession) {
    this.session = session;
    this.random = createRandom(session.seedOf(499_999));
  }

  /** Standard deviation of the noise of the present cloud, ms. */
  get noise(): number {
    return SIGMAS[this.sigma];
  }

  /**
   * Searches for a while. Yields between small pieces of work.
   * @param ticks how many ticks to simulate, about
   * @param best the success of the best run so far, 0 to 1
   * @param known the best runs so far
   * @param most runs to return at most
   * @returns runs that are not nearly the same, those that kept the most attempts first
   */
  *harvest(ticks: number, best: number, known: readonly (readonly Hold[])[], most: number): Generator<void, (readonly Hold[])[]> {
    const until = this.ticks + ticks;
    const found: CloudRun[] = [];
    for (let starts = 0; this.ticks < until; ) {
      if (this.cloud === null || this.cloud.exhausted || this.cloud.ticks > (this.seeksEnd ? END_LIFE : LIFE)) {
        if (++starts > MOST_STARTS) break;
        this.start(known.filter((holds) => holds.length > 1));
      }
      const cloud = this.cloud as CloudSearch;
      const before = { ticks: cloud.ticks, runs: cloud.runs };
      cloud.step(best - MARGIN);
      this.spend(cloud.ticks - before.ticks, cloud.runs - before.runs);
      const news = cloud.harvest();
      this.found += news.length;
      found.push(...news);
      yield;
    }
    found.sort((a, b) => b.share - a.share || a.holds.length - b.holds.length);
    const different: CloudRun[] = [];
    for (const run of found) {
      if (different.length === most) break;
      if (!different.some(({ holds }) => isSameWay(holds, run.holds))) different.push(run);
    }
    return different.map(({ holds }) => holds);
  }

  private spend(ticks: number, runs: number): void {
    const { trials } = this.session;
    this.ticks += ticks;
    if (this.seeksEnd) this.endTicks += ticks;
    trials.ticks += ticks;
    trials.runs += runs;
  }

  private start(known: readonly (readonly Hold[])[]): void {
    const { scene, goal, maxTicks, seedOf, cloudHeat: heat } = this.session;
    if (this.cloud !== null && !this.seeksEnd) {
      this.less = this.found === 0 ? (this.less % (SIGMAS.length - 1)) + 1 : Math.max(0, this.less - 1);
    }
    this.found = 0;
    const seed = seedOf(500_000 + this.count++);
    this.seeksEnd = known.length > 0 && this.endTicks < END_SHARE * (this.ticks - this.endTicks);
    let beginning: number[] = [];
    if (this.seeksEnd) {
      const edges = known[this.random.below(known.length)].flat();
      beginning = edges.slice(0, 1 + this.random.below(edges.length - 2));
    } else this.sigma = this.whole++ % 2 === 0 ? 0 : this.less;
    this.cloud = new CloudSearch(scene, goal, maxTicks, { sigma: this.noise, seed, heat, beginning });
    this.spend(this.cloud.ticks, 0);
  }
}
