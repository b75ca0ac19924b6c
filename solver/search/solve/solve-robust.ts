import type { Hold } from '../../../schema/basics/index.ts';
import { createRandom, type Random } from '../../random.ts';
import { Clouds } from './clouds.ts';
import { changeRun, createLocalSearch, type LocalSearch, meanShiftStep, screen, wholeTicks } from './local-search.ts';
import {
  centred,
  certifyCandidate,
  createRobustCandidate,
  isSure,
  makeSure,
  measured,
  polish,
  type RobustCandidate,
  SIGMA,
  standing,
  toSolution,
} from './robust-candidate.ts';
import { isSameWay, mergeSolutions } from './solution.ts';
import { playable, type SolverSession } from './solver-session.ts';

/** The most new runs per round from clouds, and from changes. */
const FROM_CLOUDS = 24;
const FROM_CHANGES = 6;

/** Shares of all ticks that clouds and searches get. Clouds get the most, because what they find is robust from the start. */
const CLOUD_SHARE = 0.5;
const SEARCH_SHARE = 0.15;

/** Ticks for clouds in the first round at least, and between two choices among what they have found. */
const CLOUD_FIRST = 200_000;
const CLOUD_ROUND = 2_000_000;

/** Attempts per mean-shift step in each stage. Half of the runs go on to the next stage. */
const STAGES = [12, 16, 24];
const STEPS = 2;

/**
 * Runs per round that may become candidates. New and changed runs compete separately, because new ones would always lose
 * against changes to the best.
 */
const NEW_FINALISTS = 2;
const CHANGED_FINALISTS = 1;

const CLOUD_FINALISTS = 3;

/** How much more noise the runs of a cloud are screened by than the cloud has. */
const CLOUD_NOISE = 4 / 3;

/** Candidates that are kept. */
const KEPT = 6;

/**
 * The most noise of a local search, ms. It exceeds the noise that judges runs, so that the search sees the obstacles around.
 */
const MOST_SIGMA = 60;

/** Runs that succeed less often fail with some shift by two ticks, so no certificate is tried. */
const LEAST_CERTIFIED = 0.5;

/** Share of all ticks that certificates may take, and the ticks granted at first. */
const CERTIFICATE_SHARE = 0.2;
const FIRST_CERTIFICATE = 2_000_000;

/** Runs with less than this part of the best run's success are not polished. */
const POLISHED = 0.9;

/** Runs are reported when all ticks have grown by this factor since the last report. */
const REPORT_GROWTH = 1.1;

/** A run is no longer polished after this many polishes without a gain. */
const IDLE = 2;

