import type { Scene } from '../../engine/index.ts';
import { mineralsNeeded } from '../goal.ts';
import { type Candidate, createReplay, DEFAULT_MAX_TICKS } from '../verified-run.ts';
import { CellSearch, type SearchTask } from './cell-search.ts';
import { Guide } from './guide.ts';
import { type HeatMap, HeatTally } from './heat-map.ts';
import { MineralSet } from './mineral-set.ts';
import { RelaySearch } from './relay-search.ts';
import { Reports } from './reports.ts';
import type { Closest, Effort, Explored, Moment, Search, SearchOptions } from './search.ts';
import { Stages } from './stages.ts';
import { WayMap } from './way-map.ts';

/**
 * The guided search joins in when the plain one has simulated so many ticks. By then almost every level that has a run is solved.
 */
const GUIDED_AFTER = 500_000;

/**
 * The same for the search from border to border: by then three million ticks have been simulated in all. In levels laid out at
 * random it finds next to nothing that the others do not, so it must not take its share from them earlier.
 */
const RELAY_AFTER = 1_750_000;

/** Make the seeds of the other searches differ from that of the plain search. */
const GUIDED_SEED = 0.5;
const RELAY_SEED = 0.25;

/** One of the searches that take turns. */
interface Lane {
  readonly effort: Effort;
  readonly closest: Closest | null;
  readonly heat: HeatMap;
  /** The last tick at which she was seen alive. */
  readonly latest: number;
  /** Simulates a stretch. Returns false when there is nothing to try. */
  step(): boolean;
}

/** A lane, and the ticks that the plain search had simulated when it joined in. */
interface Joined {
  readonly lane: Lane;
  readonly after: number;
}

/**
 * Interleaves a plain search with others that follow the ways to the goal: one that is guided by the distance to go
 * ({@link Guide}), and one that works from border to border ({@link RelaySearch}). The plain one is alone at first. A lane that
 * has joined in takes turns with the others, a stretch at a time, such that all simulate equally many ticks from then on. Which
 * one is next depends on these counts only, so the result does not depend on how `advance` is split.
 */
class LaneSearch implements Search {
  readonly scene: Scene;
  private readonly task: SearchTask;
  private readonly plain: CellSearch;
  private readonly others: Joined[] = [];
  /** The lanes that join in later, the next one first: after how many ticks, and what makes them. */
  private readonly waiting: (readonly [after: number, open: (map: WayMap) => Lane | null])[];
  private map: WayMap | null = null;
  private asked = 0;

  constructor(scene: Scene, options: SearchOptions) {
    const { goal = { minerals: 'any' }, seed = 0, maxTicks = DEFAULT_MAX_TICKS, after = null } = options;
    const reports = new Reports(createReplay(scene, goal, maxTicks));
    this.scene = scene;
    this.task = { scene, needed: mineralsNeeded(goal, scene.minerals.count), maxTicks, after, reports };
    this.plain = new CellSearch(this.task, seed, null);
    const { aims } = new MineralSet(scene, this.task.needed);
    this.waiting = [
      [GUIDED_AFTER, (map) => new CellSearch(this.task, seed + GUIDED_SEED, new Guide(scene, map, aims))],
      [
        RELAY_AFTER,
        (map) => {
          const stages = new Stages(scene, map, aims);
          const { x, y } = scene.level.astronaut;
          // without a border on the way there is nothing to work along
          return aims === 0 && stages.at(x, y, 0) === 0 ? null : new RelaySearch(this.task, seed + RELAY_SEED, stages);
        },
      ],
    ];
  }

  get solutions(): readonly Candidate[] {
    return this.task.reports.solutions;
  }

  get effort(): Effort {
    let { runs, ticks } = this.plain.effort;
    for (const { lane } of this.others) {
      runs += lane.effort.runs;
      ticks += lane.effort.ticks;
    }
    return { runs, ticks };
  }

  get closest(): Closest | null {
    let best = this.plain.closest;
    for (const { lane } of this.others) {
      const { closest } = lane;
      if (closest !== null && (best === null || closest.distance < best.distance)) best = closest;
    }
    return best;
  }

  get explored(): Explored {
    const { plain, others } = this;
    if (others.length === 0) return plain.heat.explored();
    return new HeatTally().explored(plain.heat.explored(), ...others.map(({ lane }) => lane.heat.explored()));
  }

  get exhausted(): boolean {
    return this.plain.exhausted;
  }

  get latest(): number {
    return this.others.reduce((most, { lane }) => Math.max(most, lane.latest), this.plain.latest);
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
    const { plain, others, waiting } = this;
    if (waiting.length > 0 && plain.effort.ticks >= waiting[0][0]) this.join();
    let next: Lane = plain;
    let least = plain.effort.ticks;
    for (const { lane, after } of others) {
      const ticks = after + lane.effort.ticks;
      if (ticks >= least) continue;
      next = lane;
      least = ticks;
    }
    return next.step();
  }

  /** Opens the lane that joins in next, or none where it would be of no use or the level is too large to be mapped. */
  private join(): void {
    const { waiting, scene } = this;
    this.map ??= WayMap.of(scene);
    const [after, open] = waiting[0];
    waiting.splice(0, this.map === null ? waiting.length : 1);
    const lane = this.map === null ? null : open(this.map);
    if (lane !== null) this.others.push({ lane, after });
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
