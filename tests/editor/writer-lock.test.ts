import { beforeEach, describe, expect, it } from 'vitest';
import { claimLevel, type Role, type Shown, type WriterLock } from '../../editor/core/files/writer-lock.ts';
import { breathe, createChannels, LockKeeper, TurnedClock } from './stage.ts';

let clock: TurnedClock;
let locks: LockKeeper;
let channel: ReturnType<typeof createChannels>;

beforeEach(() => {
  clock = new TurnedClock();
  locks = new LockKeeper();
  channel = createChannels();
});

interface Tab {
  readonly lock: WriterLock;
  readonly seen: string[];
  readonly roles: Role[];
  text: string;
  /** The work that it waits for before it hands over the level. */
  before: () => Promise<unknown>;
  handedOver: number;
  role(): Role;
}

const shownOf = (text: string): Shown => ({ text, base: { text: `${text} on disk`, etag: null } });

function tab(page: string, name = 'level', hasLocks = true): Tab {
  const made = {
    ...{ seen: [] as string[], roles: [] as Role[], text: page, handedOver: 0, before: async (): Promise<unknown> => undefined },
    role: () => lock.store.getState(),
  };
  const lock = claimLevel({
    locks: hasLocks ? locks.of(page) : null,
    channel: channel(name),
    timers: clock,
    name,
    beforeHandOver() {
      made.handedOver++;
      return made.before();
    },
    onShown: ({ text }) => made.seen.push(text),
    shown: () => shownOf(made.text),
  });
  lock.store.subscribe((role) => made.roles.push(role));
  return Object.assign(made, { lock });
}
const rolesOf = (...tabs: Tab[]) => tabs.map((one) => one.role());

describe('the pages that have a level open', () => {
  it('are one writer and readers, which get its state at once', async () => {
    const a = tab('a');
    expect(a.role()).toBe('waiting');
    await breathe();
    const b = tab('b');
    await breathe();
    expect(rolesOf(a, b)).toEqual(['writer', 'reader']);
    expect([a.seen, b.seen]).toEqual([[], ['a']]);
    const c = tab('c');
    await breathe();
    a.lock.tell(shownOf('more'));
    c.lock.tell(shownOf('not from a reader'));
    await breathe();
    // c has asked, and all readers get the answer
    expect([a.seen, b.seen]).toEqual([[], ['a', 'a', 'more']]);
    // each page is informed once about its new role
    expect([a.roles, b.roles]).toEqual([['writer'], ['reader']]);
  });

  it('have the next one as the writer when the first is closed or killed', async () => {
    const tabs = ['a', 'b', 'c', 'd'].map((page) => tab(page));
    const [a, b, c, d] = tabs;
    await breathe();
    a.lock.close();
    await breathe();
    expect(rolesOf(b, c, d)).toEqual(['writer', 'reader', 'reader']);
    c.lock.close();
    await breathe();
    locks.kill('b');
    await breathe();
    expect(d.role()).toBe('writer');
    // a closed page gets no messages and no role
    expect(rolesOf(a, c)).toEqual(['writer', 'reader']);
    d.lock.tell(shownOf('late'));
    await breathe();
    expect([a.seen, c.seen.includes('late')]).toEqual([[], false]);
  });

  it('are all writers without Web Locks', async () => {
    const [a, b] = [tab('a', 'level', false), tab('b', 'level', false)];
    expect(rolesOf(a, b)).toEqual(['writer', 'writer']);
    b.lock.takeOver();
    b.lock.moveTo('other', channel('other'));
    await clock.pass(10_000);
    expect(rolesOf(a, b)).toEqual(['writer', 'writer']);
    channel('level').postMessage({ type: 'hand-over' });
    await breathe();
    expect([a.handedOver, a.role(), a.roles, b.roles]).toEqual([0, 'writer', [], []]);
  });

  it('hold no lock if they are closed before they get a role', async () => {
    const a = tab('a');
    a.lock.close();
    await breathe();
    expect([a.role(), a.roles]).toEqual(['waiting', []]);
    const b = tab('b');
    await breathe();
    expect(b.role()).toBe('writer');
  });
});

