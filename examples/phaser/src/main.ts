import './style.css';
import { element } from './dom.ts';
import { LevelScreen } from './level-screen.ts';
import { levelInLink, partOf, playInLink, type ReadPlay, readPlay, readPlayText } from './links.ts';
import { createMenu } from './menu.ts';
import { isPlayable, type PackReading, type PlayableEntry, readPack } from './pack.ts';
import { followGamepads } from './pads.ts';
import { createProgress } from './progress.ts';
import { readSettings, SafeStore } from './settings.ts';
import { createSound } from './sound.ts';

/** A `.gqr` file is much smaller, bytes. */
const LARGEST_FILE = 1_000_000;

/** `?replay`: levels play themselves, by the run of this name or their first. `?renderer=canvas|webgl`: what draws. */
const query = new URLSearchParams(location.search);

/** The pack of the page; if the link has a level, that level alone. */
async function findPack(): Promise<{ pack: PackReading; notices: string[]; isLinked: boolean }> {
  const linked = await levelInLink(location.hash);
  if (linked !== null && 'level' in linked) {
    const { level, terms } = linked;
    const entries = [{ id: 'link', chapter: null, number: 1, level }];
    return { pack: { title: level.name, terms, entries, problem: null }, notices: [], isLinked: true };
  }
  const pack = readPack((globalThis as { GRAVITY_QUEST_PACK?: unknown }).GRAVITY_QUEST_PACK);
  return { pack, notices: linked === null ? [] : [linked.problem], isLinked: false };
}

async function start(): Promise<void> {
  const { pack, notices, isLinked } = await findPack();
  const playable = pack.entries.filter(isPlayable);
  document.title = pack.title;

  const live = element('div', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
  const say = (text: string) => {
    live.textContent = text;
  };
  const store = new SafeStore(() => {
    // the menu may not exist yet
    queueMicrotask(() =>
      menu.notice('This browser refuses to store anything here, so progress lasts until the page is closed.', 'note'),
    );
  });
  const settings = readSettings(store);
  const progress = createProgress(playable, pack.terms, store);
  const sound = createSound(settings);

  const toggleMute = () => {
    settings.muted = !settings.muted;
    if (settings.muted) sound.rest();
    screen.showSettings();
    if (!screen.isOpen) menu.refresh(null);
    say(settings.muted ? 'Sound off' : 'Sound on');
  };
  const scriptOf = (entry: PlayableEntry) => {
    if (!query.has('replay')) return null;
    const name = query.get('replay');
    return (entry.level.runs.find((run) => run.name === name) ?? entry.level.runs[0])?.holds ?? null;
  };
  const refuse = (entry: PlayableEntry) => (error: unknown) => {
    leave();
    const reason = error instanceof Error ? error.message : String(error);
    menu.notice(`${entry.level.name} can't be shown: ${reason}`, 'bad');
  };
  const show = (entry: PlayableEntry) => {
    menu.root.hidden = true;
    const replay = scriptOf(entry);
    screen.open(entry, { script: replay }).catch(refuse(entry));
  };
  const play = (entry: PlayableEntry) => {
    // "back" of the browser or the phone leads to the menu
    if (!screen.isOpen) history.pushState({ level: entry.id }, '');
    else history.replaceState({ level: entry.id }, '');
    show(entry);
  };
  const showMenu = () => {
    const last = screen.current?.id ?? null;
    screen.close();
    menu.root.hidden = false;
    menu.refresh(last);
  };
  const leave = () => {
    if (history.state?.level === undefined) showMenu();
    else history.back();
  };
  const take = (reading: ReadPlay) => {
    if ('problem' in reading) menu.notice(reading.problem, 'bad');
    else {
      const { entry, play: taken } = reading;
      if (!screen.isOpen) history.pushState({ level: entry.id }, '');
      menu.root.hidden = true;
      const rival = { name: 'the play of the link', holds: taken.holds, claim: taken.claim };
      screen.invite(entry, rival, scriptOf(entry)).catch(refuse(entry));
    }
  };

  const menu = createMenu(pack, progress, settings, {
    play,
    toggleMute,
    say,
    open: (file) => {
      if (file.size > LARGEST_FILE) menu.notice(`${file.name} is no play: it has ${file.size} bytes.`, 'bad');
      else void file.arrayBuffer().then((bytes) => take(readPlay(new Uint8Array(bytes), playable, pack.terms)));
    },
  });
  const screen = new LevelScreen(
    progress,
    settings,
    sound,
    {
      leave,
      play,
      toggleMute,
      say,
      nextOf: (entry) => {
        const next = playable[playable.indexOf(entry) + 1];
        return next !== undefined && menu.isOpen(next) ? next : null;
      },
      linkTo: (text) => {
        const page = location.href.replace(/#.*/, '');
        const kept = isLinked ? ['level', 'accuracy', 'max-time'].flatMap((key) => partOf(location.hash, key) ?? []) : [];
        return `${page}#${[...kept, `play=${text}`].join('&')}`;
      },
    },
    { renderer: query.get('renderer'), terms: pack.terms },
  );

  document.querySelector('#app')?.replaceChildren(menu.root, screen.root, live);
  if (pack.problem !== null) menu.notice(pack.problem, 'bad');
  for (const notice of notices) menu.notice(notice, 'bad');
  menu.refresh(null);

  // a page that is loaded again keeps its state, and begins with the menu
  history.replaceState(null, '');
  addEventListener('popstate', ({ state }) => {
    const entry = playable.find(({ id }) => id === state?.level);
    if (entry === undefined) showMenu();
    else show(entry);
  });
  addEventListener('hashchange', () => location.reload());
  addEventListener('keydown', (event) => {
    sound.unlock();
    if (event.altKey || event.ctrlKey || event.metaKey || event.target instanceof HTMLTextAreaElement) return;
    if (event.key === 'm' || event.key === 'M') toggleMute();
    else if (!screen.isOpen || event.repeat || !screen.key(event.key)) return;
    event.preventDefault();
  });
  addEventListener('pointerdown', () => sound.unlock());
  followGamepads({
    isPlaying: () => screen.isPlaying,
    pause: () => screen.pause(),
    back: () => screen.back(),
    wake: () => sound.unlock(),
  });

  const text = playInLink(location.hash);
  if (text !== null) take(readPlayText(text, playable, pack.terms));
  else if (isLinked) show(playable[0]);
  const idle = globalThis.requestIdleCallback ?? ((run: () => void) => setTimeout(run, 200));
  idle(() => screen.prepare());
}

void start();
