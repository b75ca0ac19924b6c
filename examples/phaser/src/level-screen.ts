import type { Best, PlayEnding, PlayEvent } from 'gravity-quest-toolkit/game';
import { createRunner, type Runner, type Skin } from 'gravity-quest-toolkit/phaser';
import { element, textButton } from './dom.ts';
import { ghostsOf, type Hold, type Rival } from './ghosts.ts';
import { GHOSTS_IN_WORDS, Hud } from './hud.ts';
import type { PlayableEntry, Terms } from './pack.ts';
import { Panel } from './panel.ts';
import type { Progress } from './progress.ts';
import { GHOST_CHOICES, type Settings } from './settings.ts';
import { shareButtons } from './sharing.ts';
import type { Sound } from './sound.ts';
import { createStage, type Stage } from './stage.ts';
import { starRow } from './stars.ts';
import { count, endText, raceText, timeText } from './words.ts';

/** ms from a death to the next attempt; a press shortens it */
const RESTART_AFTER = 900;
/** ms from the end to the panel: long enough to see her arrive */
const PANEL_AFTER = 750;
/** Changes of the shown time per second. */
const CLOCK_RATE = 10;

const GHOST_NAMES = { best: 'Ghost: best play', all: 'Ghosts: all', none: 'Ghosts: none' } as const;

/** What moves without being part of the level is left out for those who want reduced motion. */
const CALM_SKIN: Partial<Skin> = { trail: () => null, effects: () => null };
const isCalm = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;

export interface LevelActions {
  /** Back to the menu. */
  leave(): void;
  /** The level after this one that can be played; null if there is none. */
  nextOf(entry: PlayableEntry): PlayableEntry | null;
  play(entry: PlayableEntry): void;
  toggleMute(): void;
  say(text: string): void;
  /** The address of this page with a play in its fragment. */
  linkTo(play: string): string;
}

/** How a level is played: by a person, or by holds that are given. */
export interface Visit {
  /** Holds to watch instead of playing. */
  readonly watched?: readonly Hold[] | null;
  /** Holds that play in place of a person, and count. */
  readonly script?: readonly Hold[] | null;
  /** A run that is raced against. */
  readonly rival?: Rival | null;
}

export interface Look {
  /** `webgl` or `canvas`; null: what is faster. */
  readonly renderer: string | null;
  readonly terms: Terms;
}

interface Recorded {
  /** The best play before this one. */
  readonly before: Best | null;
  readonly isBest: boolean;
}

type State = 'intro' | 'playing' | 'paused' | 'dead' | 'completed';

/** The screen on which a level is played. */
export class LevelScreen {
  readonly root: HTMLElement;
  private readonly place = element('div', { class: 'stage', tabindex: -1, role: 'application' });
  private readonly hud: Hud;
  private readonly toast = element('p', { class: 'toast' });
  private readonly hint = element('div', { class: 'hint' });
  private readonly panel = new Panel(() => this.back());
  private readonly observer = new ResizeObserver(() => this.stage?.resize());
  private stage: Stage | null = null;
  private runner: Runner | null = null;
  private entry: PlayableEntry | null = null;
  private visit: Visit = {};
  private state: State = 'intro';
  private attempt = 1;
  private panelTimer = 0;
  private shownClock = -1;
  private opening = 0;

  constructor(
    private readonly progress: Progress,
    private readonly settings: Settings,
    private readonly sound: Sound,
    private readonly actions: LevelActions,
    private readonly look: Look,
  ) {
    this.hud = new Hud({
      leave: actions.leave,
      toggleMute: actions.toggleMute,
      cycleGhosts: () => this.cycleGhosts(),
      again: () => this.again(),
      pause: () => this.pause(),
    });
    this.root = element(
      'main',
      { class: 'level', hidden: true },
      this.place,
      this.hud.root,
      this.hint,
      this.toast,
      this.panel.root,
    );
    this.place.addEventListener('pointerdown', () => this.begin());
    // a gamepad clicks what has the focus
    this.place.addEventListener('click', () => this.begin());
    // the space bar is the gun again, and presses no button of the bar
    this.hud.root.addEventListener('click', () => this.focus());
    this.root.addEventListener('contextmenu', (event) => event.preventDefault());
    document.addEventListener('visibilitychange', () => {
      if (document.hidden) this.pause();
    });
  }

  get isOpen(): boolean {
    return this.entry !== null;
  }

  /** The level that is open. */
  get current(): PlayableEntry | null {
    return this.entry;
  }

