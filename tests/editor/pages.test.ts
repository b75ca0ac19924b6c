import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { addObject, setLevelProperty } from '../../editor/core/document/index.ts';
import {
  createBrowserStorage,
  createWorkspace,
  type KeyValues,
  type LevelStorage,
  type OpenedLevel,
  readText,
  type Workspace,
} from '../../editor/core/files/index.ts';
import { createJournal, createMemoryStore, type JournalStore } from '../../editor/core/journal/index.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { breathe, createChannels, createKeyValues, createLine, LockKeeper, passingVersions, TurnedClock } from './stage.ts';

const FILE: LevelFile = { version: 1, name: 'base', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } };

/** One browser on one folder, with several pages, other programs, and a server that comes and goes. */
class Browser {
  readonly clock = new TurnedClock();
  readonly locks = new LockKeeper();
  readonly journal: JournalStore = createMemoryStore();
  private readonly database: KeyValues = createKeyValues();
  readonly disk: LevelStorage = createBrowserStorage(this.database, null, () => 0);
  private readonly channel = createChannels();
  private pages = 0;
  journalFails = false;

  async page() {
    const name = `page ${++this.pages}`;
    const line = createLine(this.disk);
    let isAlive = true;
    /** A closed page sends nothing any more: no answer, no call. */
    const whileAlive =
      <T extends unknown[], R>(act: (...args: T) => Promise<R>) =>
      (...args: T): Promise<R> =>
        isAlive ? act(...args) : new Promise(() => {});
    const journal: JournalStore = {
      write: whileAlive((change) => this.journal.write(change)),
      read: whileAlive(async (place) => {
        if (this.journalFails) throw new Error('it does not answer');
        return this.journal.read(place);
      }),
      places: whileAlive(() => this.journal.places()),
      remove: whileAlive((place) => this.journal.remove(place)),
    };
    const channels: { close(): void }[] = [];
    const workspace = createWorkspace({
      storage: line,
      journal: createJournal(journal, () => 0),
      versions: passingVersions(),
      timers: { now: this.clock.now, after: (ms, call) => this.clock.after(ms, () => isAlive && call()) },
      locks: this.locks.of(name),
      channel: (of) => {
        const channel = this.channel(of);
        channels.push(channel);
        return channel;
      },
    });
    await workspace.start();
    /** Closes the page at once: none of its pending work happens. */
    const kill = () => {
      isAlive = false;
      line.isCut = true;
      opened(workspace)?.saver.close();
      for (const channel of channels) channel.close();
      this.locks.kill(name);
    };
    return { name, line, workspace, kill };
  }

  async text(): Promise<string> {
    const answer = await this.disk.read('07');
    return answer.ok ? (answer.value.text ?? '') : '';
  }

  async file(): Promise<LevelFile> {
    const reading = readText(await this.text());
    if (!reading.ok) throw new Error('not a level');
    return reading.file;
  }

  /** A write by another program, such as a checkout. */
  async byOthers(change: (file: LevelFile) => LevelFile): Promise<void> {
    for (;;) {
      const answer = await this.disk.read('07');
      const reading = answer.ok ? readText(answer.value.text ?? '') : null;
      if (!answer.ok || !reading?.ok) throw new Error('not a level');
      if ((await this.disk.write('07', formatLevel(change(reading.file)), answer.value.etag)).ok) return;
    }
  }
}

const opened = (workspace: Workspace): OpenedLevel | null => workspace.store.getState().opened;
const role = (workspace: Workspace) => opened(workspace)?.lock.store.getState();
const saveState = (workspace: Workspace) => opened(workspace)?.saver.store.getState().kind;

async function browser(): Promise<Browser> {
  const made = new Browser();
  await made.disk.write('07', formatLevel(FILE), null);
  return made;
}

const opening = async (workspace: Workspace): Promise<OpenedLevel> => {
  await workspace.open('07');
  return opened(workspace) as OpenedLevel;
};

