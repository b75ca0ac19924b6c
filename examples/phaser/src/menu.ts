import { element, icon, iconButton, textButton } from './dom.ts';
import { moveFocus, STEPS } from './focus.ts';
import { type Entry, isPlayable, type PackReading, type PlayableEntry } from './pack.ts';
import type { Progress } from './progress.ts';
import type { Settings } from './settings.ts';
import { starRow } from './stars.ts';
import { drawThumbnail, drawTitle } from './thumbnail.ts';
import { count, timeText } from './words.ts';

export interface MenuActions {
  play(entry: PlayableEntry): void;
  /** Reads a `.gqr` file. */
  open(file: File): void;
  toggleMute(): void;
  say(text: string): void;
}

export interface Menu {
  readonly root: HTMLElement;
  /** Whether a level may be played now. */
  isOpen(entry: PlayableEntry): boolean;
  /** Draws the list anew. @param focus the level whose card gets the focus; null: the first that is not completed */
  refresh(focus: string | null): void;
  /** Shows a message above the list. */
  notice(text: string, kind: 'bad' | 'note'): void;
}

/** Draws thumbnails when they come into sight, so that a pack of hundreds of levels opens at once. */
function lazily(): IntersectionObserver {
  const drawings = new IntersectionObserver(
    (seen) => {
      for (const { isIntersecting, target } of seen) {
        if (!isIntersecting) continue;
        drawings.unobserve(target);
        LEVELS.get(target)?.();
      }
    },
    { rootMargin: '200px' },
  );
  return drawings;
}
const LEVELS = new WeakMap<Element, () => void>();

