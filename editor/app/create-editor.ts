import { createStore } from 'zustand/vanilla';
import type { LevelFile } from '../../schema/index.ts';
import { after, afterRest } from '../core/ask/index.ts';
import { attemptsAt } from '../core/attempts/index.ts';
import { createCommands } from '../core/commands/index.ts';
import { type Analysis, attemptGhosts, type Editor, type OpenLevel, putGhosts } from '../core/context/index.ts';
import { createSelection, type ObjectKey } from '../core/document/index.ts';
import {
  createOpeningMarks,
  createWorkspace,
  errorInWords,
  type LevelStorage,
  type Link,
  type OpenedLevel,
  pageSurroundings,
  tabName,
} from '../core/files/index.ts';
import { openHeldBack } from '../core/levels/index.ts';
import { createNotices } from '../core/notices/index.ts';
import { createProofStore } from '../core/proof/index.ts';
import { createSession } from '../core/session/index.ts';
import { createSettings } from '../core/settings/index.ts';
import { createPageTerms } from '../core/terms/index.ts';
import { FEATURES } from '../features/index.ts';
import { createWorkers, spawnPageWorker } from '../workers/index.ts';
import { followConfiguration } from './follow-configuration.ts';
import { LAYERS } from './layers.ts';

/** A storage of the page, or null where the browser refuses access. */
function pageStorage(name: 'localStorage' | 'sessionStorage'): Storage | null {
  try {
    return window[name];
  } catch {
    return null;
  }
}

/** Makes everything that belongs to an open level. @returns the level and the function that closes it */
function openParts(editor: Editor, opened: OpenedLevel): { level: OpenLevel; close: () => void } {
  const { session, terms } = editor;
  const document = opened.level;
  const selection = createSelection(document);
  const proof = createProofStore(document, terms.getState().shown, {
    checked: !editor.unchecked.has(opened.id()),
    afterRest,
  });
  const attempts = attemptsAt(document);
  const ghosts = createStore<ReturnType<typeof attemptGhosts>>(() => attemptGhosts(attempts.store.getState()));
  const stops = [
    session.subscribe((now, before) => {
      if (now.run !== before.run) proof.showRun(now.run);
    }),
    terms.subscribe((now, before) => {
      if (now.shown !== before.shown) proof.setTerms(now.shown);
    }),
    attempts.store.subscribe((all) => putGhosts(ghosts, 'attempt', attemptGhosts(all))),
  ];
  session.setState({
    run: null,
    tick: 0,
    hoverTick: null,
    isPlayingBack: false,
    mode: 'edit',
    lookAt: null,
    renaming: null,
    openNote: null,
  });
  const level: OpenLevel = {
    opened,
    document,
    selection,
    hovered: createStore<ObjectKey | null>(() => null),
    proof,
    attempts,
    ghosts,
    analysis: createStore<Analysis | null>(() => null),
    playtest: createStore<ReturnType<OpenLevel['playtest']['getState']>>(() => null),
  };
  stops.push(...FEATURES.flatMap(({ open }) => open?.(editor, level) ?? []));
  const close = () => {
    for (const stop of stops) stop();
    selection.close();
    proof.close();
  };
  return { level, close };
}

/** What to do when the folder can't be reached, and where unsaved work is kept: browsers keep it per host and port. */
function linkInWords(link: Exclude<Link, 'up'>, isKept: boolean): string {
  const { host, port } = window.location;
  const gone = 'gq edit does not answer. Start it again in the same folder and open the address that it prints.';
  const other = 'gq edit was restarted, and this page belongs to the previous start: it can no longer save.';
  if (link === 'gone') {
    const kept = `Until then, your changes are kept in this browser for ${host}. They are not found under another port: start with gq edit --port ${port} to use this one.`;
    return `${gone} ${isKept ? kept : 'Your changes are lost when this page is closed: download the level first.'}`;
  }
  const comes = `Open the address that gq edit prints now. Unsaved changes are kept in this browser for ${host} and are restored if the new address has the same host and port.`;
  return `${other} ${isKept ? comes : 'Unsaved changes are lost when this page is closed: download the level, then open the address that gq edit prints now.'}`;
}

/**
 * ms that the page must stay responsive after a level is drawn. Work that starts once the level rests begins within this time.
 */
const ALIVE = 700;

/** Calls back once the page is drawn and has stayed responsive for `ALIVE` ms. @returns cancels it */
function onceDrawn(call: () => void): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let frame = requestAnimationFrame(() => {
    frame = requestAnimationFrame(() => {
      timer = setTimeout(call, ALIVE);
    });
  });
  return () => {
    cancelAnimationFrame(frame);
    clearTimeout(timer);
  };
}

