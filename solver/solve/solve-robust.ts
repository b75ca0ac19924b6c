import type { Hold } from '../../schema/basics/index.ts';
import { createRandom, type Random } from '../random.ts';
import { changeRun } from './change-run.ts';
import { CloudSearch } from './cloud-search.ts';
import { createLocalSearch, holdsOf, type LocalSearch, meanShiftStep } from './local-search.ts';
import { isSameWay, mergeSolutions } from './merge-solutions.ts';
import {
  centred,
  certifyCandidate,
  createRobustCandidate,
  polish,
  type RobustCandidate,
  standing,
  toSolution,
} from './robust-candidate.ts';
import { playable, type SolverSession } from './solver-session.ts';

/** New runs per round from each source. Clouds contribute the most, because what they find is robust from the start. */
const FROM_SEARCH = 1;
const FROM_CLOUD = 8;
const FROM_CHANGES = 6;

/** Attempts per mean-shift step in each stage. Half of the runs go on to the next stage. */
const STAGES = [12, 16, 24];
const STEPS = 2;

/**
 * Runs per round that may become candidates. New and changed runs compete separately, because new ones would always lose
 * against changes to the best.
 */
const NEW_FINALISTS = 2;
const CHANGED_FINALISTS = 1;

/** Candidates that are kept. */
const KEPT = 6;

/**
 * The most noise of a local search, ms. It exceeds the noise that judges runs, so that the search sees the obstacles around.
 */
const MOST_SIGMA = 60;

/**
 * Ticks for clouds: in the first round, at most in a later round (the limit grows with each round, so that easy levels are done
 * soon), and in the life of one cloud.
 */
const CLOUD_FIRST_ROUND = 50_000;
const CLOUD_ROUND = 800_000;
const CLOUD_LIFE = 5_000_000;

/** A cloud abandons paths whose share is lower than the best run's by more than this. */
const CLOUD_MARGIN = 0.15;

/** Share of all ticks that certificates may take, and the ticks granted at first. */
const CERTIFICATE_SHARE = 0.2;
const FIRST_CERTIFICATE = 2_000_000;

/** A run is no longer polished after this many polishes without a gain. */
const IDLE = 2;

/**
 * Searches for robust runs, the ones with the highest success under timing noise.
 *
 * The work proceeds in rounds. Each collects new runs from three sources: restarted searches ({@link Restarts}), clouds of
 * noisy attempts ({@link CloudSearch}), and random changes to the best runs so far; the first round begins with the level's own
 * runs. Every new run takes a few mean-shift steps, which move its edges to the mean of the attempts that succeed and never
 * lower the probability of success. After each stage the worse half drops out (successive halving). The survivors join the
 * candidates, which are polished further.
 *
 * Candidates are compared on the same noise, and what is reported is measured on other noise, because the luckiest of many
 * samples is not the best run. The best candidates get a certificate if it is not too expensive.
 *
 * The work yields between small pieces, and ends when nothing can get better.
 */
export class RobustWork {
  private readonly session: SolverSession;
  private readonly random: Random;
  private candidates: RobustCandidate[] = [];
  private cloud: CloudSearch | null = null;
  private clouds = 0;
  private rounds = 0;
  private localSearches = 0;
  private certificateTicks = 0;

  constructor(session: SolverSession) {
    this.session = session;
    this.random = createRandom(session.seedOf(0));
  }