describe('a page', () => {
  it('opens a level, saves it, and keeps its history until it is opened again', async () => {
    const at = await browser();
    await at.disk.write('08', formatLevel({ ...FILE, name: 'eight' }), null);
    const { workspace } = await at.page();
    await workspace.open('07');
    opened(workspace)?.level.change('Rename', setLevelProperty('name', 'new'));
    await workspace.open('08');
    expect((await at.file()).name).toBe('new');
    await workspace.open('07');
    expect(opened(workspace)?.level.labels()).toEqual(['Rename']);
    opened(workspace)?.level.undo();
    await at.clock.pass(500);
    expect((await at.file()).name).toBe('base');
  });

  it('that died recovers unsaved changes after a restart, and only once', async () => {
    const at = await browser();
    const first = await at.page();
    await first.workspace.open('07');
    first.line.isCut = true;
    opened(first.workspace)?.level.change('Rename', setLevelProperty('name', 'unsaved'));
    await at.clock.pass(1000);
    expect(saveState(first.workspace)).toBe('offline');
    first.kill();
    await at.byOthers((file) => ({ ...file, description: 'by another tool' }));
    const second = await at.page();
    await second.workspace.open('07');
    expect(opened(second.workspace)?.recovered).toMatchObject({ labels: ['Rename'], lost: 0 });
    await at.clock.pass(1000);
    expect(await at.file()).toMatchObject({ name: 'unsaved', description: 'by another tool' });
    expect(opened(second.workspace)?.level.labels()).toContain('Recovered');
    second.kill();
    const third = await at.page();
    await third.workspace.open('07');
    expect(opened(third.workspace)?.recovered).toBeNull();
  });

  it('that died before the answer to its write continues from that version', async () => {
    const at = await browser();
    const first = await at.page();
    await first.workspace.open('07');
    first.line.losesAnswers = true;
    opened(first.workspace)?.level.change('Rename', setLevelProperty('name', 'written'));
    await at.clock.pass(300);
    expect((await at.file()).name).toBe('written');
    first.line.isCut = true;
    opened(first.workspace)?.level.change('Rename', setLevelProperty('name', 'after it'));
    await at.clock.pass(1000);
    first.kill();
    const second = await at.page();
    await second.workspace.open('07');
    await at.clock.pass(1000);
    expect([saveState(second.workspace), (await at.file()).name]).toEqual(['saved', 'after it']);
    expect(opened(second.workspace)?.recovered).toMatchObject({ labels: ['Rename', 'Rename'] });
  });

  it('that died before the answer to its last write has nothing to recover', async () => {
    const at = await browser();
    const first = await at.page();
    await first.workspace.open('07');
    first.line.losesAnswers = true;
    opened(first.workspace)?.level.change('Rename', setLevelProperty('name', 'written'));
    await at.clock.pass(300);
    first.kill();
    const second = await at.page();
    await second.workspace.open('07');
    expect([saveState(second.workspace), opened(second.workspace)?.level.file().name]).toEqual(['saved', 'written']);
    expect(opened(second.workspace)?.recovered).toBeNull();
  });

  it('opens a level whose journal does not answer, reports that, and recovers its changes later', async () => {
    const at = await browser();
    const first = await at.page();
    const before = await opening(first.workspace);
    first.line.isCut = true;
    before.level.change('Describe', setLevelProperty('description', 'left'));
    await at.clock.pass(1000);
    expect(before.keeping.getState()).toBe('kept');
    first.kill();

    at.journalFails = true;
    const second = await at.page();
    const after = await opening(second.workspace);
    expect(after.keeping.getState()).toBe('failing');
    expect(after.level.file().description).toBeUndefined();
    after.level.change('Rename', setLevelProperty('name', 'meanwhile'));
    await at.clock.pass(10_000);
    expect(after.keeping.getState()).toBe('failing');
    at.journalFails = false;
    await at.clock.pass(10_000);
    expect(after.keeping.getState()).toBe('kept');
    expect(await at.file()).toMatchObject({ name: 'meanwhile', description: 'left' });
  });

  it('shows a file that is not a level as text, and does not change it', async () => {
    const at = await browser();
    const { workspace, line } = await at.page();
    line.read = async (id) => {
      const answer = await at.disk.read(id);
      return answer.ok ? { ...answer, value: { ...answer.value, text: '{ "version": 1,' } } : answer;
    };
    const opening = await workspace.open('07');
    expect(opening).toMatchObject({
      ok: false,
      kind: 'invalid',
      text: '{ "version": 1,',
      problems: [{ code: 'truncated-json' }],
    });
    expect(workspace.store.getState()).toMatchObject({ opened: null, refused: { id: '07' } });
    await at.clock.pass(5000);
    expect(line.writes).toBe(0);
  });

  it('renames the open level and continues to save it', async () => {
    const at = await browser();
    const { workspace } = await at.page();
    await workspace.open('07');
    opened(workspace)?.level.change('Rename', setLevelProperty('name', 'new'));
    const entry = workspace.store.getState().list?.levels[0];
    expect(entry === undefined ? 'no entry' : await workspace.rename(entry, '09')).toMatchObject({ ok: true });
    opened(workspace)?.level.change('Rename', setLevelProperty('description', 'after'));
    await at.clock.pass(1000);
    const answer = await at.disk.read('09');
    expect(answer.ok && answer.value.text).toContain('after');
    expect(await at.text()).toBe('');
    expect(saveState(workspace)).toBe('saved');
  });
});