/** From now on, a page that must hand over keeps writing. @returns a function that ends the write */
function keepWriting(page: Tab): () => void {
  let written = () => {};
  page.before = () =>
    new Promise<void>((resolve) => {
      written = resolve;
    });
  return () => written();
}

describe('a page that takes over', () => {
  it('waits until the other page has written, which is then the next in the queue', async () => {
    const [a, b] = [tab('a'), tab('b')];
    await breathe();
    const written = keepWriting(a);
    b.lock.takeOver();
    await breathe();
    expect([rolesOf(a, b), a.handedOver]).toEqual([['writer', 'reader'], 1]);
    written();
    await breathe();
    expect(rolesOf(a, b)).toEqual(['reader', 'writer']);
    // it shows the state of the new writer
    expect(a.seen).toEqual(['b']);
    await clock.pass(10_000);
    expect([rolesOf(a, b), a.roles, b.roles]).toEqual([
      ['reader', 'writer'],
      ['writer', 'reader'],
      ['reader', 'writer'],
    ]);
    b.lock.close();
    await breathe();
    expect(a.role()).toBe('writer');
  });

  it('becomes the writer after 1.5 s without an answer, and the other is a reader when it wakes', async () => {
    const [a, b] = [tab('a'), tab('b')];
    await breathe();
    const written = keepWriting(a);
    b.lock.takeOver();
    // a second request waits again
    await clock.pass(1000);
    b.lock.takeOver();
    await clock.pass(1400);
    expect(rolesOf(a, b)).toEqual(['writer', 'reader']);
    await clock.pass(200);
    expect(rolesOf(a, b)).toEqual(['reader', 'writer']);
    written();
    await clock.pass(10_000);
    expect(rolesOf(a, b)).toEqual(['reader', 'writer']);
    expect(a.seen).toContain('b');
    b.lock.close();
    await breathe();
    expect(a.role()).toBe('writer');
  });

  it('does nothing if it is closed in the meantime, or if it is already the writer', async () => {
    const [a, b] = [tab('a'), tab('b')];
    await breathe();
    a.lock.takeOver();
    a.before = () => new Promise(() => {});
    b.lock.takeOver();
    await breathe();
    b.lock.close();
    await clock.pass(10_000);
    expect(a.role()).toBe('writer');
    expect(a.roles).toEqual(['writer']);
  });
});

