import type { Channel, KeyValues, LevelStorage, Timers } from '../../editor/core/files/index.ts';
import { type Link, storageError } from '../../editor/core/files/level-storage.ts';
import { createVersionKeeper, type VersionKeeper, type VersionStore } from '../../editor/core/versions/index.ts';
import type { EditEvent, LevelFile } from '../../schema/index.ts';

/** A small level with which tests of files start. */
export const FILE: LevelFile = {
  version: 1,
  name: 'base',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [{ id: 'aa', x: 10, y: 20, radius: 16 }],
};

/** Histories that live as long as the test; nothing is recorded by itself without `whenIdle`. */
export const passingVersions = (
  store: VersionStore | null = null,
  now: () => number = () => 0,
  whenIdle: (call: () => void) => () => void = () => () => {},
): VersionKeeper => createVersionKeeper({ store, now, whenIdle });

/** A clock that stands still until a test advances it. */
export class TurnedClock implements Timers {
  private time = 0;
  private waiting: { readonly at: number; readonly call: () => void }[] = [];

  now = (): number => this.time;

  after(ms: number, call: () => void): () => void {
    const entry = { at: this.time + ms, call };
    this.waiting.push(entry);
    return () => {
      this.waiting = this.waiting.filter((other) => other !== entry);
    };
  }

  /** Advances the clock by some ms, and runs everything that is due, including promises. */
  async pass(ms: number): Promise<void> {
    const until = this.time + ms;
    await breathe();
    for (;;) {
      const next = this.waiting.filter(({ at }) => at <= until).sort((a, b) => a.at - b.at)[0];
      if (next === undefined) break;
      this.waiting = this.waiting.filter((other) => other !== next);
      this.time = Math.max(this.time, next.at);
      next.call();
      await breathe();
    }
    this.time = until;
  }
}

/** Runs promises until nothing more happens by itself. */
export async function breathe(): Promise<void> {
  for (let i = 0; i < 3; i++) await new Promise((resolve) => setImmediate(resolve));
}

export function createKeyValues(): KeyValues {
  const values = new Map<string, unknown>();
  return {
    get: async (key) => structuredClone(values.get(key)),
    async update(key, change) {
      values.set(key, structuredClone(change(values.get(key))));
    },
  };
}

/** Channels between the pages of one browser: messages arrive later, and not at their sender. */
export function createChannels(): (name: string) => Channel {
  const open = new Map<string, Set<{ listeners: ((event: { data: unknown }) => void)[] }>>();
  return (name) => {
    const all = open.get(name) ?? new Set();
    open.set(name, all);
    const mine = { listeners: [] as ((event: { data: unknown }) => void)[] };
    all.add(mine);
    return {
      postMessage(message) {
        const data = structuredClone(message);
        queueMicrotask(() => {
          for (const other of all) if (other !== mine) for (const listener of other.listeners) listener({ data });
        });
      },
      addEventListener: (_, listener) => void mine.listeners.push(listener),
      close: () => void all.delete(mine),
    };
  };
}

interface Waiting {
  readonly page: string;
  readonly callback: LockGrantedCallback<unknown>;
  readonly resolve: (value: unknown) => void;
  readonly reject: (error: Error) => void;
}

/** Web Locks for pages that can be killed. */
export class LockKeeper {
  private readonly dead = new Set<string>();
  private readonly held = new Map<string, Waiting>();
  private readonly queues = new Map<string, Waiting[]>();

  /** `navigator.locks` of one page. */
  of(page: string): Pick<LockManager, 'request'> {
    const request = (name: string, options: LockOptions, callback: LockGrantedCallback<unknown>): Promise<unknown> =>
      new Promise((resolve, reject) => {
        const waiting: Waiting = { page, callback, resolve, reject };
        queueMicrotask(() => this.ask(name, options, waiting));
      });
    return { request: request as LockManager['request'] };
  }

  kill(page: string): void {
    this.dead.add(page);
    for (const [name, queue] of this.queues)
      this.queues.set(
        name,
        queue.filter((waiting) => waiting.page !== page),
      );
    for (const [name, { page: owner }] of [...this.held]) if (owner === page) this.free(name);
  }

  private ask(name: string, { ifAvailable, steal, signal }: LockOptions, waiting: Waiting): void {
    if (this.dead.has(waiting.page)) return;
    const holder = this.held.get(name);
    if (signal?.aborted) {
      waiting.reject(new DOMException('aborted', 'AbortError'));
      return;
    }
    if (holder === undefined || steal) {
      this.held.delete(name);
      holder?.reject(new DOMException('stolen', 'AbortError'));
      this.grant(name, waiting);
      return;
    }
    if (ifAvailable) {
      waiting.resolve(waiting.callback(null));
      return;
    }
    const queue = this.queues.get(name) ?? [];
    queue.push(waiting);
    this.queues.set(name, queue);
    signal?.addEventListener('abort', () => {
      this.queues.set(
        name,
        (this.queues.get(name) ?? []).filter((other) => other !== waiting),
      );
      waiting.reject(new DOMException('aborted', 'AbortError'));
    });
  }

  private grant(name: string, waiting: Waiting): void {
    this.held.set(name, waiting);
    void Promise.resolve(waiting.callback({ name, mode: 'exclusive' })).then((value) => {
      if (this.held.get(name) !== waiting) return;
      waiting.resolve(value);
      this.free(name);
    });
  }

  private free(name: string): void {
    this.held.delete(name);
    const next = this.queues.get(name)?.shift();
    if (next !== undefined) this.grant(name, next);
  }
}

/** A storage that can be disconnected, and whose requests can be delayed. */
export function createLine(storage: LevelStorage): LevelStorage & {
  isCut: boolean;
  /** Writes arrive, but their answers do not. */
  losesAnswers: boolean;
  /** Why nothing may be written; null if writing works. */
  readOnly: string | null;
  writes: number;
  gate: Promise<void> | null;
  readGate: Promise<void> | null;
  tell: (event: EditEvent) => void;
  link: (link: Link) => void;
} {
  const cut = { ok: false, error: storageError('unreachable', 'nobody answers', 'start it') } as const;
  let onEvent: (event: EditEvent) => void = () => {};
  let onLink: (link: Link) => void = () => {};
  return {
    ...storage,
    isCut: false,
    losesAnswers: false,
    readOnly: null,
    writes: 0,
    gate: null,
    readGate: null,
    async read(id) {
      if (this.isCut) return cut;
      const answer = await storage.read(id);
      await this.readGate;
      return answer.ok ? { ...answer, value: { ...answer.value, readOnly: this.readOnly } } : answer;
    },
    async write(id, text, base) {
      this.writes++;
      if (this.isCut) return cut;
      await this.gate;
      if (this.readOnly !== null) return { ok: false, error: storageError('not-writable', this.readOnly, 'allow it') };
      const answer = await storage.write(id, text, base);
      return this.losesAnswers ? cut : answer;
    },
    async list() {
      return this.isCut ? cut : storage.list();
    },
    watch(event, link) {
      onEvent = event;
      onLink = link;
      return () => {};
    },
    tell: (event) => onEvent(event),
    link: (now) => onLink(now),
  };
}
