import { briefInSteps, type LevelVerdict, withinWork } from '../../../check/index.ts';
import { effectsToMeet } from '../../../check/pack/index.ts';
import { countMinerals } from '../../../check/words/index.ts';
import type { Terms } from '../../../engine/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { readLevel } from '../../../schema/index.ts';
import { job, type Work } from '../job.ts';

/** What a level has for players. */
export interface LevelFacts {
  /** The effects that players may meet here for the first time. */
  readonly effects: readonly string[];
  /** How long the run lasts that completes it, s; null if none does. */
  readonly seconds: number | null;
  /** Minerals that this run collects, or, if none completes it, the first run. */
  readonly minerals: number;
  readonly mineralCount: number;
}

/** A level file as a small picture shows it. */
export interface Thumbnail {
  readonly svg: string;
  readonly verdict: LevelVerdict | 'invalid';
  readonly minerals: number;
  /** What the level has for players; null if it is not valid. */
  readonly facts: LevelFacts | null;
}

/** A small picture of a level file, and its verdict. */
export const thumbnail = job<
  { readonly text: string; readonly terms: Terms; readonly width: number; readonly theme: 'dark' | 'light' },
  Thumbnail
>({ name: 'thumbnail', lane: 'long', most: 10_000 });

/** Draws a small picture of a level file, with a run that completes it if there is one, and gives the verdict of `gq check`. */
export const thumbnailWork: Work<typeof thumbnail> = {
  of: thumbnail,
  *steps({ text, terms, width, theme }) {
    const reading = readLevel(text, { rules: terms.rules });
    if (!reading.ok) return { svg: '', verdict: 'invalid', minerals: 0, facts: null };
    const { level, document } = reading;
    const isUndecided = (document.file.conflicts ?? []).length > 0;
    const { verdict, run, budget } = yield* briefInSteps(level, terms);
    const looks = { width, theme, words: false };
    // the path of a run that cost too much is not drawn
    const svg = run === null ? null : withinWork(budget, () => renderSvg(level, { run, ...looks }));
    const minerals = run === null ? 0 : countMinerals(run);
    const facts = {
      effects: effectsToMeet(level),
      seconds: run?.outcome === 'completed' ? run.time : null,
      minerals,
      mineralCount: level.minerals.length,
    };
    // a merge has left two candidates for something: neither is judged
    return { svg: svg ?? renderSvg(level, looks), verdict: isUndecided ? 'invalid' : verdict, minerals, facts };
  },
};
