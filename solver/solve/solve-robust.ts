import type { Hold } from '../../schema/index.ts';
import { createRandom, type Random } from '../random.ts';
import { type Basin, climb, createBasin, holdsOf } from './basin.ts';
import { changeRun } from './change-run.ts';
import { CloudSearch } from './cloud-search.ts';
import { type Desk, playable } from './desk.ts';
import { centred, certifyElite, createElite, type Elite, polish, standing, toSolution } from './elite.ts';
import { isSameWay, mergeSolutions } from './merge-solutions.ts';

/** New runs a round, from each source. Clouds bring the most: few, but runs that forgive from the start. */
const FROM_SEARCH = 1;
const FROM_CLOUD = 8;
const FROM_CHANGES = 6;

/** Executions a climbing step takes, stage after stage: half of the runs go on to the next. */
const STAGES = [12, 16, 24];
const STEPS = 2;

/** Runs of a round that may join the elite: new ones and changed ones race apart, or none would ever be new. */
const NEW_FINALISTS = 2;
const CHANGED_FINALISTS = 1;

/** Runs in the elite. */
const KEPT = 6;

/** Most noise a run climbs with, ms: more than it is judged by, so that it sees the walls around. */
const MOST_SIGMA = 60;

/** Ticks a cloud may take in one round: more with every round, so that what is easy is soon there; and in all. */
const CLOUD_FIRST_ROUND = 50_000;
const CLOUD_ROUND = 800_000;
const CLOUD_LIFE = 5_000_000;

/** The cloud leaves ways that have lost so much more than the best run. */
const CLOUD_MARGIN = 0.15;

/** Share of all ticks that certificates may take, and what they may take at first. */
const CERTIFICATE_SHARE = 0.2;
const FIRST_CERTIFICATE = 2_000_000;

/** Polishes without gain after which a run stands where it is. */
const IDLE = 2;

/**
 * Runs that forgive: rounds of many new runs, from plain searches, from clouds of noisy executions and from changes to the
 * best so far. They climb a little, the better half climbs on, and the last ones join the elite. Yields between small
 * pieces of work; ends when nothing can get better.
 */
export class RobustWork {
  private readonly desk: Desk;
  private readonly random: Random;
  private elites: Elite[] = [];
  private cloud: CloudSearch | null = null;
  private clouds = 0;
  private rounds = 0;
  private basins = 0;
  private certificateTicks = 0;

  constructor(desk: Desk) {
    this.desk = desk;
    this.random = createRandom(desk.seedOf(0));
  }

  *run(): Generator<void, void> {
    // whatever comes first is shown at once
    const pending = this.known();
    if (pending.length === 0) {
      const first = yield* this.search();
      if (first === null) return;
      pending.push(first);
    }
    for (const holds of pending) this.admit(holds, 0);
    this.publish();
    for (;;) {
      const found = yield* this.gather(pending.splice(0));
      const changed = this.change();
      yield* this.race(found, NEW_FINALISTS);
      yield* this.race(changed, CHANGED_FINALISTS);
      for (const basin of [...found, ...changed]) {
        for (let i = 0; i < 3; i++) {
          climb(this.desk.trials, basin, 32, MOST_SIGMA);
          yield;
        }
        this.admit(holdsOf(basin.edges), basin.seed);
        yield;
      }
      yield* this.improve();
      this.publish();
      if (this.isPerfect()) return;
    }
  }

  /** The runs to start from that meet the goal. */
  private known(): (readonly Hold[])[] {
    return this.desk.known.flatMap((holds) => {
      const run = playable(this.desk, holds);
      return run === null ? [] : [run.holds];
    });
  }

  private *search(): Generator<void, readonly Hold[] | null> {
    const { restarts } = this.desk;
    while (!restarts.exhausted) {
      const run = restarts.next();
      yield;
      if (run !== null) return playable(this.desk, run.holds)?.holds ?? run.holds;
    }
    return null;
  }

  /** New runs, after those given. */
  private *gather(runs: (readonly Hold[])[]): Generator<void, Basin[]> {
    while (runs.length < FROM_SEARCH) {
      const holds = yield* this.search();
      if (holds === null) break;
      runs.push(holds);
    }
    // a release less can only fail less, where she gets there without it
    for (const holds of [...runs]) {
      const heldOn = playable(this.desk, withoutLastRelease(holds, this.desk.maxTicks));
      if (heldOn !== null) runs.push(heldOn.holds);
    }
    runs.push(...(yield* this.harvest()));
    return runs.map((holds) => this.basin(holds));
  }

