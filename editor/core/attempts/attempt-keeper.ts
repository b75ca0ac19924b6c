import { createStore, type StoreApi } from 'zustand/vanilla';
import { isQuota } from '../journal/index.ts';
import type { Move } from '../versions/index.ts';
import { type AttemptStore, createMemoryAttempts } from './attempt-store.ts';
import type { Attempts } from './attempts.ts';

type Work = () => Promise<unknown>;

/** Keeps the attempts at levels, so that they outlive the page. */
export interface AttemptKeeper {
  /** Why attempts are not kept, and what to do; null: they are. */
  readonly trouble: StoreApi<string | null>;
  /**
   * Adds the attempts of earlier pages at a level, and keeps those that are made from now on, also once the level is closed: a play
   * may end after it. Call it again when the level is opened again.
   * @param place a name of the level
   */
  follow(place: string, attempts: Attempts): void;
  /** Levels got other places: they were renamed, deleted or restored. */
  moved(moves: readonly Move[]): void;
  /** The browser's database answers after all: from now on attempts are kept there. */
  adopt(store: AttemptStore): void;
}

const MISSING =
  'This browser stores no data for this page (a private window?), so attempts last as long as this page: save what you want to keep.';

function troubleInWords(error: unknown): string {
  if (isQuota(error))
    return 'The browser has no room left: new attempts last as long as this page. Free some space on the disk, or discard attempts.';
  const why = error instanceof Error ? error.message : String(error);
  return `The browser could not keep the attempts: ${why}. It is tried again with the next one.`;
}

/** ms after which what failed is tried again */
const RETRY = 30_000;

/**
 * @param store where attempts are kept; null if the browser has no database
 * @param after calls back after `ms`; @returns cancels it
 */
export function createAttemptKeeper(
  store: AttemptStore | null,
  after: (ms: number, call: () => void) => () => void,
): AttemptKeeper {
  let kept = store ?? createMemoryAttempts();
  let isLasting = store !== null;
  const trouble = createStore<string | null>(() => (isLasting ? null : MISSING));
  const followed = new Map<Attempts, Followed>();
  let cancelRetry = () => {};
  /** What failed, oldest first: it is tried again whenever the database answers. */
  let failed: Work[] = [];
  const report = (error: unknown) =>
    trouble.setState(error === null ? (isLasting ? null : MISSING) : troubleInWords(error), true);
  const work = async (act: Work): Promise<void> => {
    failed = [...failed, act];
    try {
      // the new work first: an older one may fail forever
      for (const one of [act, ...failed.slice(0, -1)]) {
        await one();
        failed = failed.filter((other) => other !== one);
      }
      report(null);
    } catch (error) {
      report(error);
      cancelRetry();
      cancelRetry = after(RETRY, tryAgain);
    }
  };
  // One queue for all levels and their moves: a list that was asked for before a move is found at its old place.
  let last: Promise<void> = Promise.resolve();
  const inTurn = (act: Work): void => {
    last = last.then(() => work(act));
  };
  const tryAgain = () => inTurn(async () => {});
  return {
    trouble,
    follow(place, attempts) {
      const known = followed.get(attempts);
      if (known === undefined) followed.set(attempts, new Followed(place, attempts, () => kept, inTurn));
      else known.openedAgain(place);
    },
    moved: (moves) =>
      inTurn(async () => {
        await kept.move(moves);
        for (const one of followed.values()) one.moved(moves);
      }),
    adopt(found) {
      if (isLasting) return;
      isLasting = true;
      kept = found;
      for (const one of followed.values()) one.keepAll();
    },
  };
}

/** The attempts at one level that is or was open. */
class Followed {
  /** The numbers of those that are stored or on their way, by id. */
  private known = new Map<string, number>();
  private opened: { readonly in: AttemptStore; readonly list: Promise<number> } | null = null;

  constructor(
    private place: string,
    private readonly attempts: Attempts,
    private readonly store: () => AttemptStore,
    private readonly inTurn: (act: Work) => void,
  ) {
    attempts.store.subscribe(() => this.follow());
    this.keepAll();
  }

  /** Brings page and store together. */
  keepAll(): void {
    this.known = new Map();
    this.inTurn(async () => {
      const earlier = await this.store().attempts(await this.list());
      for (const { id, number } of earlier) this.known.set(id, number);
      this.attempts.restore(earlier);
    });
    this.follow();
  }

  moved(moves: readonly Move[]): void {
    this.place = moves.find(({ from }) => from === this.place)?.to ?? this.place;
  }

  openedAgain(place: string): void {
    this.place = place;
    this.opened = null;
    this.keepAll();
  }

  private list(): Promise<number> {
    const store = this.store();
    // what failed is tried again
    if (this.opened?.in !== store) {
      const opened = { in: store, list: store.open(this.place) };
      this.opened = opened;
      opened.list.catch(() => {
        if (this.opened === opened) this.opened = null;
      });
    }
    return this.opened?.list ?? store.open(this.place);
  }

  private follow(): void {
    const { known } = this;
    const now = this.attempts.store.getState();
    const added = now.filter(({ id, number }) => known.get(id) !== number);
    const here = new Set(now.map(({ id }) => id));
    const gone = [...known.keys()].filter((id) => !here.has(id));
    for (const { id, number } of added) known.set(id, number);
    for (const id of gone) known.delete(id);
    if (added.length > 0)
      this.inTurn(async () => {
        const wanted = added.filter(({ id, number: own }) => known.get(id) === own);
        if (wanted.length > 0) await this.store().put(await this.list(), wanted);
      });
    if (gone.length > 0) this.inTurn(async () => this.store().remove(await this.list(), gone));
  }
}
