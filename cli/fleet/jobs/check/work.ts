import { type CheckedLevel, type CheckSettings, levelChecker, unreadableLevel } from '../../../check/index.ts';
import type { Entry } from '../../../io/index.ts';
import type { Json, Work } from '../../job.ts';

/** Checks levels. */
export async function openCheck(settings: CheckSettings): Promise<Work> {
  const checkTogether = await levelChecker();
  function checkAll(entries: readonly Entry[], asked: CheckSettings): CheckedLevel[] {
    const read = entries.flatMap(({ name, content }) => (content instanceof Uint8Array ? [{ file: name, content }] : []));
    const checked = checkTogether(read, asked, null).values();
    return entries.map(({ name, content }) =>
      content instanceof Uint8Array ? checked.next().value!.level : unreadableLevel(name, content.message, asked.terms),
    );
  }
  return {
    work: (entries) => checkAll(entries, settings).map((level) => ({ ms: level.ms, result: recordOf(level) })),
    replay(entry, result) {
      const { found } = result as unknown as CheckedLevel;
      // a search is not repeated: the run that it has found speaks for itself, and all else follows from it
      const { search } = settings;
      const isSearch = search !== null && found !== null;
      const [again] = checkAll([entry], isSearch ? { ...settings, search: { ...search, claimed: found } } : settings).map(
        recordOf,
      );
      if (JSON.stringify(again) === JSON.stringify(result)) return null;
      return again.verdict === result.verdict ? 'completable, but not as recorded' : String(again.verdict);
    },
  };
}

/** What is recorded of a checked level: all but its file and the time that it took, which a record has beside it. */
export const recordOf = ({ file: _, ms: __, ...rest }: CheckedLevel): Json => rest as unknown as Json;

export const levelOf = (file: string, ms: number, result: Json): CheckedLevel =>
  ({ file, ...result, ms }) as unknown as CheckedLevel;
