import { statSync } from 'node:fs';
import { type CheckedLevel, type checkFiles, cutAtBail } from '../check/index.ts';

interface Kept {
  readonly stamp: string;
  readonly level: CheckedLevel;
}

/** Keeps the reports of levels from one round to the next: only files that have changed since are checked again. */
export class Memory {
  private readonly kept = new Map<string, Kept>();
  private settings = '';
  private shownBefore = new Map<string, string>();
  private checkedNow = new Set<string>();
  private hasNews = true;

  /** Forgets all reports. */
  forget(): void {
    this.kept.clear();
  }

  /**
   * Checks files as `checkFiles` does, but takes the reports that are still good.
   * @param check checks the other files
   */
  readonly remembering =
    (check: typeof checkFiles): typeof checkFiles =>
    async (files, settings, jobs, onProgress, shortcuts = {}) => {
      const key = JSON.stringify(settings);
      if (key !== this.settings) this.forget();
      this.settings = key;
      // taken before the check: a change during it is seen in the next round
      const stamps = new Map(files.map((file) => [file, stampOf(file)]));
      const stale = files.filter((file) => this.kept.get(file)?.stamp !== stamps.get(file));
      this.checkedNow = new Set(stale);
      for (const file of stale) this.kept.delete(file);
      const checked = await check(stale, settings, jobs, onProgress, shortcuts);
      for (const level of checked.levels) this.kept.set(level.file, { stamp: stamps.get(level.file)!, level });
      const levels = files.map((file) => this.kept.get(file)?.level);
      const end = levels.indexOf(undefined);
      const known = cutAtBail((end < 0 ? levels : levels.slice(0, end)) as CheckedLevel[], shortcuts.bail ?? null);
      return { levels: known, unchecked: files.slice(known.length), signal: checked.signal };
    };

  /** The files whose reports are new in this round: checked again, or with another report than in the round before. */
  newOf(levels: readonly CheckedLevel[]): ReadonlySet<string> {
    const now = new Map(levels.map((level) => [level.file, JSON.stringify({ ...level, ms: 0 })]));
    const fresh = [...now].filter(([file, text]) => this.checkedNow.has(file) || this.shownBefore.get(file) !== text);
    this.hasNews = fresh.length > 0 || now.size !== this.shownBefore.size;
    this.shownBefore = now;
    return new Set(fresh.map(([file]) => file));
  }

  /** Does a round. @returns its result; null if it has nothing new to show */
  async round<Result>(check: () => Promise<Result>): Promise<Result | null> {
    this.hasNews = true;
    try {
      const result = await check();
      return this.hasNews ? result : null;
    } catch (error) {
      // the next round is shown whatever it finds, as this one has shown an error
      this.shownBefore = new Map();
      throw error;
    }
  }
}

/** What changes whenever the content of a file does. */
function stampOf(file: string): string {
  try {
    const { ino, size, mtimeNs, ctimeNs } = statSync(file, { bigint: true });
    return `${ino} ${size} ${mtimeNs} ${ctimeNs}`;
  } catch (error) {
    return (error as NodeJS.ErrnoException).code ?? 'unreadable';
  }
}