  *run(): Generator<void, void> {
    // Publish the first run at once.
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
      for (const local of [...found, ...changed]) {
        for (let i = 0; i < 3; i++) {
          meanShiftStep(this.session.trials, local, 32, MOST_SIGMA);
          yield;
        }
        this.admit(holdsOf(local.edges), local.seed);
        yield;
      }
      yield* this.improve();
      this.publish();
      if (this.isPerfect()) return;
    }
  }

  /** The given runs that meet the goal. */
  private known(): (readonly Hold[])[] {
    return this.session.known.flatMap((holds) => {
      const run = playable(this.session, holds);
      return run === null ? [] : [run.holds];
    });
  }

  private *search(): Generator<void, readonly Hold[] | null> {
    const { restarts } = this.session;
    while (!restarts.exhausted) {
      const run = restarts.next();
      yield;
      if (run !== null) return playable(this.session, run.holds)?.holds ?? run.holds;
    }
    return null;
  }

  /** Collects new runs, beginning with the given ones. */
  private *gather(runs: (readonly Hold[])[]): Generator<void, LocalSearch[]> {
    while (runs.length < FROM_SEARCH) {
      const holds = yield* this.search();
      if (holds === null) break;
      runs.push(holds);
    }
    // Where she arrives with the button held, the last release is not needed, and one edge less can fail less often.
    for (const holds of [...runs]) {
      const heldOn = playable(this.session, withoutLastRelease(holds, this.session.maxTicks));
      if (heldOn !== null) runs.push(heldOn.holds);
    }
    runs.push(...(yield* this.harvest()));
    return runs.map((holds) => this.localSearch(holds));
  }

  private change(): LocalSearch[] {
    const { random } = this;
    const changeable = this.candidates.filter(({ holds }) => holds.length > 0);
    if (changeable.length === 0) return [];
    return Array.from({ length: FROM_CHANGES }, () =>
      this.localSearch(changeRun(changeable[random.below(changeable.length)].holds, random)),
    );
  }

  private localSearch(holds: readonly Hold[]): LocalSearch {
    return createLocalSearch(holds, this.session.seedOf(++this.localSearches));
  }

  private *harvest(): Generator<void, (readonly Hold[])[]> {
    const { session } = this;
    const best = this.candidates.length > 0 ? this.candidates[0].p : 0;
    if (this.cloud === null || this.cloud.exhausted || this.cloud.ticks > CLOUD_LIFE) {
      this.cloud = new CloudSearch(
        session.scene,
        session.goal,
        session.maxTicks,
        session.seedOf(500_000 + this.clouds++),
        session.cloudHeat,
      );
    }
    const { cloud } = this;
    const until = cloud.ticks + Math.min(CLOUD_ROUND, CLOUD_FIRST_ROUND * ++this.rounds);
    while (cloud.ticks < until && !cloud.exhausted) {
      const { ticks, runs } = cloud;
      cloud.step(best - CLOUD_MARGIN);
      session.trials.ticks += cloud.ticks - ticks;
      session.trials.runs += cloud.runs - runs;
      yield;
    }
    return cloud
      .harvest()
      .slice(0, FROM_CLOUD)
      .map(({ holds }) => holds);
  }

  /**
   * Successive halving: all runs take a few steps and the better half goes on, until no more than `finalists` are left in the
   * batch.
   */
  private *race(batch: LocalSearch[], finalists: number): Generator<void, void> {
    for (let stage = 0; batch.length > finalists; stage++) {
      const samples = STAGES[Math.min(stage, STAGES.length - 1)];
      for (const local of batch) {
        for (let i = 0; i < STEPS; i++) {
          meanShiftStep(this.session.trials, local, samples, MOST_SIGMA);
          yield;
        }
      }
      batch.sort((a, b) => b.width - a.width);
      batch.length = Math.max(finalists, Math.ceil(batch.length / 2));
    }
  }

  private admit(holds: readonly Hold[], seed: number): void {
    const candidate = createRobustCandidate(this.session, holds, seed);
    if (candidate !== null) this.keep(candidate);
  }

  private keep(candidate: RobustCandidate): void {
    this.candidates.push(candidate);
    this.sort();
  }

  /** Sorts the candidates, best first, and keeps only the best of similar runs and no more than are needed. */
  private sort(): void {
    const { candidates } = this;
    candidates.sort((a, b) => standing(b) - standing(a) || a.holds.length - b.holds.length || a.verified.tick - b.verified.tick);
    const different = candidates.filter(
      (candidate, i) => !candidates.slice(0, i).some(({ holds }) => isSameWay(holds, candidate.holds)),
    );
    this.candidates = different.slice(0, Math.max(KEPT, 2 * this.session.count));
  }

  private *improve(): Generator<void, void> {
    const { session } = this;
    for (const candidate of this.candidates) {
      if (candidate.idle >= IDLE || candidate.p === 1 || candidate.p < this.candidates[0].p - 0.25) continue;
      polish(session, candidate);
      yield;
    }
    this.sort();
    for (const candidate of this.candidates.slice(0, session.count)) {
      if (candidate.certificate !== 'unknown' || (candidate.idle < IDLE && candidate.p < 1)) continue;
      const { ticks } = session.trials;
      const allowed = FIRST_CERTIFICATE + CERTIFICATE_SHARE * (ticks + session.restarts.effort.ticks) - this.certificateTicks;
      candidate.certificate = yield* certifyCandidate(session, candidate, allowed);
      const moved = candidate.certificate === 'refuted' ? centred(session, candidate) : null;
      if (moved !== null) {
        moved.certificate = yield* certifyCandidate(session, moved, allowed);
        if (moved.certificate === 'proved') this.keep(moved);
      }
      this.certificateTicks += session.trials.ticks - ticks;
    }
    this.sort();
  }

  private publish(): void {
    const { session } = this;
    const solutions = this.candidates.slice(0, Math.max(1, session.count)).map((candidate) => toSolution(session, candidate));
    // A published solution stays until another one measures better.
    session.solutions = mergeSolutions([session.solutions, solutions], { count: session.count });
  }

  private isPerfect(): boolean {
    const { solutions, count } = this.session;
    return solutions.length >= count && solutions.every(({ p40, certified }) => p40?.p === 1 && certified);
  }
}

const withoutLastRelease = (holds: readonly Hold[], maxTicks: number): Hold[] =>
  holds.map(([press, release], i) => [press, i === holds.length - 1 ? maxTicks : release]);