/** The title page: the pack, what has been reached in it, and its levels. */
export function createMenu(pack: PackReading, progress: Progress, settings: Settings, actions: MenuActions): Menu {
  const playable = pack.entries.filter(isPlayable);
  const allStars = playable.reduce((sum, { level }) => sum + level.minerals.length, 0);
  const isOpen = (entry: PlayableEntry) => settings.allUnlocked || progress.isUnlocked(entry.id);

  const total = element('p', { class: 'total numbers' });
  const go = textButton('play', 'Play', () => {
    const entry = nextEntry();
    if (entry !== undefined) actions.play(entry);
  });
  go.classList.add('primary', 'large');
  const notices = element('div', { class: 'notices', role: 'alert' });
  const list = element('ol', { class: 'cards', 'aria-label': 'Levels' });
  const mute = element('button', { type: 'button', class: 'icon-button', click: () => actions.toggleMute() });
  const unlock = element('input', {
    type: 'checkbox',
    change: () => {
      settings.allUnlocked = unlock.checked;
      refresh(null);
      actions.say(unlock.checked ? 'All levels are unlocked.' : 'Levels unlock one after the other.');
    },
  });
  const file = element('input', {
    type: 'file',
    accept: '.gqr',
    class: 'unseen',
    tabindex: -1,
    'aria-hidden': 'true',
    change: () => {
      if (file.files?.[0] !== undefined) actions.open(file.files[0]);
      file.value = '';
    },
  });
  const hole = element('canvas', { class: 'hole', 'aria-hidden': 'true' });
  drawTitle(hole);
  let drawings = lazily();

  /** The first open level that is not completed; when all are, the first. */
  const nextEntry = (): PlayableEntry | undefined =>
    playable.find((entry) => isOpen(entry) && progress.best(entry.id) === null) ?? playable[0];

  const card = (entry: Entry): HTMLElement => {
    const number = element('span', { class: 'number numbers' }, String(entry.number).padStart(2, '0'));
    if (!isPlayable(entry)) {
      const text = element('span', { class: 'problem' }, `${entry.file}: ${entry.problem}`);
      const head = element('span', { class: 'card-head' }, number, element('span', { class: 'name' }, "Can't be played"));
      return element('div', { class: 'card broken' }, element('span', { class: 'picture' }, icon('warning')), head, text);
    }
    const { level } = entry;
    const best = progress.best(entry.id);
    const open = isOpen(entry);
    const canvas = element('canvas', { class: 'thumb', 'aria-hidden': 'true' });
    LEVELS.set(canvas, () => drawThumbnail(canvas, level));
    drawings.observe(canvas);
    const stars = level.minerals.length > 0 ? starRow(best?.minerals ?? null, level.minerals.length) : null;
    const time = best === null ? (open ? 'not completed' : 'locked') : timeText(best.tick / 60);
    return element(
      'button',
      {
        type: 'button',
        class: `card${best === null ? '' : ' done'}${open ? '' : ' locked'}`,
        'data-level': entry.id,
        'aria-disabled': open ? false : 'true',
        title: open ? level.description : 'Complete the level before it first.',
        click: () => {
          if (isOpen(entry)) actions.play(entry);
          else actions.say(`${level.name} is locked: complete the level before it first, or unlock all levels.`);
        },
      },
      element('span', { class: 'picture' }, canvas, open ? null : icon('lock')),
      element('span', { class: 'card-head' }, number, element('span', { class: 'name' }, level.name)),
      element('span', { class: 'card-foot' }, stars, element('span', { class: 'best numbers' }, time)),
    );
  };

  const refresh = (focus: string | null): void => {
    drawings.disconnect();
    drawings = lazily();
    list.replaceChildren(
      ...pack.entries.flatMap((entry, i) => {
        const item = element('li', {}, card(entry));
        const isNew = entry.chapter !== null && entry.chapter !== pack.entries[i - 1]?.chapter;
        return isNew
          ? [element('li', { class: 'chapter' }, element('h2', { class: 'chapter-name' }, entry.chapter)), item]
          : [item];
      }),
    );
    const completed = playable.filter(({ id }) => progress.best(id) !== null);
    const stars = completed.reduce((sum, { id }) => sum + (progress.best(id)?.minerals ?? 0), 0);
    total.textContent = `${completed.length} of ${count(playable.length, 'level')}${allStars > 0 ? ` · ★ ${stars} of ${allStars}` : ''}`;
    unlock.checked = settings.allUnlocked;
    mute.replaceChildren(icon(settings.muted ? 'silent' : 'sound'));
    mute.setAttribute('aria-label', settings.muted ? 'Turn the sound on' : 'Turn the sound off');
    mute.title = `${settings.muted ? 'Sound on' : 'Sound off'} (M)`;
    const next = nextEntry();
    go.hidden = next === undefined;
    if (next !== undefined) {
      const verb = completed.length === 0 ? 'Play' : completed.length === playable.length ? 'Play again' : 'Continue';
      go.lastElementChild?.replaceChildren(`${verb} · ${next.level.name}`);
    }
    const target = focus === null ? go : list.querySelector<HTMLElement>(`[data-level="${CSS.escape(focus)}"]`);
    target?.focus();
    target?.scrollIntoView({ block: 'nearest' });
  };

  const root = element(
    'main',
    { class: 'menu', 'aria-label': 'Menu' },
    element(
      'header',
      { class: 'hero' },
      hole,
      element(
        'div',
        { class: 'hero-text' },
        element('h1', {}, pack.title),
        element(
          'p',
          { class: 'tagline' },
          'One button. Hold it, and the nearest asteroid pulls you. Let go, and drift into the black hole.',
        ),
        element('div', { class: 'hero-row' }, go, mute, total),
      ),
    ),
    notices,
    list,
    element(
      'footer',
      {},
      element('label', {}, unlock, ' unlock all levels'),
      element(
        'span',
        {},
        file,
        textButton('open', 'Open a play (.gqr)', () => file.click(), 'quiet'),
      ),
      element('p', { class: 'keys' }, 'Space, click or touch: gun · R: again · Esc: pause · M: sound · arrows and Enter: menu'),
    ),
  );

  root.addEventListener('keydown', (event) => {
    const step = STEPS[event.key];
    if (step === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    moveFocus(root, step);
  });

  return {
    root,
    isOpen,
    refresh,
    notice(text, kind) {
      const close = iconButton('silent', 'Close', () => line.remove());
      close.replaceChildren('×');
      const line = element('p', { class: `notice ${kind}` }, element('span', {}, text), close);
      notices.append(line);
    },
  };
}