  /** Whether a gamepad plays; otherwise it moves the focus. */
  get isPlaying(): boolean {
    return this.isOpen && !this.panel.isOpen && this.state !== 'intro';
  }

  /** Starts Phaser, if it has not been started: before the first level, or when the page has nothing else to do. */
  prepare(): Stage {
    if (this.stage === null) {
      const stage = createStage(this.place, this.look.renderer);
      this.stage = stage;
      this.observer.observe(this.place);
      void stage.scene.then(() => {
        if (!this.isOpen) stage.sleep();
      });
    }
    return this.stage;
  }

  /** Opens a level. */
  async open(entry: PlayableEntry, visit: Visit = {}): Promise<void> {
    const opening = ++this.opening;
    this.root.hidden = false;
    this.closePanel();
    this.entry = entry;
    this.visit = visit;
    this.attempt = 1;
    this.hud.showLevel(entry);
    this.hud.showSettings(this.settings);
    this.place.setAttribute('aria-label', `${entry.level.name}: hold Space, or press and hold anywhere, to fire the gun`);
    const stage = this.prepare();
    stage.wake();
    stage.resize();
    const scene = await stage.scene;
    if (opening !== this.opening) return;
    this.runner?.destroy();
    this.runner = createRunner(scene, entry.level, {
      ...this.look.terms,
      area: () => this.area(),
      skin: isCalm() ? CALM_SKIN : {},
      restartAfter: visit.watched == null ? RESTART_AFTER : null,
      replay: visit.watched ?? visit.script ?? null,
      ghosts: this.ghostsNow(),
      onEvent: (event) => this.onEvent(event),
      onEnd: (ending) => this.onEnd(ending),
      onRestart: () => this.onRestart(),
    });
    scene.onFrame = () => this.onFrame();
    this.showAttempt();
    this.showIntro();
    this.focus();
  }

  /** Shows a play that somebody has sent, and offers a race. */
  async invite(entry: PlayableEntry, rival: Rival, script: readonly Hold[] | null): Promise<void> {
    await this.open(entry, { rival });
    const { claim } = rival;
    const all = entry.level.minerals.length;
    const stars = all > 0 ? ` with ${Math.min(all, claim.minerals)} of ${count(all, 'star')}` : '';
    const how = claim.outcome === 'completed' ? 'reaches the black hole' : 'does not reach the black hole';
    this.panel.show({
      title: 'Race this play',
      body: [element('p', {}, `${entry.level.name}: it ${how}, ${timeText(claim.tick / 60)}${stars}.`)],
      buttons: [
        textButton('play', 'Race it', () => void this.open(entry, { rival, script }), 'primary'),
        textButton('watch', 'Watch it', () => void this.open(entry, { rival, watched: rival.holds })),
        textButton('levels', 'Levels', () => this.actions.leave()),
      ],
    });
  }

  /** Leaves the level. */
  close(): void {
    this.opening++;
    this.entry = null;
    this.root.hidden = true;
    this.closePanel();
    this.runner?.destroy();
    this.runner = null;
    this.sound.rest();
    this.stage?.sleep();
  }

  /** Shows changed settings. */
  showSettings(): void {
    this.hud.showSettings(this.settings);
  }

  /** A key that concerns the level. @returns whether it did something */
  key(name: string): boolean {
    switch (name.toLowerCase()) {
      case 'r':
        this.again();
        return true;
      case 'n':
        this.next();
        return true;
      case 'g':
        this.cycleGhosts();
        return true;
      case 'l':
        this.actions.leave();
        return true;
      case 'p':
      case 'escape':
        this.back();
        return true;
      case ' ':
      case 'enter':
      case 'arrowup':
        if (this.state !== 'intro' || this.panel.isOpen) return false;
        this.begin();
        return true;
      default:
        return false;
    }
  }

  /** One step back: from the play to the pause, from the pause to the play, from anything else to the menu. */
  back(): void {
    if (this.state === 'paused') this.resume();
    else if (this.state === 'completed' || this.state === 'intro' || this.panel.isOpen) this.actions.leave();
    else this.pause();
  }

  /** Pauses, if she flies. */
  pause(): void {
    const { runner } = this;
    if ((this.state !== 'playing' && this.state !== 'dead') || this.panel.isOpen || runner === null) return;
    runner.pause();
    this.sound.rest();
    this.setState('paused');
    this.showPause();
  }