/**
 * Searches for robust runs, the ones with the highest success under timing noise.
 *
 * The work proceeds in rounds. Each collects new runs from three sources: restarted searches ({@link Restarts}), clouds of
 * noisy attempts ({@link Clouds}), and random changes to the best runs so far; the first round begins with the level's own
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
  private readonly clouds: Clouds;
  private reportedAt = 0;
  private localSearches = 0;
  private certificateTicks = 0;

  constructor(session: SolverSession) {
    this.session = session;
    this.clouds = new Clouds(session);
    this.random = createRandom(session.seedOf(0));
  }

  *run(): Generator<void, void> {
    // Publish the first run at once.
    const pending = this.known();
    if (pending.length === 0) {
      const first = yield* this.search(Number.POSITIVE_INFINITY);
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
        this.admit(wholeTicks(local.edges), local.seed);
        yield;
      }
      yield* this.polish();
      // Certificates and clouds take long, so that what is known is reported before.
      this.publishIfDue();
      yield* this.certify();
      if (this.looksPerfect()) {
        this.publish();
        if (this.isPerfect()) return;
      }
      yield* this.admitFromClouds();
      this.publishIfDue();
    }
  }

  /** The given runs that meet the goal. */
  private known(): (readonly Hold[])[] {
    return this.session.known.flatMap((holds) => {
      const run = playable(this.session, holds);
      return run === null ? [] : [run.holds];
    });
  }

  /** Searches until a run is found, or all searches together have simulated `limit` ticks. */
  private *search(limit: number): Generator<void, readonly Hold[] | null> {
    const { restarts } = this.session;
    while (!restarts.exhausted && restarts.effort.ticks < limit) {
      const run = restarts.next();
      yield;
      if (run !== null) return playable(this.session, run.holds)?.holds ?? run.holds;
    }
    return null;
  }

  /** Collects new runs, beginning with the given ones. */
  private *gather(runs: (readonly Hold[])[]): Generator<void, LocalSearch[]> {
    const searched = yield* this.search(SEARCH_SHARE * this.spent);
    if (searched !== null) runs.push(searched);
    // Where she arrives with the button held, the last release is not needed, and one edge less can fail less often.
    for (const holds of [...runs]) {
      const heldOn = playable(this.session, withoutLastRelease(holds, this.session.maxTicks));
      if (heldOn !== null) runs.push(heldOn.holds);
    }
    return runs.map((holds) => this.localSearch(holds));
  }

  /** Lets clouds search until they have had their share, and admits the most robust of the runs that they find. */
  private *admitFromClouds(): Generator<void, void> {
    const { session, clouds } = this;
    const share = Math.max(CLOUD_FIRST, (CLOUD_SHARE / (1 - CLOUD_SHARE)) * (this.spent - clouds.ticks));
    while (clouds.ticks < share) {
      const best = this.candidates.length > 0 ? this.candidates[0].p : 0;
      const known = this.candidates.filter(({ p }) => p >= POLISHED * best).map(({ holds }) => holds);
      const before = clouds.ticks;
      const runs = yield* clouds.harvest(Math.min(CLOUD_ROUND, share - before), best, known, FROM_CLOUDS);
      const seed = session.seedOf(++this.localSearches);
      const sigma = Math.min(SIGMA, CLOUD_NOISE * clouds.noise);
      for (const holds of yield* screen(session, runs, { sigma, finalists: CLOUD_FINALISTS, seed })) {
        this.admit(holds, seed);
        yield;
      }
      if (clouds.ticks === before) return;
    }
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

  private get spent(): number {
    return this.session.trials.ticks + this.session.restarts.effort.ticks;
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

  private *polish(): Generator<void, void> {
    const { session } = this;
    for (const candidate of this.candidates) {
      if (candidate.idle >= IDLE || candidate.p === 1 || candidate.p < POLISHED * this.candidates[0].p) continue;
      polish(session, candidate);
      yield;
    }
    this.sort();
  }

  private *certify(): Generator<void, void> {
    const { session } = this;
    for (const candidate of this.candidates.slice(0, session.count)) {
      if (candidate.p < LEAST_CERTIFIED || candidate.certificate !== 'unknown' || (candidate.idle < IDLE && candidate.p < 1))
        continue;
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

  /** Sorts the candidates, and compares those that may be reported by more attempts until the order holds. */
  private compare(): void {
    for (;;) {
      this.sort();
      const unsure = this.candidates.slice(0, this.session.count).find((candidate) => !isSure(candidate));
      if (unsure === undefined) return;
      makeSure(this.session, unsure);
    }
  }

  private publishIfDue(): void {
    if (this.spent > REPORT_GROWTH * this.reportedAt) this.publish();
  }

  private publish(): void {
    const { session } = this;
    this.compare();
    this.reportedAt = this.spent;
    const solutions = this.candidates.slice(0, session.count).map(toSolution);
    // A published solution stays until another one compares better.
    const merged = mergeSolutions([session.solutions, solutions], { count: session.count });
    session.solutions = merged.map((solution) => (solution.p40 === null ? measured(session, solution) : solution));
  }

  private looksPerfect(): boolean {
    const { candidates } = this;
    const { count } = this.session;
    return (
      candidates.length >= count && candidates.slice(0, count).every(({ p, certificate }) => p === 1 && certificate === 'proved')
    );
  }

  private isPerfect(): boolean {
    return this.looksPerfect() && this.candidates.slice(0, this.session.count).every(isSure);
  }
}

const withoutLastRelease = (holds: readonly Hold[], maxTicks: number): Hold[] =>
  holds.map(([press, release], i) => [press, i === holds.length - 1 ? maxTicks : release]);
