import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Job, Running, Workers } from '../../workers/index.ts';

/** How a question waits before it asks a worker. */
export type Wait =
  /** once nothing that it depends on has changed for so many ms, and the page has shown it; then what was asked before is dropped */
  | { readonly rest: number }
  /** every so many ms at most, one request after the other: it follows a drag, and each answer is taken although the next is due */
  | { readonly pace: number };

/** Where questions are asked: the page, or what stands for it in a test. */
export interface Desk {
  readonly workers: Pick<Workers, 'start'>;
  /** Calls back once the page has been at rest for `ms`. @returns cancels it */
  readonly afterRest: (ms: number, call: () => void) => () => void;
  /** Calls back after `ms`. @returns cancels it */
  readonly after: (ms: number, call: () => void) => () => void;
}

/** How far a question has come. */
export interface Asked<O, A, P = never> {
  /**
   * `idle`: nothing is asked. `waiting`: the page does not rest yet. `nothing`: there is nothing to find out. `failed`: also if the
   * worker died or gave up. `stopped`: on demand, and what is known stays.
   */
  readonly phase: 'idle' | 'waiting' | 'nothing' | 'asking' | 'stopped' | 'failed' | 'done';
  /** What it is about. */
  readonly of: O | null;
  /** What was reported last; null: nothing yet. */
  readonly progress: P | null;
  readonly answer: A | null;
  /** Why it failed. */
  readonly message: string | null;
  /** Whether it failed as it took too much work. */
  readonly gaveUp: boolean;
}

/** A question of the page to a worker. */
export interface Question<O, A, P = never> {
  readonly store: StoreApi<Asked<O, A, P>>;
  /** Asks now, in place of what was asked before. @param hear called with all news of this question, until another is asked */
  ask(of: O, hear?: (now: Asked<O, A, P>) => void): void;
  /** Cancels it, and keeps what is known. */
  stop(): void;
  /** Cancels it, and forgets what is known. */
  forget(): void;
  /** Cancels it for good; its store stays as it is. */
  close(): void;
}

/** What a question is. */
export interface QuestionRecord<O, Q, A, P, F> {
  readonly job: Job<Q, A, P>;
  /** What the worker is asked; null: there is nothing to find out. */
  readonly request: (of: O) => Q | null;
  /** How it follows the page; left out: it is asked on demand. */
  readonly follows?: Follows<F, O>;
}

interface Follows<F, O> {
  readonly wait: Wait;
  /** What it is about at the moment; null: it is not asked. @param asked what it is about so far */
  readonly of: (from: F, asked: O | null) => O | null;
  /** Whether an answer to the one is an answer to the other. */
  readonly same: (asked: O, now: O) => boolean;
  /** Calls back when something changes that `of` depends on. */
  readonly on: (from: F) => readonly ((look: () => void) => () => void)[];
}

const IDLE: Asked<never, never> = { phase: 'idle', of: null, progress: null, answer: null, message: null, gaveUp: false };

/** Defines a question. @returns asks it, for as long as what it returns is not closed; without `from` on demand alone */
export const question =
  <O, Q, A, P, F = void>({ job, request, follows }: QuestionRecord<O, Q, A, P, F>) =>
  ({ workers, afterRest, after }: Desk, from: F | null): Question<O, A, P> => {
    const store = createStore<Asked<O, A, P>>(() => IDLE);
    let running: Running<A> | null = null;
    let waiting: (() => void) | null = null;
    /** Whether nothing was asked yet. */
    let isFirst = true;

    const drop = () => {
      waiting?.();
      waiting = null;
      const dropped = running;
      running = null;
      dropped?.cancel();
    };
    const forget = () => {
      drop();
      if (store.getState().phase !== 'idle') store.setState(IDLE, true);
    };
    const ask = (of: O, hear: (now: Asked<O, A, P>) => void = () => {}) => {
      drop();
      isFirst = false;
      const asked = request(of);
      store.setState({ ...IDLE, of, phase: asked === null ? 'nothing' : 'asking' }, true);
      if (asked === null) return;
      const mine = workers.start(job, asked, (progress) => {
        if (running === mine) tell({ progress });
      });
      running = mine;
      const tell = (news: Partial<Asked<O, A, P>>) => {
        const now = { ...store.getState(), ...news };
        store.setState(now, true);
        hear(now);
      };
      void mine.end.then((end) => {
        if (running !== mine) return;
        running = null;
        if (end.kind === 'done') tell({ phase: 'done', answer: end.result });
        else if (end.kind === 'cancelled') store.setState({ phase: 'stopped' });
        else tell({ phase: 'failed', message: end.message, gaveUp: end.kind === 'gaveUp' });
        look();
      });
    };

    const begin = () => {
      waiting = null;
      const now = from === null ? null : (follows?.of(from, store.getState().of) ?? null);
      if (now === null) forget();
      else ask(now);
    };
    const look = () => {
      if (follows === undefined || from === null) return;
      const { wait, of, same } = follows;
      const known = store.getState().of;
      const now = of(from, known);
      if (now === null) forget();
      else if (known !== null && same(known, now)) return;
      else if ('rest' in wait) {
        drop();
        store.setState({ ...IDLE, phase: 'waiting', of: now }, true);
        waiting = afterRest(wait.rest, begin);
      } else if (running === null) waiting ??= after(isFirst ? 0 : wait.pace, begin);
    };
    look();
    const stops = from === null ? [] : (follows?.on(from).map((subscribe) => subscribe(look)) ?? []);
    return {
      store,
      ask,
      forget,
      stop() {
        drop();
        const { phase } = store.getState();
        if (phase === 'asking' || phase === 'waiting') store.setState({ phase: 'stopped' });
      },
      close() {
        for (const stop of stops) stop();
        drop();
      },
    };
  };

/** A question on demand alone: the worker is asked what it is about. */
export const onDemand = <Q, A, P>(job: Job<Q, A, P>) => question({ job, request: (of: Q) => of });

/** A question that was asked once. */
export interface AskedOnce<O, A, P> {
  /** How it ended: `stopped` if it was stopped. Never rejects. */
  readonly end: Promise<Asked<O, A, P>>;
  stop(): void;
}

/** Asks a question once. @param hear called with all news */
export function askOnce<O, A, P>(
  ask: (desk: Desk, from: null) => Question<O, A, P>,
  desk: Desk,
  of: O,
  hear?: (now: Asked<O, A, P>) => void,
): AskedOnce<O, A, P> {
  const own = ask(desk, null);
  const end = new Promise<Asked<O, A, P>>((resolve) => {
    own.store.subscribe((now) => now.phase !== 'asking' && resolve(now));
  });
  own.ask(of, hear);
  return { end, stop: own.stop };
}