  private resume(): void {
    const { runner } = this;
    if (this.state !== 'paused' || runner === null) return;
    this.closePanel();
    this.setState(runner.player.ending === null ? 'playing' : 'dead');
    runner.resume();
    this.focus();
  }

  private again(): void {
    const { runner } = this;
    if (runner === null) return;
    this.closePanel();
    this.hint.hidden = true;
    // the best play may be another one now
    runner.player.restart({ ghosts: this.ghostsNow() });
    runner.restart();
    runner.resume();
    this.focus();
  }

  private next(): void {
    const next = this.entry === null ? null : this.actions.nextOf(this.entry);
    if (next !== null) this.actions.play(next);
  }

  private cycleGhosts(): void {
    const { settings, runner } = this;
    settings.ghosts = GHOST_CHOICES[(GHOST_CHOICES.indexOf(settings.ghosts) + 1) % GHOST_CHOICES.length];
    this.hud.showSettings(settings);
    this.actions.say(`Ghosts: ${GHOSTS_IN_WORDS[settings.ghosts]}`);
    if (runner === null) return;
    // the play goes on with other ghosts
    const { player } = runner;
    const moment = player.snapshot();
    player.restart({ ghosts: this.ghostsNow() });
    player.restore(moment);
  }

  /** The first press starts the time. */
  private begin(): void {
    if (this.state !== 'intro' || this.panel.isOpen) return;
    this.hint.hidden = true;
    this.setState('playing');
    this.runner?.resume();
  }

  private focus(): void {
    if (!this.panel.isOpen) this.place.focus();
  }

  /** The part of the canvas that shows the level: what the bar leaves. */
  private area(): { x: number; y: number; width: number; height: number } {
    const ratio = this.stage?.ratio ?? 1;
    const { clientWidth, clientHeight } = this.place;
    const top = this.hud.root.offsetHeight;
    return { x: 0, y: top * ratio, width: clientWidth * ratio, height: Math.max(1, clientHeight - top) * ratio };
  }

  private ghostsNow() {
    const { entry, visit, settings, progress } = this;
    if (entry === null) return [];
    return ghostsOf(entry.level, progress.bestHolds(entry.id), settings.ghosts, visit.rival ?? null);
  }

  private setState(state: State): void {
    this.state = state;
    this.root.dataset.state = state;
  }

  private showAttempt(): void {
    this.root.dataset.attempt = String(this.attempt);
    this.hud.showAttempt(this.visit.watched == null ? this.attempt : null);
    this.shownClock = -1;
    this.showStars();
  }

  private showStars(): void {
    const { entry, runner } = this;
    if (entry === null || runner === null) return;
    const { minerals } = entry.level;
    const lit = runner.player.collectedCount;
    this.root.dataset.stars = String(lit);
    this.hud.showStars(lit, minerals.length);
  }

  private showIntro(): void {
    const { entry, visit, runner, hint } = this;
    if (entry === null || runner === null) return;
    hint.hidden = visit.watched != null || visit.script != null;
    if (hint.hidden) {
      this.setState('playing');
      return;
    }
    runner.pause();
    this.setState('intro');
    hint.replaceChildren(
      element('p', {}, entry.level.description),
      element('p', { class: 'hint-how' }, 'Press and hold anywhere, or hold Space'),
      element('p', { class: 'hint-turn' }, 'Turn the phone for a larger view.'),
    );
    this.actions.say(`${entry.level.name}. ${entry.level.description} Hold Space to fire the gun; the time starts with it.`);
  }

  private onFrame(): void {
    const { runner, sound, hud } = this;
    if (runner === null) return;
    const { player } = runner;
    const { state, time } = player;
    if (this.state === 'playing') sound.gun(player.held, Math.sqrt(state[2] * state[2] + state[3] * state[3]));
    const clock = Math.floor(CLOCK_RATE * time);
    if (clock === this.shownClock || player.ending !== null) return;
    this.shownClock = clock;
    hud.showTime(clock / CLOCK_RATE, 1);
  }

  private onEvent({ event }: PlayEvent): void {
    const { sound, runner } = this;
    if (event.type === 'target') sound.target();
    else if (event.type === 'wake') sound.wake();
    else if (event.type === 'explosion') sound.explosion();
    else if (event.type === 'effect') sound.passage();
    else if (event.type === 'mineral') {
      const collected = runner?.player.mineralCount ?? 1;
      sound.mineral(collected);
      this.showStars();
      this.actions.say(`Star ${collected}`);
    }
  }

