import { createStore } from 'zustand/vanilla';
import type { LevelFile } from '../../../schema/index.ts';
import type { DocumentEvent, EditedLevel } from '../document/index.ts';
import { readText } from './read-text.ts';
import type { Saver } from './saver.ts';
import type { Timers } from './timers.ts';
import type { Shown } from './writer-lock.ts';

const WHY = 'another tab has this level open';

/** Labels of steps. */
const THEIRS = 'Changed in another tab';
const AS_THEIRS = 'As the other tab has it';

/** ms after which a state of the writer that arrived during a gesture is shown */
const AFTER_GESTURE = 100;

/**
 * A level that another page writes: it shows what the writer does. Once this page changes it, it holds the change, and shows the
 * writer's work no more, until the user has chosen: to take the level over, or to drop the change.
 */
export class WriterFollower {
  /** Whether the level has changes of this page, which wait for a choice. */
  readonly holding = createStore<boolean>(() => false);
  private isFollowing = false;
  /** The last state of the writer. */
  private latest: Shown | null = null;
  private isShowing = false;
  private cancel = () => {};

  constructor(
    private readonly level: EditedLevel,
    private readonly saver: Saver,
    private readonly timers: Timers,
  ) {}

  /** Another page is the writer. @param hasOwn whether the level has changes of this page */
  begin(hasOwn: boolean): void {
    this.isFollowing = true;
    this.latest = null;
    this.hold(hasOwn);
  }

  /** This page is the writer: what it holds, it writes. */
  end(): void {
    this.isFollowing = false;
    this.cancel();
    this.holding.setState(false, true);
  }

  /** The writer has changed the level. */
  show(shown: Shown): void {
    if (!this.isFollowing) return;
    this.latest = shown;
    this.showLatest(THEIRS);
  }

  /** The level has changed, and not because of the disk. */
  stepped({ before }: DocumentEvent): void {
    if (!this.isFollowing || this.isShowing) return;
    if (!this.holding.getState()) {
      // from here on, only what this page does counts as its change
      this.saver.restart({ file: before, etag: this.saver.base().etag });
      this.hold(this.saver.isUnsaved());
    } else if (!this.saver.isUnsaved()) {
      // the user has undone it
      this.hold(false);
      this.showLatest(THEIRS);
    }
  }

  /** Drops the changes of this page, as a step that can be undone: the level is again as its writer has it. */
  drop(): void {
    if (!this.holding.getState()) return;
    const { file } = this.saver.base();
    this.hold(false);
    if (!this.showLatest(AS_THEIRS)) this.replace(AS_THEIRS, file);
  }

  close(): void {
    this.cancel();
  }

  private hold(isHolding: boolean): void {
    this.saver.setReadOnly(WHY, !isHolding);
    this.holding.setState(isHolding, true);
  }

  private replace(label: string, file: LevelFile): void {
    this.isShowing = true;
    this.level.replace(label, file);
    this.isShowing = false;
  }

  /** @returns whether the level is as its writer has it */
  private showLatest(label: string): boolean {
    const { latest, level, saver } = this;
    if (latest === null || this.holding.getState()) return false;
    this.cancel();
    if (level.gesture() !== null) {
      // the gesture may become a change to hold, and must not be cut off
      this.cancel = this.timers.after(AFTER_GESTURE, () => this.showLatest(label));
      return false;
    }
    const [theirs, disk] = [readText(latest.text), readText(latest.base.text)];
    if (!theirs.ok || !disk.ok) return false;
    this.replace(label, theirs.file);
    saver.restart({ file: disk.file, etag: latest.base.etag });
    return true;
  }
}