describe('two pages on one level', () => {
  it('are one writer and one reader, which becomes the writer when the first is gone', async () => {
    const at = await browser();
    const [a, b] = [await at.page(), await at.page()];
    await a.workspace.open('07');
    await b.workspace.open('07');
    expect([role(a.workspace), role(b.workspace)]).toEqual(['writer', 'reader']);
    expect(opened(b.workspace)?.saver.store.getState()).toMatchObject({ kind: 'readOnly', unsaved: false });
    opened(a.workspace)?.level.change('Rename', setLevelProperty('name', 'by a'));
    // the user does not wait while a large level is written out
    await at.clock.pass(100);
    await breathe();
    expect(opened(b.workspace)?.level.file().name).toBe('by a');
    await at.clock.pass(1000);
    expect(b.line.writes).toBe(0);
    await a.workspace.close();
    await breathe();
    expect(role(b.workspace)).toBe('writer');
    opened(b.workspace)?.level.change('Rename', setLevelProperty('name', 'by b'));
    await at.clock.pass(1000);
    expect((await at.file()).name).toBe('by b');
  });

  it('hand over on demand, after everything is written', async () => {
    const at = await browser();
    const [a, b] = [await at.page(), await at.page()];
    await a.workspace.open('07');
    await b.workspace.open('07');
    opened(a.workspace)?.level.change('Rename', setLevelProperty('name', 'by a'));
    opened(b.workspace)?.lock.takeOver();
    await breathe();
    await breathe();
    expect([role(a.workspace), role(b.workspace)]).toEqual(['reader', 'writer']);
    expect((await at.file()).name).toBe('by a');
    opened(b.workspace)?.level.change('Rename', setLevelProperty('name', 'by b'));
    await at.clock.pass(3000);
    expect([(await at.file()).name, opened(a.workspace)?.level.file().name]).toEqual(['by b', 'by b']);
    expect(a.line.writes).toBe(1);
  });

  it('still have one writer after a rename, also for a page that opens the level by its new name', async () => {
    const at = await browser();
    const [a, b, c] = [await at.page(), await at.page(), await at.page()];
    await a.workspace.open('07');
    await b.workspace.open('07');
    const entry = a.workspace.store.getState().list?.levels[0];
    const renamed = entry === undefined ? null : await a.workspace.rename(entry, '09');
    if (renamed?.ok !== true) throw new Error('not renamed');
    b.line.tell({ type: 'renamed', from: '07', entry: renamed.value, by: null });
    await breathe();
    await c.workspace.open('09');
    await at.clock.pass(5000);
    expect([a, b, c].map(({ workspace }) => role(workspace))).toEqual(['writer', 'reader', 'reader']);
    opened(a.workspace)?.level.change('Rename', setLevelProperty('name', 'by a'));
    await at.clock.pass(1000);
    for (const { workspace } of [b, c]) expect(opened(workspace)?.level.file().name).toBe('by a');
    a.kill();
    await at.clock.pass(5000);
    const roles = [b, c].map(({ workspace }) => role(workspace));
    expect([...roles].sort()).toEqual(['reader', 'writer']);
    const writer = roles[0] === 'writer' ? b : c;
    opened(writer.workspace)?.level.change('Rename', setLevelProperty('name', 'by another'));
    await at.clock.pass(1000);
    const answer = await at.disk.read('09');
    expect(answer.ok && answer.value.text).toContain('by another');
  });

  it('can take the level from a page that does not answer, and from one that died with unsaved changes', async () => {
    const at = await browser();
    const [a, b] = [await at.page(), await at.page()];
    await a.workspace.open('07');
    await b.workspace.open('07');
    a.line.isCut = true;
    a.line.write = () => new Promise(() => {});
    opened(a.workspace)?.level.change('Add', addObject('nova', 1, 1));
    await at.clock.pass(300);
    opened(b.workspace)?.lock.takeOver();
    await at.clock.pass(1000);
    expect(role(b.workspace)).toBe('reader');
    await at.clock.pass(1000);
    expect(role(b.workspace)).toBe('writer');
    await at.clock.pass(1000);
    expect((await at.file()).novae).toHaveLength(1);
  });
});

