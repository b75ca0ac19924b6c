import { packedLevel } from '../../check/pack/index.ts';
import type { Terms } from '../../engine/index.ts';
import type { LevelEntry, LevelFile, RefusedLevel } from '../../schema/index.ts';
import { askOnce, type Desk } from '../ask/index.ts';
import { errorInWords, type LevelStorage, readText } from '../files/index.ts';
import { pictureQuestion } from '../pictures/index.ts';

/** Levels for a page, and those that are not known to be completable. */
export interface CollectedLevels {
  readonly levels: readonly { readonly id: string; readonly level: unknown }[];
  readonly refused: readonly RefusedLevel[];
}

interface Collecting {
  readonly storage: LevelStorage;
  readonly desk: Desk;
  /** Those of the folder. */
  readonly terms: Terms;
  readonly withRuns: boolean;
  /** Called with the number of levels that are done. */
  readonly onProgress: (done: number) => void;
}

const WORDS: Readonly<Record<RefusedLevel['verdict'], string>> = {
  completable: '',
  broken: 'none of its runs completes it',
  unproven: 'no run shows that it can be completed',
  impossible: 'it is proved that nobody can complete it',
  invalid: 'the file is not a valid level',
  crashed: 'its check failed',
};

/**
 * Reads levels and gives each the verdict of `gq check`.
 * @throws (rejects) in words if one can't be read
 */
export async function collectLevels(entries: readonly LevelEntry[], options: Collecting): Promise<CollectedLevels> {
  const { storage, desk, terms, withRuns, onProgress } = options;
  const levels: { id: string; level: unknown }[] = [];
  const refused: RefusedLevel[] = [];
  for (const [i, { id, name }] of entries.entries()) {
    onProgress(i);
    const answer = await storage.read(id);
    if (!answer.ok) throw new Error(errorInWords(answer.error));
    const reading = answer.value.text === null ? null : readText(answer.value.text);
    const file: LevelFile | null = reading?.ok ? reading.file : null;
    const refuse = (verdict: RefusedLevel['verdict'], message = WORDS[verdict]) =>
      refused.push({ id, name: name ?? id, verdict, message });
    if (file === null || answer.value.text === null) {
      refuse('invalid', answer.value.problems[0]?.message);
      continue;
    }
    const looks = { width: 16, theme: 'dark' } as const;
    const drawn = await askOnce(pictureQuestion, desk, { text: answer.value.text, terms, ...looks }).end;
    const verdict = drawn.answer?.verdict ?? 'unproven';
    if (verdict !== 'completable') refuse(verdict);
    levels.push({ id, level: packedLevel(file, { rules: terms.rules, withRuns, found: null }) });
  }
  onProgress(entries.length);
  return { levels, refused };
}
