import type { FromWorker, JobKind, Progresses, Requests, Results, ToWorker } from './protocol.ts';

/** The part of a Worker that is needed. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  /** Called with every message. */
  onMessage(listener: (message: FromWorker) => void): void;
  onDeath(listener: (reason: string) => void): void;
  terminate(): void;
}

/** How a job ended. */
export type JobEnd<K extends JobKind> =
  | { readonly kind: 'done'; readonly result: Results[K] }
  | { readonly kind: 'cancelled' }
  /** it reached its time limit */
  | { readonly kind: 'gaveUp'; readonly message: string }
  | { readonly kind: 'failed'; readonly message: string };

export interface Job<K extends JobKind> {
  /** Never rejects. */
  readonly end: Promise<JobEnd<K>>;
  /** Cancels it at once: nothing is reported after this. */
  cancel(): void;
}

export interface Workers {
  /** Starts a job or queues it. @param onProgress called with intermediate results */
  start<K extends JobKind>(kind: K, request: Requests[K], onProgress?: (progress: Progresses[K]) => void): Job<K>;
  /** Cancels all jobs and ends the workers. */
  close(): void;
}

export interface WorkersOptions {
  readonly spawn: () => WorkerPort;
  /** Calls back after `ms`. @returns cancels it */
  readonly after: (ms: number, call: () => void) => () => void;
}

/** Searches have a worker of their own, so that they do not delay what is shown during editing. */
const LONG: ReadonlySet<JobKind> = new Set(['solve', 'difficulty', 'grade', 'fix', 'mend', 'accuracy']);

/**
 * Jobs that follow every change must not wait for longer ones, nor for a worker that is restarted because a job could not be
 * cancelled.
 */
const QUICK: ReadonlySet<JobKind> = new Set(['fan', 'check', 'path', 'slack']);

/** A folder of plays takes a while, and must delay neither pictures and proofs nor wait for a search. */
const PLAYS: ReadonlySet<JobKind> = new Set(['plays']);

/**
 * What is already lost is examined for as long as it is shown, and a part of it can take seconds: it must delay nothing else. Runs
 * come and go more often than the level changes, so each of the two has its own worker.
 */
const LOST: ReadonlySet<JobKind> = new Set(['lost']);
const LOSSES: ReadonlySet<JobKind> = new Set(['losses']);

/** Where a selection may stand is sampled for as long as it is shown, and begins again with each change. */
const LEEWAY: ReadonlySet<JobKind> = new Set(['leeway']);

/** Runs that are compared with the shown one follow every change. */
const COMPARED: ReadonlySet<JobKind> = new Set(['trajectory']);

/** A run is kept alive while something is dragged, and must wait for nothing. */
const ALIVE: ReadonlySet<JobKind> = new Set(['retime']);

/** ms after which a job without a time limit of its own is stopped, as a level can be made to take hours */
const MOST: Readonly<Record<JobKind, number | null>> = {
  check: 20_000,
  proofs: 20_000,
  thumbnail: 10_000,
  compare: 60_000,
  fan: 20_000,
  slack: 20_000,
  robustness: 120_000,
  accuracy: 60_000,
  grade: 120_000,
  path: 20_000,
  trajectory: 20_000,
  // these have a time limit of their own or run until they are cancelled
  solve: null,
  difficulty: null,
  fix: null,
  mend: 60_000,
  plays: null,
  lost: null,
  losses: null,
  leeway: null,
  retime: 20_000,
};

/** ms that a worker has to answer a cancel; after that it is in a long step, and is ended */
const PATIENCE = 30;

interface Running {
  readonly id: number;
  readonly kind: JobKind;
  readonly request: unknown;
  readonly onProgress: (progress: never) => void;
  readonly settle: (end: JobEnd<JobKind>) => void;
}

/** One worker and its jobs, in order. */
class Lane {
  private port: WorkerPort | null = null;
  private jobs: Running[] = [];
  private waiting = new Map<number, () => void>();
  /** The current job, and the function that cancels its time limit. */
  private timed: { readonly id: number; readonly stop: () => void } | null = null;