describe('a change in a page that may not write', () => {
  const two = async () => {
    const at = await browser();
    await at.disk.write('08', formatLevel({ ...FILE, name: 'eight' }), null);
    const [a, b] = [await at.page(), await at.page()];
    const [writer, reader] = [await opening(a.workspace), await opening(b.workspace)];
    expect([role(a.workspace), role(b.workspace)]).toEqual(['writer', 'reader']);
    const namedBy = async (one: OpenedLevel, name: string) => {
      one.level.change('Rename', setLevelProperty('name', name));
      await at.clock.pass(1000);
    };
    return { at, a, b, writer, reader, namedBy };
  };
  const describedIn = (one: OpenedLevel, text: string) => one.level.change('Describe', setLevelProperty('description', text));

  it('stays where it was made while the other page goes on, and is saved with the rest once it takes over', async () => {
    const { at, b, writer, reader, namedBy } = await two();
    await namedBy(writer, 'by the writer');
    describedIn(reader, 'by the reader');
    expect(reader.holding.getState()).toBe(true);
    expect(reader.saver.store.getState()).toMatchObject({ kind: 'readOnly', unsaved: true });
    await namedBy(writer, 'by the writer again');
    expect(reader.level.file().description).toBe('by the reader');
    expect(b.line.writes).toBe(0);
    reader.lock.takeOver();
    await at.clock.pass(3000);
    expect(reader.holding.getState()).toBe(false);
    const both = { name: 'by the writer again', description: 'by the reader' };
    expect(await at.file()).toMatchObject(both);
    expect(reader.level.file()).toMatchObject(both);
    expect(writer.level.file()).toMatchObject(both);
  });

  it('is saved when the other page is closed, dies, or does not answer', async () => {
    for (const end of ['close', 'kill', 'freeze'] as const) {
      const { at, a, writer, reader } = await two();
      // what the writer could not write is not lost either
      a.line.isCut = true;
      writer.level.change('Rename', setLevelProperty('name', 'unsaved'));
      await at.clock.pass(300);
      describedIn(reader, 'by the reader');
      if (end === 'close') a.line.isCut = false;
      if (end === 'close') await a.workspace.close();
      else if (end === 'kill') a.kill();
      else {
        a.line.write = () => new Promise(() => {});
        a.line.isCut = false;
        reader.lock.takeOver();
      }
      await at.clock.pass(5000);
      expect([end, reader.lock.store.getState(), reader.holding.getState()]).toEqual([end, 'writer', false]);
      expect(await at.file()).toMatchObject({ name: 'unsaved', description: 'by the reader' });
    }
  });

  it('can be dropped: the level is as the other page has it, and undo holds the change again', async () => {
    const { at, writer, reader, namedBy } = await two();
    describedIn(reader, 'by the reader');
    await namedBy(writer, 'by the writer');
    reader.dropHeld();
    expect(reader.level.file()).toEqual(writer.level.file());
    expect(reader.holding.getState()).toBe(false);
    expect(reader.saver.store.getState()).toMatchObject({ kind: 'readOnly', unsaved: false });
    await namedBy(writer, 'by the writer again');
    expect(reader.level.file().name).toBe('by the writer again');
    reader.level.undo();
    reader.level.undo();
    expect([reader.level.file().description, reader.holding.getState()]).toEqual(['by the reader', true]);
    expect(await at.file()).not.toHaveProperty('description');
  });

  it('is held no more once it is undone by hand: the page follows again', async () => {
    const { writer, reader, namedBy } = await two();
    await namedBy(writer, 'first');
    describedIn(reader, 'by the reader');
    await namedBy(writer, 'second');
    // the disk has told nothing: only the writer has
    reader.level.undo();
    expect([reader.holding.getState(), reader.level.file().name]).toEqual([false, 'second']);
  });

  it('is not cut off in the middle of a gesture by what the other page does', async () => {
    const { at, writer, reader, namedBy } = await two();
    const drag = reader.level.begin('Describe');
    drag.set(setLevelProperty('description', 'half'));
    await namedBy(writer, 'by the writer');
    expect(drag.isLive).toBe(true);
    drag.set(setLevelProperty('description', 'whole'));
    drag.commit();
    expect([reader.level.file().description, reader.holding.getState()]).toEqual(['whole', true]);
    reader.level.undo();
    const other = reader.level.begin('Describe');
    other.set(setLevelProperty('description', 'half'));
    await namedBy(writer, 'by the writer again');
    other.cancel();
    await at.clock.pass(200);
    expect(reader.level.file()).toEqual(writer.level.file());
    expect(reader.holding.getState()).toBe(false);
  });

  it('is still there after another level was opened in between, also when the page may write then', async () => {
    for (const isGone of [false, true]) {
      const { at, a, b, writer, reader, namedBy } = await two();
      describedIn(reader, 'by the reader');
      await b.workspace.open('08');
      await namedBy(writer, 'by the writer');
      if (isGone) a.kill();
      const again = await opening(b.workspace);
      expect(again.holding.getState()).toBe(!isGone);
      expect(again.level.file().description).toBe('by the reader');
      if (!isGone) again.lock.takeOver();
      await at.clock.pass(3000);
      expect(await at.file()).toMatchObject({ name: 'by the writer', description: 'by the reader' });
    }
  });

  it('of the same property as a change of the other page is a question to the user, not a loss', async () => {
    const { at, b, writer, reader, namedBy } = await two();
    reader.level.change('Rename', setLevelProperty('name', 'by the reader'));
    await namedBy(writer, 'by the writer');
    reader.lock.takeOver();
    await at.clock.pass(3000);
    expect(saveState(b.workspace)).toBe('conflict');
    expect((await at.file()).name).toBe('by the writer');
    expect(reader.level.file().name).toBe('by the reader');
  });
});

