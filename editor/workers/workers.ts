import type { FromWorker, JobKind, Progresses, Requests, Results, ToWorker } from './protocol.ts';

/** What of a Worker is needed. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  /** Called with every message, and with `failed` for every job when the worker dies. */
  onMessage(listener: (message: FromWorker) => void): void;
  onDeath(listener: (reason: string) => void): void;
  terminate(): void;
}

/** How a job came to its end. */
export type JobEnd<K extends JobKind> =
  | { readonly kind: 'done'; readonly result: Results[K] }
  | { readonly kind: 'cancelled' }
  /** It took more work than anybody is to wait for. */
  | { readonly kind: 'gaveUp'; readonly message: string }
  | { readonly kind: 'failed'; readonly message: string };

export interface Job<K extends JobKind> {
  /** Never rejects. */
  readonly end: Promise<JobEnd<K>>;
  /** Ends it at once: nothing is reported after this. */
  cancel(): void;
}

export interface Workers {
  /** Starts a job, or puts it behind those that wait. @param onProgress what it has so far */
  start<K extends JobKind>(kind: K, request: Requests[K], onProgress?: (progress: Progresses[K]) => void): Job<K>;
  /** Cancels everything and ends the workers. */
  close(): void;
}

export interface WorkersOptions {
  readonly spawn: () => WorkerPort;
  /** Calls back after so many ms. @returns takes the request back */
  readonly after: (ms: number, call: () => void) => () => void;
}

/** Searches would keep what is shown while one edits waiting: they have a worker of their own. */
const LONG: ReadonlySet<JobKind> = new Set(['solve', 'difficulty', 'generate', 'accuracy']);

/** What follows every change must not wait for what takes longer, nor for a worker that is begun anew because that could not be cancelled. */
const QUICK: ReadonlySet<JobKind> = new Set(['fan', 'check']);

/** What nobody has set a time for is given up after so long, ms: a level can be made so that it takes hours. */
const MOST: Readonly<Record<JobKind, number | null>> = {
  check: 20_000,
  proofs: 20_000,
  thumbnail: 10_000,
  fan: 20_000,
  robustness: 120_000,
  accuracy: 60_000,
  // these have a time of their own or go on until they are stopped
  solve: null,
  difficulty: null,
  generate: null,
};

/** A worker that has not answered a cancel by then is in the middle of a long step: it is ended, ms. */
const PATIENCE = 30;

interface Running {
  readonly id: number;
  readonly kind: JobKind;
  readonly request: unknown;
  readonly onProgress: (progress: never) => void;
  readonly settle: (end: JobEnd<JobKind>) => void;
}

/** One worker and the jobs that were given to it, in order. */
class Lane {
  private port: WorkerPort | null = null;
  private jobs: Running[] = [];
  private waiting = new Map<number, () => void>();
  /** The job that is being done, and what takes back that it is given up. */
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

  /** The first of the jobs is being done: it has so long from now on. */
  private time(): void {
    const first = this.jobs[0];
    if (first?.id === this.timed?.id) return;
    this.timed?.stop();
    this.timed = null;
    const most = first === undefined ? null : MOST[first.kind];
    if (first === undefined || most === null) return;
    const stop = this.options.after(most, () => {
      this.jobs = this.jobs.filter((other) => other !== first);
      first.settle({ kind: 'gaveUp', message: `work limit: it was given up after ${most / 1000} s` });
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

  /** Another worker for the jobs that are left. */
  private renew(): void {
    this.end();
    for (const job of this.jobs) this.send(job);
  }
}

/** Workers for long, short and quick jobs; started when they are first needed. */
export function createWorkers(options: WorkersOptions): Workers {
  const lanes = { long: new Lane(options), short: new Lane(options), quick: new Lane(options) };
  let last = 0;
  return {
    start(kind, request, onProgress = () => {}) {
      const id = ++last;
      const lane = LONG.has(kind) ? lanes.long : QUICK.has(kind) ? lanes.quick : lanes.short;
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
      lanes.long.close();
      lanes.short.close();
      lanes.quick.close();
    },
  };
}
