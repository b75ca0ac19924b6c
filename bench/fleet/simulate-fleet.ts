import FlatQueue from 'flatqueue';
import type { Fleet } from './assumptions.ts';

/** What shards cost, s of one core. */
export interface ShardCosts {
  /** The levels of each shard. */
  readonly useful: Float64Array;
  /** The start of its process, and reading what belongs to other shards. */
  readonly overhead: Float64Array;
}

/** What is done about failures and stragglers. */
export interface Policy {
  /**
   * When a shard that has died waits for a slot again: as soon as that is noticed, by whatever runs the shards; or when all others
   * have ended, as who runs what `gq merge --missing` prints.
   */
  readonly rerun: 'at once' | 'after the round';
  /**
   * A running shard gets a second copy on a free slot once it has taken this many times the mean of the shards that ended. The
   * first one counts: both have the same result. null: never.
   */
  readonly patience: number | null;
}

/** What became of a plan; times in s, those of slots summed over all slots. */
export interface Outcome {
  /** Until the last shard has a result. */
  readonly makespan: number;
  /** How often each shard was counted. */
  readonly counted: Uint8Array;
  readonly attempts: number;
  /** Time for which slots were taken, by integrating over the clock. */
  readonly taken: number;
  /** Of this, time for levels, in attempts that count. */
  readonly useful: number;
  /** Of this, for starts and for levels of other shards, in attempts that count. */
  readonly overhead: number;
  /** Of this, what attempts that count took longer because they were slow. */
  readonly slow: number;
  /** Of this, attempts that died or came second. */
  readonly lost: number;
}

/** A shard on a slot. */
interface Attempt {
  readonly shard: number;
  readonly machine: number;
  readonly start: number;
  readonly slowdown: number;
  /** `dead`: nobody has noticed it. */
  state: 'running' | 'dead' | 'over';
  /** Whether a slot is taken by it. */
  hasSlot: boolean;
}

const HOUR = 3600;

/**
 * Simulates a plan on a fleet, event by event: a shard starts on a free slot in the order of their numbers, and ends or dies.
 * @param random numbers in [0, 1)
 */
export function simulateFleet(costs: ShardCosts, fleet: Fleet, policy: Policy, random: () => number): Outcome {
  return new Simulation(costs, fleet, policy, random).run();
}

class Simulation {
  private now = 0;
  private readonly events = new FlatQueue<() => void>();
  /** Shards that wait; those before `next` have started. */
  private waiting: number[];
  private next = 0;
  /** Shards that will wait after a delay. */
  private delayed = 0;
  /** Shards that are done once the round has ended. */
  private missing: number[] = [];
  /** The machines of free slots. */
  private free: number[];
  /** Attempts that nobody knows to be over, in the order of their starts. */
  private readonly known = new Set<Attempt>();
  /** The same, of each shard. */
  private readonly ofShard: Attempt[][];
  private readonly onMachine: Set<Attempt>[];
  private remaining: number;
  private readonly counted: Uint8Array;
  private attempts = 0;
  private slots = 0;
  private taken = 0;
  private useful = 0;
  private overhead = 0;
  private slow = 0;
  private lost = 0;
  /** Wall time of the attempts that counted. */
  private durations = 0;
  private nextLook = 0;

  constructor(
    private readonly costs: ShardCosts,
    private readonly fleet: Fleet,
    private readonly policy: Policy,
    private readonly random: () => number,
  ) {
    const { length } = costs.useful;
    this.remaining = length;
    this.waiting = Array.from({ length }, (_, shard) => shard);
    this.counted = new Uint8Array(length);
    this.ofShard = Array.from({ length }, () => []);
    this.onMachine = Array.from({ length: fleet.machines }, () => new Set());
    this.free = [];
  }

  run(): Outcome {
    for (let machine = 0; machine < this.fleet.machines; machine++) this.join(machine);
    this.startWhatWaits();
    while (this.remaining > 0) {
      const time = this.events.peekValue();
      if (time === undefined) throw new Error('expected an event while shards are missing, found none');
      this.taken += this.slots * (time - this.now);
      this.now = time;
      this.events.pop()!();
      this.startWhatWaits();
    }
    const { now: makespan, counted, attempts, taken, useful, overhead, slow, lost } = this;
    return { makespan, counted, attempts, taken, useful, overhead, slow, lost };
  }

  private after(seconds: number, event: () => void): void {
    // what never happens needs no place in the queue
    if (seconds < Number.POSITIVE_INFINITY) this.events.push(event, this.now + seconds);
  }

  /** s until something that happens so often; infinite if it never does */
  private drawTime(perHour: number): number {
    return perHour === 0 ? Number.POSITIVE_INFINITY : (-Math.log(1 - this.random()) * HOUR) / perHour;
  }

