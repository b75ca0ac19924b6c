import { createStore } from 'zustand/vanilla';
import { createCommands } from '../commands/index.ts';
import type { Analysis, Editor, OpenLevel } from '../context/index.ts';
import { createSelection, type ObjectKey } from '../document/index.ts';
import { createWorkspace, type Link, type OpenedLevel, pageSurroundings, pageTimers } from '../files/index.ts';
import { createNotices } from '../notices/index.ts';
import { attemptGhosts, createAttempts } from '../play/index.ts';
import { createProofStore } from '../proof/index.ts';
import { createSession } from '../session/index.ts';
import { createSettings } from '../settings/index.ts';
import { createWorkers, spawnPageWorker } from '../workers/index.ts';

/** The page's storage, or null where the browser refuses one. */
function pageStorage(): Storage | null {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}

/** What hangs on a level while it is open, all of it made from the level. @returns with what takes it down */
function openParts(editor: Editor, opened: OpenedLevel): { level: OpenLevel; close: () => void } {
  const { session, settings } = editor;
  const document = opened.level;
  const selection = createSelection(document);
  const proof = createProofStore(document, settings.getState().accuracy);
  const attempts = createAttempts();
  const ghosts = createStore<ReturnType<typeof attemptGhosts>>(() => []);
  const stops = [
    session.subscribe((now, before) => {
      if (now.run !== before.run) proof.showRun(now.run);
      if (now.accuracy !== before.accuracy) proof.setAccuracy(now.accuracy);
    }),
    settings.subscribe(({ accuracy }) => {
      if (accuracy !== session.getState().accuracy) session.setState({ accuracy });
    }),
    attempts.store.subscribe((all) => {
      const others = ghosts.getState().filter(({ look }) => look !== 'attempt');
      ghosts.setState([...others, ...attemptGhosts(all)], true);
    }),
  ];
  session.setState({ run: null, tick: 0, hoverTick: null, rolling: false, mode: 'edit', accuracy: settings.getState().accuracy });
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
  const close = () => {
    for (const stop of stops) stop();
    selection.close();
    proof.close();
  };
  return { level, close };
}

/** What to do where the folder can't be reached. */
const LINKS: Readonly<Record<Exclude<Link, 'up'>, string>> = {
  gone: 'gq edit does not answer. Start it again in the same folder and open the address that it prints. What you do meanwhile is kept in this browser.',
  otherRun:
    'gq edit was started again, and this page belongs to the run before: it can save nothing any more. Open the address that gq edit prints now; ' +
    'what is not saved is kept in this browser and comes along.',
};

/** Builds the editor of this page: settings, session, journal, and the levels of `gq edit` or, without it, of this browser. */
export async function createEditor(): Promise<Editor> {
  const settings = createSettings(pageStorage());
  const surroundings = await pageSurroundings(window);
  const workspace = createWorkspace(surroundings);
  const notices = createNotices();
  const { journal } = surroundings;
  const tellJournal = () => {
    const state = journal.state.getState();
    if (state.kind === 'working') notices.settle('journal');
    else notices.show('warning', `${state.message}. ${state.hint}`, { topic: 'journal' });
  };
  journal.state.subscribe(tellJournal);
  tellJournal();
  workspace.store.subscribe(({ link }, before) => {
    if (link === before.link) return;
    if (link === 'up') notices.settle('server');
    else notices.show('warning', LINKS[link], { topic: 'server' });
  });
  const editor: Editor = {
    settings,
    session: createSession(settings.getState().accuracy),
    commands: createCommands(),
    notices,
    workspace,
    workers: createWorkers({ spawn: spawnPageWorker, after: pageTimers.after }),
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
    const parts = openParts(editor, opened);
    last = { opened, close: parts.close };
    editor.open.setState(parts.level, true);
  });
  return editor;
}