/** Called when the browser's database answers late: offers its levels together with those made in the meantime. */
function offerLateLevels(editor: Editor, found: LevelStorage): void {
  const { workspace, notices } = editor;
  const takeOver = async () => {
    await workspace.store.getState().opened?.saver.flush();
    const list = await workspace.storage.list();
    const there = await found.list();
    if (!list.ok || !there.ok) return;
    const ids = new Set(there.value.levels.map(({ id }) => id));
    for (const { id } of list.value.levels) {
      const read = await workspace.storage.read(id);
      if (!read.ok || read.value.text === null) continue;
      let name = id;
      for (let i = 2; ids.has(name); i++) name = `${id}-${i}`;
      const written = await found.write(name, read.value.text, null);
      if (!written.ok) {
        notices.show('error', errorInWords(written.error), { topic: 'late' });
        return;
      }
      ids.add(name);
    }
    window.location.reload();
  };
  const text =
    'The browser’s database is available now. It may have levels that are not listed here. The levels of this page will be added to them.';
  notices.show('warning', text, {
    topic: 'late',
    actions: [{ title: 'Add them and reload', run: () => void takeOver() }],
  });
}

/**
 * Builds the editor of this page: settings, session, journal, and the levels of `gq edit` or, without a server, of this
 * browser.
 */
export async function createEditor(): Promise<Editor> {
  const settings = createSettings(pageStorage('localStorage'));
  const { lateLevels, attempts, ...surroundings } = await pageSurroundings(window);
  const workspace = createWorkspace(surroundings);
  const notices = createNotices();
  const { journal, versions } = surroundings;
  let reportedLink = '';
  const tellLink = (link: Link) => {
    const text = link === 'up' ? '' : linkInWords(link, journal.state.getState().kind === 'working');
    if (text === reportedLink) return;
    reportedLink = text;
    if (text === '') notices.settle('server');
    else notices.show('warning', text, { topic: 'server' });
  };
  const tellJournal = () => {
    const state = journal.state.getState();
    tellLink(workspace.store.getState().link);
    if (state.kind === 'working') notices.settle('journal');
    else notices.show('warning', `${state.message}. ${state.hint}`, { topic: 'journal' });
  };
  journal.state.subscribe(tellJournal);
  tellJournal();
  workspace.store.subscribe(({ link }, before) => {
    if (link !== before.link) tellLink(link);
  });
  const editor: Editor = {
    settings,
    terms: createPageTerms(workspace, settings),
    session: createSession(LAYERS),
    commands: createCommands(),
    notices,
    workspace,
    journal,
    versions,
    attempts,
    marks: createOpeningMarks(pageStorage('localStorage'), tabName(pageStorage('sessionStorage'))),
    incoming: createStore<LevelFile | null>(() => null),
    heldBack: createStore<string | null>(() => null),
    unchecked: new Set(),
    desk: { workers: createWorkers({ spawn: spawnPageWorker, after }), afterRest, after },
    open: createStore<OpenLevel | null>(() => null),
  };
  let last: { opened: OpenedLevel; close: () => void } | null = null;
  workspace.store.subscribe(({ opened }) => {
    if (opened === (last?.opened ?? null)) return;
    last?.close();
    if (opened === null) {
      last = null;
      editor.open.setState(null, true);
      return;
    }
    const place = `${workspace.store.getState().list?.folder.id ?? ''}/${opened.id()}`;
    editor.marks.set(place);
    const parts = openParts(editor, opened);
    attempts.follow(place, parts.level.attempts);
    const cancel = onceDrawn(() => editor.marks.clear(place));
    const close = () => {
      cancel();
      editor.marks.clear(place);
      parts.close();
    };
    if (editor.unchecked.has(opened.id())) {
      const on = () => void openHeldBack(editor, opened.id(), true);
      notices.show('warning', 'Checks are off for this level: it is not simulated and has no verdict.', {
        topic: 'unchecked',
        actions: [{ title: 'Turn checks on', run: on }],
      });
    } else notices.settle('unchecked');
    last = { opened, close };
    editor.open.setState(parts.level, true);
  });
  workspace.onMoved(attempts.moved);
  followConfiguration(editor);
  window.addEventListener('pagehide', editor.marks.leave);
  document.addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && versions.flush());
  void lateLevels?.then((found) => offerLateLevels(editor, found));
  return editor;
}
