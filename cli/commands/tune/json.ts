import type { TuneReport } from '../../../schema/index.ts';
import { amountsOf, type TunedLevel, type TuneSettings } from '../../tune/index.ts';
import { independentRules } from './independent-rules.ts';

/** The results of `tune` as JSON. */
export function tuneJson(levels: readonly TunedLevel[], { terms, changes, sweep }: TuneSettings): string {
  const report: TuneReport = {
    version: 1,
    accuracy: terms.accuracy.name,
    changes: changes.map((change) => ({ ...change })),
    sweep: sweep === null ? null : { rule: sweep.rule, isRelative: sweep.isRelative, amounts: amountsOf(sweep) },
    levels: levels.map(({ file, name, terms: own, run, room, values, intervals, why }) => ({
      file,
      name,
      terms: own,
      run,
      room,
      values: values.map(({ value, state, holds }) => ({
        value,
        state,
        holds: holds?.map(([press, release]) => [press, release] as [number, number]) ?? null,
      })),
      intervals: intervals.map((interval) => ({ ...interval })),
      why: why === '' ? null : why,
    })),
    independent: independentRules(levels),
  };
  return `${JSON.stringify(report)}\n`;
}
