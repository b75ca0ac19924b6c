import type { Terms } from '../../../../engine/basics/index.ts';
import { type SeverityMap, VERDICTS } from '../../../../schema/index.ts';
import { type CheckedLevel, exitCodeFor, isGood, judgeOf, tooManyWarnings, totalsOf } from '../../../check/index.ts';
import type { CommandResult } from '../../../command.ts';
import { type Destination, reportCheck } from '../../../reporters/index.ts';
import type { Records, ShardRecord } from '../../job.ts';
import { expectVerdict, Listed, type ReportOptions } from '../kind.ts';
import { levelOf } from './work.ts';

/** What the report of a check depends on besides the results. */
export interface CheckReporting {
  readonly terms: Terms;
  readonly severity: SeverityMap;
  readonly maxWarnings: number | null;
}

/** Stands for every level that is completable without a problem: of a large set, such levels are only counted. */
const result = { verdict: 'completable', problems: [], unreadable: false };
const PLAIN: ShardRecord = { n: 0, file: '', sha256: '', ms: 0, result };

/** Whether a line has such a level. Nearly all do, and to read one takes far longer. No text in it has quotes like a key's. */
const IS_PLAIN = /^(?!.*,"allow":).*,"verdict":"completable",.*,"problems":\[\],"unreadable":false\}\}$/s;

/**
 * The reports of a large set. JSON is made in pieces and lists all levels; the others list all levels of a small set, and those
 * that fail of a large one.
 */
export async function reportCheckOf(
  records: Records,
  { terms, severity, maxWarnings }: CheckReporting,
  destinations: readonly Destination[],
  { withTimes, quiet, linkTo = null }: ReportOptions,
): Promise<CommandResult> {
  const judge = await judgeOf({ severity });
  function* levels(known?: Parameters<Records>[0]): Generator<CheckedLevel> {
    for (const { file, ms, result } of records(known)) {
      expectVerdict(result.verdict, VERDICTS);
      yield judge(levelOf(file, withTimes ? ms : 0, result));
    }
  }
  const listed = new Listed<CheckedLevel>();
  function* collected(): Generator<CheckedLevel> {
    for (const level of levels((line) => (!listed.isSmall && IS_PLAIN.test(line) ? PLAIN : null))) {
      listed.add(level, isGood(level));
      yield level;
    }
  }
  const totals = totalsOf(collected());
  const results = {
    levels: listed.items,
    totals,
    unlisted: listed.unlisted,
    unchecked: [],
    interrupted: false,
    excess: tooManyWarnings(totals, maxWarnings),
  };
  return reportCheck(results, destinations, { exitCode: exitCodeFor(totals, maxWarnings), terms, quiet, linkTo }, levels);
}
