import { describe, expect, it } from 'vitest';
import { createEditedLevel, setLevelProperty } from '../../editor/core/document/index.ts';
import { inTimeOrLate } from '../../editor/core/files/page-surroundings.ts';
import { createJournal, createMemoryStore } from '../../editor/core/journal/index.ts';
import { createNotices } from '../../editor/core/notices/index.ts';
import { tellKept } from '../../editor/features/kept/feature.tsx';
import { breathe, FILE, TurnedClock } from './stage.ts';

/** The state of a promise so far. */
function watched<T>(opening: ReturnType<typeof inTimeOrLate<T>>) {
  const seen: { inTime?: T | null; late?: T } = {};
  void opening.then(({ inTime, late }) => {
    seen.inTime = inTime;
    void late.then((value) => {
      seen.late = value;
    });
  });
  return seen;
}

describe('a database that may never answer', () => {
  it('is used when it answers', async () => {
    const clock = new TurnedClock();
    const seen = watched(inTimeOrLate(async () => 'levels', clock));
    await breathe();
    expect(seen).toEqual({ inTime: 'levels', late: 'levels' });
  });

  it('is waited for at most 3 s, and used if it answers later', async () => {
    const clock = new TurnedClock();
    let answer = (_: string) => {};
    const seen = watched(
      inTimeOrLate(
        () =>
          new Promise<string>((resolve) => {
            answer = resolve;
          }),
        clock,
      ),
    );
    await clock.pass(2900);
    expect(seen).toEqual({});
    await clock.pass(200);
    expect(seen).toEqual({ inTime: null });
    await clock.pass(3_600_000);
    answer('levels');
    await breathe();
    expect(seen).toEqual({ inTime: null, late: 'levels' });
  });

  it('is not waited for if it is refused, but tried again', async () => {
    const clock = new TurnedClock();
    let times = 0;
    const seen = watched(
      inTimeOrLate(async () => {
        if (++times < 4) throw new DOMException('no', 'SecurityError');
        return 'levels';
      }, clock),
    );
    await breathe();
    expect(seen).toEqual({ inTime: null });
    await clock.pass(61_000);
    expect([times, seen.late]).toEqual([3, undefined]);
    await clock.pass(31_000);
    expect(seen).toEqual({ inTime: null, late: 'levels' });
  });
});

describe('unsaved changes of other levels', () => {
  it('are told of when the database answers only after the page has asked for them', async () => {
    const store = createMemoryStore();
    const earlier = createEditedLevel(FILE);
    const kept = createJournal(store, () => 0).follow('f/07', earlier, { file: earlier.file(), etag: '"1"' });
    earlier.change('Rename', setLevelProperty('name', 'unsaved'));
    await kept.settled();

    const journal = createJournal(null, () => 0);
    const notices = createNotices();
    const workspace = { store: { getState: () => ({ list: { folder: { id: 'f' } }, opened: null }) } };
    const stop = tellKept({ journal, notices, workspace: workspace as never, session: {} as never }, '127.0.0.1:4747');
    await breathe();
    expect(notices.store.getState()).toEqual([]);
    journal.adopt(store);
    await breathe();
    expect(notices.store.getState().map(({ text }) => text)).toEqual([
      'Unsaved changes to 07 are kept in this browser for 127.0.0.1:4747.',
    ]);
    stop();
  });
});