  constructor(private readonly options: WorkersOptions) {}

  give(job: Running): void {
    this.jobs.push(job);
    this.send(job);
    this.time();
  }

  cancel(id: number): void {
    const job = this.jobs.find((other) => other.id === id);
    if (job === undefined) return;
    this.jobs = this.jobs.filter((other) => other !== job);
    job.settle({ kind: 'cancelled' });
    this.time();
    this.port?.postMessage({ type: 'cancel', job: id });
    this.waiting.set(
      id,
      this.options.after(PATIENCE, () => this.renew()),
    );
  }

  close(): void {
    for (const job of this.jobs) job.settle({ kind: 'cancelled' });
    this.jobs = [];
    this.time();
    this.end();
  }

  /** Starts the time limit of the first job, which is the current one. */
  private time(): void {
    const first = this.jobs[0];
    if (first?.id === this.timed?.id) return;
    this.timed?.stop();
    this.timed = null;
    const most = first === undefined ? null : MOST[first.kind];
    if (first === undefined || most === null) return;
    const stop = this.options.after(most, () => {
      this.jobs = this.jobs.filter((other) => other !== first);
      first.settle({ kind: 'gaveUp', message: `work limit: stopped after ${most / 1000} s` });
      this.renew();
      this.time();
    });
    this.timed = { id: first.id, stop };
  }

  private send({ id, kind, request }: Running): void {
    this.port ??= this.open();
    this.port.postMessage({ type: 'start', job: id, kind, request } as ToWorker);
  }

  private open(): WorkerPort {
    const port = this.options.spawn();
    port.onMessage((message) => {
      if (port === this.port) this.hear(message);
    });
    port.onDeath((message) => {
      if (port !== this.port) return;
      const failed = this.jobs;
      this.jobs = [];
      this.time();
      this.end();
      for (const job of failed) job.settle({ kind: 'failed', message });
    });
    return port;
  }

  private hear(message: FromWorker): void {
    this.waiting.get(message.job)?.();
    this.waiting.delete(message.job);
    const job = this.jobs.find(({ id }) => id === message.job);
    if (job === undefined) return;
    if (message.type === 'progress') {
      job.onProgress(message.progress as never);
      return;
    }
    this.jobs = this.jobs.filter((other) => other !== job);
    this.time();
    if (message.type === 'done') job.settle({ kind: 'done', result: message.result as never });
    else if (message.type === 'failed') job.settle({ kind: 'failed', message: message.message });
    else job.settle({ kind: 'cancelled' });
  }

  private end(): void {
    this.port?.terminate();
    this.port = null;
    for (const stop of this.waiting.values()) stop();
    this.waiting.clear();
  }

  /** Starts another worker for the remaining jobs. */
  private renew(): void {
    this.end();
    for (const job of this.jobs) this.send(job);
  }
}

/** The kinds of jobs that have a worker of their own; all others share one. */
const OWN: readonly ReadonlySet<JobKind>[] = [LONG, QUICK, PLAYS, LOST, LOSSES, LEEWAY, COMPARED, ALIVE];

/** Workers for what must not wait for other jobs, started on demand; all other jobs share one. */
export function createWorkers(options: WorkersOptions): Workers {
  const shared = new Lane(options);
  const own = OWN.map((kinds) => ({ kinds, lane: new Lane(options) }));
  let last = 0;
  return {
    start(kind, request, onProgress = () => {}) {
      const id = ++last;
      const lane = own.find(({ kinds }) => kinds.has(kind))?.lane ?? shared;
      const end = new Promise<JobEnd<typeof kind>>((resolve) => {
        lane.give({
          id,
          kind,
          request,
          onProgress: onProgress as (progress: never) => void,
          settle: resolve as (end: JobEnd<JobKind>) => void,
        });
      });
      return { end, cancel: () => lane.cancel(id) };
    },
    close() {
      for (const lane of [shared, ...own.map((one) => one.lane)]) lane.close();
    },
  };
}
