import { element, icon, iconButton } from './dom.ts';
import type { PlayableEntry } from './pack.ts';
import type { GhostChoice, Settings } from './settings.ts';
import { starRow } from './stars.ts';
import { timeText } from './words.ts';

export const GHOSTS_IN_WORDS: Readonly<Record<GhostChoice, string>> = {
  best: 'your best play',
  all: "your best play and the level's own run",
  none: 'none',
};

export interface HudActions {
  leave(): void;
  toggleMute(): void;
  cycleGhosts(): void;
  again(): void;
  pause(): void;
}

/** The bar above a level: its name, what has been reached, and what can be done. */
export class Hud {
  readonly root: HTMLElement;
  private readonly name = element('h1', { class: 'level-name' });
  private readonly stars = element('span', { class: 'hud-stars' });
  private readonly clock = element('span', { class: 'numbers clock' });
  private readonly attempts = element('span', { class: 'numbers attempts' });
  private readonly mute: HTMLButtonElement;
  private readonly ghosts: HTMLButtonElement;

  constructor(actions: HudActions) {
    this.mute = iconButton('sound', '', actions.toggleMute);
    this.mute.classList.add('mute');
    this.ghosts = iconButton('ghost', '', actions.cycleGhosts);
    this.ghosts.classList.add('ghosts');
    this.root = element(
      'header',
      { class: 'hud' },
      iconButton('levels', 'Levels', actions.leave, 'L'),
      this.name,
      element('div', { class: 'figures' }, this.stars, this.clock, this.attempts),
      element(
        'div',
        { class: 'tools' },
        this.ghosts,
        this.mute,
        iconButton('again', 'Again', actions.again, 'R'),
        iconButton('pause', 'Pause', actions.pause, 'Esc'),
      ),
    );
  }

  showLevel({ number, level }: PlayableEntry): void {
    this.name.replaceChildren(element('span', { class: 'number numbers' }, String(number).padStart(2, '0')), ` ${level.name}`);
  }

  showSettings({ muted, ghosts }: Settings): void {
    const label = muted ? 'Sound on' : 'Sound off';
    this.mute.replaceChildren(icon(muted ? 'silent' : 'sound'));
    this.mute.setAttribute('aria-label', label);
    this.mute.title = `${label} (M)`;
    const ghostLabel = `Ghosts: ${GHOSTS_IN_WORDS[ghosts]}`;
    this.ghosts.setAttribute('aria-label', ghostLabel);
    this.ghosts.title = `${ghostLabel} (G)`;
    this.ghosts.classList.toggle('off', ghosts === 'none');
    this.ghosts.classList.toggle('all', ghosts === 'all');
  }

  /** @param attempt null: a play is watched */
  showAttempt(attempt: number | null): void {
    this.attempts.textContent = attempt === null ? 'watching' : `attempt ${attempt}`;
  }

  showStars(lit: number, all: number): void {
    this.stars.replaceChildren(...(all > 0 ? [starRow(lit, all)] : []));
  }

  showTime(seconds: number, digits: number): void {
    this.clock.textContent = timeText(seconds, digits);
  }
}