  private change(): Basin[] {
    const { random } = this;
    const changeable = this.elites.filter(({ holds }) => holds.length > 0);
    if (changeable.length === 0) return [];
    return Array.from({ length: FROM_CHANGES }, () =>
      this.basin(changeRun(changeable[random.below(changeable.length)].holds, random)),
    );
  }

  private basin(holds: readonly Hold[]): Basin {
    return createBasin(holds, this.desk.seedOf(++this.basins));
  }

  private *harvest(): Generator<void, (readonly Hold[])[]> {
    const { desk } = this;
    const best = this.elites.length > 0 ? this.elites[0].p : 0;
    if (this.cloud === null || this.cloud.exhausted || this.cloud.ticks > CLOUD_LIFE) {
      this.cloud = new CloudSearch(desk.scene, desk.goal, desk.maxTicks, desk.seedOf(500_000 + this.clouds++), desk.cloudHeat);
    }
    const { cloud } = this;
    const until = cloud.ticks + Math.min(CLOUD_ROUND, CLOUD_FIRST_ROUND * ++this.rounds);
    while (cloud.ticks < until && !cloud.exhausted) {
      const { ticks, runs } = cloud;
      cloud.step(best - CLOUD_MARGIN);
      desk.trials.ticks += cloud.ticks - ticks;
      desk.trials.runs += cloud.runs - runs;
      yield;
    }
    return cloud
      .harvest()
      .slice(0, FROM_CLOUD)
      .map(({ holds }) => holds);
  }

  /** All climb a little, the better half climbs on, until no more than so many are left in the batch. */
  private *race(batch: Basin[], finalists: number): Generator<void, void> {
    for (let stage = 0; batch.length > finalists; stage++) {
      const samples = STAGES[Math.min(stage, STAGES.length - 1)];
      for (const basin of batch) {
        for (let i = 0; i < STEPS; i++) {
          climb(this.desk.trials, basin, samples, MOST_SIGMA);
          yield;
        }
      }
      batch.sort((a, b) => b.width - a.width);
      batch.length = Math.max(finalists, Math.ceil(batch.length / 2));
    }
  }

  private admit(holds: readonly Hold[], seed: number): void {
    const elite = createElite(this.desk, holds, seed);
    if (elite !== null) this.keep(elite);
  }

  private keep(elite: Elite): void {
    this.elites.push(elite);
    this.sort();
  }

  /** Best first, of each way the best, no more than are kept. */
  private sort(): void {
    const { elites } = this;
    elites.sort((a, b) => standing(b) - standing(a) || a.holds.length - b.holds.length || a.candidate.tick - b.candidate.tick);
    const different = elites.filter((elite, i) => !elites.slice(0, i).some(({ holds }) => isSameWay(holds, elite.holds)));
    this.elites = different.slice(0, Math.max(KEPT, 2 * this.desk.count));
  }

  private *improve(): Generator<void, void> {
    const { desk } = this;
    for (const elite of this.elites) {
      if (elite.idle >= IDLE || elite.p === 1 || elite.p < this.elites[0].p - 0.25) continue;
      polish(desk, elite);
      yield;
    }
    this.sort();
    for (const elite of this.elites.slice(0, desk.count)) {
      if (elite.certificate !== 'unknown' || (elite.idle < IDLE && elite.p < 1)) continue;
      const { ticks } = desk.trials;
      const allowed = FIRST_CERTIFICATE + CERTIFICATE_SHARE * (ticks + desk.restarts.effort.ticks) - this.certificateTicks;
      elite.certificate = yield* certifyElite(desk, elite, allowed);
      const moved = elite.certificate === 'refuted' ? centred(desk, elite) : null;
      if (moved !== null) {
        moved.certificate = yield* certifyElite(desk, moved, allowed);
        if (moved.certificate === 'proved') this.keep(moved);
      }
      this.certificateTicks += desk.trials.ticks - ticks;
    }
    this.sort();
  }

  private publish(): void {
    const { desk } = this;
    const solutions = this.elites.slice(0, Math.max(1, desk.count)).map((elite) => toSolution(desk, elite));
    // what was published once stays until something is measured to be better
    desk.solutions = mergeSolutions([desk.solutions, solutions], { count: desk.count });
  }

  private isPerfect(): boolean {
    const { solutions, count } = this.desk;
    return solutions.length >= count && solutions.every(({ p40, certified }) => p40?.p === 1 && certified);
  }
}

const withoutLastRelease = (holds: readonly Hold[], maxTicks: number): Hold[] =>
  holds.map(([press, release], i) => [press, i === holds.length - 1 ? maxTicks : release]);
