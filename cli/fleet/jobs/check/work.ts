import { compile, simulate } from '../../../../engine/index.ts';
import { readLevel } from '../../../../schema/index.ts';
import { type CheckedLevel, type CheckSettings, levelChecker, unreadableLevel } from '../../../check/index.ts';
import type { Entry } from '../../../packs/index.ts';
import type { Work } from '../../job.ts';
import { recordOf } from './record.ts';

/** Checks levels. */
export async function openCheck(settings: CheckSettings): Promise<Work> {
  const checkLevel = await levelChecker();
  const check = ({ name, content }: Entry): CheckedLevel =>
    content instanceof Uint8Array ? checkLevel(name, settings, content) : unreadableLevel(name, content.message);
  return {
    work: (entry) => recordOf(check(entry)),
    replay(entry, result) {
      const { found } = result as unknown as CheckedLevel;
      // a search is not repeated: the run that it has found speaks for itself
      if (found !== null) return replayFound(entry, settings, result as unknown as CheckedLevel);
      const again = recordOf(check(entry));
      if (JSON.stringify(again) === JSON.stringify(result)) return null;
      return again.verdict === result.verdict ? 'completable, but not as recorded' : String(again.verdict);
    },
  };
}

function replayFound(
  { content }: Entry,
  { accuracy, maxTime, rules }: CheckSettings,
  { found, run }: CheckedLevel,
): string | null {
  const read = content instanceof Uint8Array ? readLevel(content, { rules }) : null;
  if (!read?.ok) return 'invalid';
  const { outcome, tick, time } = simulate(compile(read.level, accuracy), found!, { maxTime });
  if (outcome !== 'completed') return `a run that is ${outcome}`;
  return tick === run?.tick && time === run.time ? null : `a run that ends in tick ${tick}`;
}
