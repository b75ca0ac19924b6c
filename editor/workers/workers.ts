import type { Job } from './job.ts';

/** The part of a Worker that is needed. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  /** Called with every message. */
  onMessage(listener: (message: FromWorker) => void): void;
  onDeath(listener: (reason: string) => void): void;
  terminate(): void;
}

/** How a job ended. */
export type JobEnd<A> =
  | { readonly kind: 'done'; readonly result: A }
  | { readonly kind: 'cancelled' }
  /** it reached its time limit */
  | { readonly kind: 'gaveUp'; readonly message: string }
  | { readonly kind: 'failed'; readonly message: string };

/** A job that was started. */
export interface Running<A> {
  /** Never rejects. */
  readonly end: Promise<JobEnd<A>>;
  /** Cancels it at once: nothing is reported after this. */
  cancel(): void;
}

export interface Workers {
  /** Starts a job or queues it. @param onProgress called with intermediate results */
  start<Q, A, P>(job: Job<Q, A, P>, request: Q, onProgress?: (progress: P) => void): Running<A>;
  /** Cancels all jobs and ends the workers. */
  close(): void;
}

interface WorkersOptions {
  readonly spawn: () => WorkerPort;
  /** Calls back after `ms`. @returns cancels it */
  readonly after: (ms: number, call: () => void) => () => void;
}

/** ms that a worker has to answer a cancel; after that it is in a long step, and is ended */
const PATIENCE = 30;

interface Task {
  readonly id: number;
  readonly job: Job;
  readonly request: unknown;
  readonly onProgress: (progress: unknown) => void;
  readonly resolve: (end: JobEnd<unknown>) => void;
}

/** One worker and its tasks, in order. */
class Queue {
  private port: WorkerPort | null = null;
  private tasks: Task[] = [];
  private cancelling = new Map<number, () => void>();
  /** The current task, and the function that cancels its time limit. */
  private timed: { readonly id: number; readonly stop: () => void } | null = null;

  constructor(private readonly options: WorkersOptions) {}

  /** How much a task that is given now has to wait for: nothing, the answer to a cancel, or others. */
  get load(): number {
    return 2 * this.tasks.length + Math.min(1, this.cancelling.size);
  }

  give(task: Task): void {
    this.tasks.push(task);
    this.send(task);
    this.time();
  }

  cancel(id: number): void {
    const task = this.remove(id);
    if (task === null) return;
    task.resolve({ kind: 'cancelled' });
    this.port?.postMessage({ type: 'cancel', job: id });
    this.cancelling.set(
      id,
      this.options.after(PATIENCE, () => this.renew()),
    );
  }

  close(): void {
    for (const task of this.tasks) task.resolve({ kind: 'cancelled' });
    this.tasks = [];
    this.time();
    this.end();
  }

  /** @returns null: it is over */
  private remove(id: number): Task | null {
    const task = this.tasks.find((other) => other.id === id) ?? null;
    this.tasks = this.tasks.filter((other) => other !== task);
    this.time();
    return task;
  }

  /** Starts the time limit of the first task, which is the current one. */
  private time(): void {
    const first = this.tasks[0];
    if (first?.id === this.timed?.id) return;
    this.timed?.stop();
    this.timed = null;
    const most = first?.job.most ?? null;
    if (first === undefined || most === null) return;
    const stop = this.options.after(most, () => {
      this.remove(first.id);
      first.resolve({ kind: 'gaveUp', message: `work limit: stopped after ${most / 1000} s` });
      this.renew();
    });
    this.timed = { id: first.id, stop };
  }

  private send({ id, job, request }: Task): void {
    this.port ??= this.open();
    this.port.postMessage({ type: 'start', job: id, kind: job.name, request });
  }

  private open(): WorkerPort {
    const port = this.options.spawn();
    port.onMessage((message) => {
      if (port === this.port) this.hear(message);
    });
    port.onDeath((message) => {
      if (port !== this.port) return;
      // it has died of what was cancelled and not answered, or of the first task; the others have only waited
      const culprit = this.cancelling.size > 0 ? undefined : this.tasks[0];
      if (culprit !== undefined) this.remove(culprit.id);
      this.renew();
      culprit?.resolve({ kind: 'failed', message });
    });
    return port;
  }

  private hear(message: FromWorker): void {
    this.cancelling.get(message.job)?.();
    this.cancelling.delete(message.job);
    if (message.type === 'progress') {
      this.tasks.find(({ id }) => id === message.job)?.onProgress(message.progress);
      return;
    }
    const task = this.remove(message.job);
    if (message.type === 'done') task?.resolve({ kind: 'done', result: message.result });
    else if (message.type === 'failed') task?.resolve({ kind: 'failed', message: message.message });
    else task?.resolve({ kind: 'cancelled' });
  }

  private end(): void {
    this.port?.terminate();
    this.port = null;
    for (const stop of this.cancelling.values()) stop();
    this.cancelling.clear();
  }

  /** Starts another worker for the remaining tasks. */
  private renew(): void {
    this.end();
    for (const task of this.tasks) this.send(task);
  }
}

/**
 * Workers, started on demand and used again. Quick jobs share one, in order; each long one has the worker that is free, or a new one.
 */
export function createWorkers(options: WorkersOptions): Workers {
  const quick = new Queue(options);
  const long: Queue[] = [];
  const freest = (): Queue => {
    const [least] = [...long].sort((a, b) => a.load - b.load);
    if (least !== undefined && least.load < 2) return least;
    const added = new Queue(options);
    long.push(added);
    return added;
  };
  let last = 0;
  return {
    start<Q, A, P>(job: Job<Q, A, P>, request: Q, onProgress: (progress: P) => void = () => {}) {
      const id = ++last;
      const queue = job.lane === 'quick' ? quick : freest();
      const end = new Promise<JobEnd<A>>((resolve) => {
        queue.give({
          id,
          job,
          request,
          onProgress: onProgress as (progress: unknown) => void,
          resolve: resolve as (end: JobEnd<unknown>) => void,
        });
      });
      return { end, cancel: () => queue.cancel(id) };
    },
    close() {
      for (const queue of [quick, ...long]) queue.close();
    },
  };
}

/** Starts a worker of the page. */
export function spawnPageWorker(): WorkerPort {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
  return {
    postMessage: (message) => worker.postMessage(message),
    onMessage: (listener) => worker.addEventListener('message', ({ data }) => listener(data)),
    onDeath(listener) {
      worker.addEventListener('error', ({ message }) => listener(message || 'the worker could not be loaded'));
      worker.addEventListener('messageerror', () => listener('an answer could not be read'));
    },
    terminate: () => worker.terminate(),
  };
}

/** What the page tells a worker. */
export type ToWorker =
  | { readonly type: 'start'; readonly job: number; readonly kind: string; readonly request: unknown }
  | { readonly type: 'cancel'; readonly job: number };

/** What a worker tells the page. */
export type FromWorker =
  | { readonly type: 'progress'; readonly job: number; readonly progress: unknown }
  | { readonly type: 'done'; readonly job: number; readonly result: unknown }
  | { readonly type: 'failed'; readonly job: number; readonly message: string }
  | { readonly type: 'cancelled'; readonly job: number };