describe('a renamed level', () => {
  it('keeps its writer for pages that open it by its old or new name, and its readers follow', async () => {
    const [a, b] = [tab('a'), tab('b')];
    await breathe();
    a.lock.moveTo('new', channel('new'));
    await breathe();
    const [late, early] = [tab('late', 'new'), tab('early', 'level')];
    await breathe();
    expect(rolesOf(a, late, early)).toEqual(['writer', 'reader', 'reader']);
    b.lock.moveTo('new', channel('new'));
    early.lock.moveTo('new', channel('new'));
    await clock.pass(10_000);
    expect(rolesOf(a, b, late, early)).toEqual(['writer', 'reader', 'reader', 'reader']);
    // a reader that has moved requests the state
    expect(b.seen.at(-1)).toBe('a');
    a.lock.tell(shownOf('more'));
    await breathe();
    expect([b, late, early].map(({ seen }) => seen.at(-1))).toEqual(['more', 'more', 'more']);
    a.lock.close();
    await clock.pass(10_000);
    expect([b, late, early].filter((one) => one.role() === 'writer')).toHaveLength(1);
  });

  it('is shown by a reader that follows, which requests the state', async () => {
    const [a, b] = [tab('a'), tab('b')];
    await breathe();
    b.seen.length = 0;
    a.lock.moveTo('new', channel('new'));
    a.text = 'a, renamed';
    b.lock.moveTo('new', channel('new'));
    await clock.pass(10_000);
    expect([rolesOf(a, b), b.seen]).toEqual([['writer', 'reader'], ['a, renamed']]);
  });

  it('stays locked under its old name for 3 s', async () => {
    const a = tab('a');
    await breathe();
    a.lock.moveTo('new', channel('new'));
    await breathe();
    const b = tab('b', 'level');
    await clock.pass(2900);
    expect(rolesOf(a, b)).toEqual(['writer', 'reader']);
    await clock.pass(200);
    // then another level may have the name
    expect(rolesOf(a, b)).toEqual(['writer', 'writer']);
    a.lock.close();
    b.lock.close();
    await clock.pass(10_000);
    for (const name of ['level', 'new']) {
      const next = tab(`next ${name}`, name);
      await breathe();
      expect(next.role()).toBe('writer');
    }
  });

  it('releases the first name at once at the next rename, and all names when it is closed', async () => {
    const a = tab('a');
    await breathe();
    a.lock.moveTo('second', channel('second'));
    await breathe();
    a.lock.moveTo('third', channel('third'));
    await breathe();
    const [first, second, third] = ['level', 'second', 'third'].map((name) => tab(name, name));
    await breathe();
    expect(rolesOf(first, second, third)).toEqual(['writer', 'reader', 'reader']);
    a.lock.close();
    await breathe();
    expect(rolesOf(first, second, third)).toEqual(['writer', 'writer', 'writer']);
  });

  it('stays with its writer if another page takes the old name', async () => {
    const a = tab('a');
    await breathe();
    a.lock.moveTo('new', channel('new'));
    const b = tab('b', 'level');
    await breathe();
    b.lock.takeOver();
    await clock.pass(2000);
    expect(rolesOf(a, b)).toEqual(['writer', 'writer']);
    await clock.pass(10_000);
    expect([rolesOf(a, b), a.roles, a.handedOver]).toEqual([['writer', 'writer'], ['writer'], 0]);
  });

  it('can be renamed by a reader, which then does not take over any more', async () => {
    const [a, b] = [tab('a'), tab('b')];
    await breathe();
    a.before = () => new Promise(() => {});
    b.lock.takeOver();
    b.lock.moveTo('new', channel('new'));
    await clock.pass(10_000);
    expect(rolesOf(a, b)).toEqual(['writer', 'writer']);
    expect(a.roles).toEqual(['writer']);
    a.lock.tell(shownOf('of the old name'));
    await breathe();
    expect(b.seen).not.toContain('of the old name');
  });

  it('ignores unknown messages', () => {
    const listeners: ((event: { readonly data: unknown }) => void)[] = [];
    const lock = claimLevel({
      locks: null,
      channel: { postMessage: () => {}, addEventListener: (_, listener) => void listeners.push(listener), close: () => {} },
      timers: clock,
      name: 'level',
      beforeHandOver: async () => {},
      onShown: () => {},
      shown: () => shownOf(''),
    });
    for (const data of [null, undefined, 7, 'shown', [], {}, { type: null }])
      for (const listener of listeners) expect(() => listener({ data })).not.toThrow();
    expect(lock.store.getState()).toBe('writer');
  });

  it('ignores messages under the old name and junk', async () => {
    const b = tab('b');
    const c = tab('c');
    await breathe();
    const others = channel('level');
    for (const junk of [null, 7, 'shown', {}, { type: 7 }, { type: 'other' }]) others.postMessage(junk);
    await breathe();
    expect([rolesOf(b, c), c.seen]).toEqual([['writer', 'reader'], ['b']]);
    others.postMessage({ type: 'shown', shown: shownOf('x') });
    await breathe();
    expect([b.seen, c.seen]).toEqual([[], ['b', 'x']]);
    b.lock.moveTo('new', channel('new'));
    others.postMessage({ type: 'hand-over' });
    await breathe();
    expect([b.handedOver, b.role()]).toEqual([0, 'writer']);
  });
});