describe('whatever happens', () => {
  const act = fc.oneof(
    { weight: 6, arbitrary: fc.record({ what: fc.constant('edit' as const), page: fc.nat(1) }) },
    {
      weight: 3,
      arbitrary: fc.record({
        what: fc.constantFrom('cut' as const, 'lose answers' as const, 'mend' as const, 'take over' as const),
        page: fc.nat(1),
      }),
    },
    { weight: 2, arbitrary: fc.record({ what: fc.constant('kill' as const), page: fc.nat(1) }) },
    { weight: 2, arbitrary: fc.record({ what: fc.constant('others' as const), page: fc.constant(0) }) },
    { weight: 4, arbitrary: fc.record({ what: fc.constant('wait' as const), page: fc.constantFrom(1, 100, 300, 3000) }) },
  );

  it('no addition is lost if pages die, connections break, others write and levels are taken over', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(act, { minLength: 5, maxLength: 25 }), async (acts) => {
        const at = await browser();
        const pages = [await at.page(), await at.page()];
        for (const { workspace } of pages) await workspace.open('07');
        const added: number[] = [];
        for (const { what, page } of acts) {
          const one = pages[page];
          if (what === 'wait') await at.clock.pass(page);
          else if (what === 'others') {
            added.push(added.length + 1);
            await at.byOthers((file) => ({ ...file, minerals: [...(file.minerals ?? []), { x: added.length, y: 0 }] }));
          } else if (what === 'edit') {
            added.push(added.length + 1);
            opened(one.workspace)?.level.change('Add', addObject('mineral', added.length, 0));
            // the journal stores it after a moment
            await breathe();
          } else if (what === 'cut') one.line.isCut = true;
          else if (what === 'lose answers') one.line.losesAnswers = true;
          else if (what === 'mend') {
            one.line.isCut = false;
            one.line.losesAnswers = false;
            one.line.link('up');
          } else if (what === 'take over') opened(one.workspace)?.lock.takeOver();
          // what a page holds that may not write goes with it
          else if (what === 'kill' && opened(one.workspace)?.holding.getState() !== true) {
            one.kill();
            pages[page] = await at.page();
            await breathe();
            await pages[page].workspace.open('07');
          }
        }
        for (const { line } of pages) {
          line.isCut = false;
          line.losesAnswers = false;
          line.link('up');
        }
        await at.clock.pass(30_000);
        // changes that a page could not hand over in time are written once the page may write again
        for (const { workspace } of pages) {
          opened(workspace)?.lock.takeOver();
          await at.clock.pass(30_000);
        }
        const places = (await at.file()).minerals?.map(({ x }) => x) ?? [];
        expect(places.sort((a, b) => a - b)).toEqual(added);
        for (const { workspace } of pages) expect(['saved', 'readOnly']).toContain(saveState(workspace));
      }),
      { numRuns: 50 },
    );
  });
});