  /** A machine comes, for the first time or again. */
  private join(machine: number): void {
    for (let core = 0; core < this.fleet.cores; core++) this.free.push(machine);
    this.after(this.drawTime(this.fleet.machineDeathsPerHour), () => this.loseMachine(machine));
  }

  private loseMachine(machine: number): void {
    this.free = this.free.filter((other) => other !== machine);
    for (const attempt of [...this.onMachine[machine]]) {
      this.leaveSlot(attempt);
      this.lost += this.now - attempt.start;
      if (attempt.state === 'running') this.die(attempt);
    }
    this.after(this.fleet.repair, () => this.join(machine));
  }

  private startWhatWaits(): void {
    while (this.free.length > 0 && this.next < this.waiting.length) this.start(this.waiting[this.next++]);
    if (this.policy.patience !== null) this.startCopies(this.policy.patience);
  }

  private startCopies(patience: number): void {
    const done = this.counted.length - this.remaining;
    if (done === 0) return;
    const threshold = (patience * this.durations) / done;
    for (const { shard, start } of this.known) {
      if (this.free.length === 0) return;
      if (this.ofShard[shard].length > 1) continue;
      const due = start + threshold;
      if (due > this.now) {
        // those after it have started later
        if (due < this.nextLook || this.nextLook <= this.now) {
          this.nextLook = due;
          this.events.push(() => {}, due);
        }
        return;
      }
      this.start(shard);
    }
  }

  private start(shard: number): void {
    const { stragglers, slowdown, taskDeathsPerHour } = this.fleet;
    const isSlow = stragglers > 0 && this.random() < stragglers;
    const attempt: Attempt = {
      shard,
      machine: this.free.pop()!,
      start: this.now,
      slowdown: isSlow ? slowdown : 1,
      state: 'running',
      hasSlot: true,
    };
    this.attempts++;
    this.slots++;
    this.known.add(attempt);
    this.ofShard[shard].push(attempt);
    this.onMachine[attempt.machine].add(attempt);
    const duration = (this.costs.useful[shard] + this.costs.overhead[shard]) * attempt.slowdown;
    const death = this.drawTime(taskDeathsPerHour);
    if (death >= duration) this.after(duration, () => this.finish(attempt));
    else {
      this.after(death, () => {
        if (attempt.state === 'running') this.die(attempt);
      });
    }
  }

  private die(attempt: Attempt): void {
    attempt.state = 'dead';
    this.after(this.fleet.detection, () => this.notice(attempt));
  }

  /** The death of an attempt is noticed. */
  private notice(attempt: Attempt): void {
    if (attempt.state === 'over') return;
    this.giveUp(attempt);
    const { shard } = attempt;
    if (this.ofShard[shard].length === 0) {
      this.missing.push(shard);
      if (this.policy.rerun === 'at once') this.rerunMissing();
    }
    this.endRound();
  }

  /** With the last attempt of a round, what is missing can be known. */
  private endRound(): void {
    if (this.known.size === 0 && this.next === this.waiting.length && this.delayed === 0) this.rerunMissing();
  }

  private rerunMissing(): void {
    const { missing } = this;
    if (missing.length === 0) return;
    this.missing = [];
    this.delayed += missing.length;
    this.after(this.fleet.restartDelay, () => {
      this.delayed -= missing.length;
      for (const shard of missing) this.waiting.push(shard);
    });
  }

  private finish(attempt: Attempt): void {
    if (attempt.state !== 'running') return;
    const { shard, start, slowdown } = attempt;
    const cost = this.costs.useful[shard] + this.costs.overhead[shard];
    this.leaveSlot(attempt);
    this.free.push(attempt.machine);
    this.useful += this.costs.useful[shard];
    this.overhead += this.costs.overhead[shard];
    this.slow += cost * (slowdown - 1);
    this.durations += this.now - start;
    this.counted[shard]++;
    this.remaining--;
    for (const other of [...this.ofShard[shard]]) this.giveUp(other);
    this.endRound();
  }

  /** Ends an attempt that everyone knows of. If it still has its slot, that was for nothing. */
  private giveUp(attempt: Attempt): void {
    if (attempt.hasSlot) {
      this.leaveSlot(attempt);
      this.free.push(attempt.machine);
      this.lost += this.now - attempt.start;
    }
    attempt.state = 'over';
    this.known.delete(attempt);
    const copies = this.ofShard[attempt.shard];
    copies.splice(copies.indexOf(attempt), 1);
  }

  private leaveSlot(attempt: Attempt): void {
    attempt.hasSlot = false;
    this.slots--;
    this.onMachine[attempt.machine].delete(attempt);
  }
}
