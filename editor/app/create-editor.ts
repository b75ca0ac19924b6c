import { createStore } from 'zustand/vanilla';
import type { LevelFile } from '../../schema/index.ts';
import { after, afterRest } from '../core/ask/index.ts';
import { attemptsAt } from '../core/attempts/index.ts';
import { createCommands } from '../core/commands/index.ts';
import { type Analysis, attemptGhosts, type Editor, type OpenLevel, putGhosts } from '../core/context/index.ts';
import { createSelection, type ObjectKey } from '../core/document/index.ts';
import { createOpeningMarks, createWorkspace, type OpenedLevel, pageSurroundings, tabName } from '../core/files/index.ts';
import { openFirst, openHeldBack } from '../core/levels/index.ts';
import { createNotices } from '../core/notices/index.ts';
import { createProofStore } from '../core/proof/index.ts';
import { createSession } from '../core/session/index.ts';
import { createSettings } from '../core/settings/index.ts';
import { createPageTerms } from '../core/terms/index.ts';
import { FEATURES } from '../features/index.ts';
import { createWorkers, spawnPageWorker } from '../workers/index.ts';
import { followConfiguration, followSurroundings, offerLateLevels } from './page-notices.ts';
import { LAYERS } from './panels.tsx';

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
  followSurroundings(editor);
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
    } else notices.clear('unchecked');
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

/** The key of the level that was last open in this tab. */
const LAST_LEVEL = 'gravity-quest-last-level';

/**
 * Opens the place that the page's address names, or else the level that was last open in this tab, or else the first valid one.
 * Remembers each level opened from then on, and follows links to other places.
 */
export async function openFirstLevel(editor: Editor): Promise<void> {
  const { workspace } = editor;
  await workspace.start();
  const storage = pageStorage('sessionStorage');
  const last = storage?.getItem(LAST_LEVEL) ?? null;
  workspace.store.subscribe(({ opened }) => {
    if (opened === null) return;
    try {
      storage?.setItem(LAST_LEVEL, opened.id());
    } catch {
      // the storage is full
    }
  });
  for (const { openNamed } of FEATURES) if (await openNamed?.(editor)) return;
  await openFirst(editor, last);
}