  private onEnd(ending: PlayEnding): void {
    const { sound, visit } = this;
    const isCompleted = ending.outcome === 'completed';
    sound.rest();
    if (isCompleted) sound.completion();
    else sound.death();
    this.hud.showTime(this.playedTime, 2);
    this.setState(isCompleted ? 'completed' : 'dead');
    if (visit.watched != null) this.panelTimer = window.setTimeout(() => this.showWatched(ending), PANEL_AFTER);
    else if (isCompleted) {
      const recorded = this.record();
      this.panelTimer = window.setTimeout(() => this.showCompleted(recorded), PANEL_AFTER);
    } else {
      this.toast.textContent = endText(ending);
      this.actions.say(endText(ending));
    }
  }

  private onRestart(): void {
    this.attempt++;
    this.toast.textContent = '';
    this.setState('playing');
    this.showAttempt();
  }

  /** The time of the play, s. Plays are compared by whole ticks. */
  private get playedTime(): number {
    return (this.runner?.player.tick ?? 0) / 60;
  }

  private record(): Recorded {
    const { entry, runner, progress } = this;
    if (entry === null || runner === null) return { before: null, isBest: false };
    const before = progress.best(entry.id);
    return { before, isBest: progress.record(entry.id, runner.player) };
  }

  private closePanel(): void {
    window.clearTimeout(this.panelTimer);
    this.panel.close();
    this.toast.textContent = '';
  }

  private showPause(): void {
    const { entry, settings, panel, actions } = this;
    if (entry === null) return;
    panel.show({
      title: 'Paused',
      body: [element('p', { class: 'quiet' }, entry.level.description)],
      buttons: [
        textButton('play', 'Resume', () => this.resume(), 'primary'),
        textButton('again', 'Again', () => this.again()),
        actions.nextOf(entry) === null ? null : textButton('next', 'Next', () => this.next()),
        textButton('levels', 'Levels', () => actions.leave()),
        textButton(settings.muted ? 'silent' : 'sound', settings.muted ? 'Sound is off' : 'Sound is on', () => {
          actions.toggleMute();
          this.showPause();
        }),
        textButton('ghost', GHOST_NAMES[settings.ghosts], () => {
          this.cycleGhosts();
          this.showPause();
        }),
      ],
    });
  }

  private showCompleted({ before, isBest }: Recorded): void {
    const { entry, runner, visit, actions } = this;
    if (entry === null || runner === null) return;
    const { player } = runner;
    const { holds } = player;
    const all = entry.level.minerals.length;
    const collected = player.collectedCount;
    const best =
      before === null
        ? 'Completed for the first time'
        : `${isBest ? 'New best, before it was' : 'Best'} ${timeText(before.tick / 60)}`;
    const race = visit.rival == null ? [] : [raceText(player.tick, visit.rival)];
    const next = actions.nextOf(entry);
    this.panel.show({
      title: next === null && before === null ? 'Completed, and that was the last level!' : 'Completed',
      body: [
        ...(all > 0 ? [element('p', { class: 'big-stars' }, starRow(collected, all))] : []),
        element('p', { class: 'big-time numbers' }, timeText(this.playedTime)),
        ...[best, ...race].map((fact) => element('p', { class: isBest ? 'good' : 'quiet' }, fact)),
      ],
      buttons: [
        next === null ? null : textButton('next', 'Next level', () => this.next(), 'primary'),
        textButton('again', 'Again', () => this.again(), next === null ? 'primary' : ''),
        textButton('watch', 'Watch', () => void this.open(entry, { ...visit, watched: holds })),
        textButton('levels', 'Levels', () => actions.leave()),
      ],
      below: shareButtons(player, entry.id.replaceAll('/', '-'), actions.linkTo),
    });
    const stars = all > 0 ? ` with ${collected} of ${count(all, 'star')}` : '';
    actions.say(`Completed in ${timeText(this.playedTime)}${stars}. ${[best, ...race].join('. ')}.`);
  }

  private showWatched(ending: PlayEnding): void {
    const { entry, visit, actions } = this;
    if (entry === null) return;
    const { rival = null } = visit;
    this.panel.show({
      title: endText(ending),
      body: [element('p', { class: 'big-time numbers' }, timeText(this.playedTime))],
      buttons: [
        textButton('play', rival === null ? 'Play' : 'Race it', () => void this.open(entry, { rival }), 'primary'),
        textButton('watch', 'Watch again', () => this.again()),
        textButton('levels', 'Levels', () => actions.leave()),
      ],
    });
  }
}
