import { type VerifyReport, verifyReportSchema } from '../../../../schema/index.ts';
import type { CommandResult } from '../../../command.ts';
import type { Destination } from '../../../reporters/index.ts';
import { visibleLine } from '../../../terminal/index.ts';
import { countsPretty, playPretty } from '../../../verify/index.ts';
import type { ShardRecord } from '../../job.ts';
import { expectVerdict, Listed, plainReport, type ReportOptions, unlistedInWords } from '../kind.ts';
import type { VerifyRecord } from './work.ts';

/** Plays without a verdict that are named. */
const MOST_NAMED = 20;

/** The reports of `gq verify` on a set. */
export function reportVerified(
  records: () => Iterable<ShardRecord>,
  destinations: readonly Destination[],
  { quiet = false }: ReportOptions,
): CommandResult {
  const counts = new Map<string, number>();
  const listed = new Listed<VerifyReport>();
  const without: string[] = [];
  let failed = 0;
  for (const { result } of records()) {
    const { report, why } = result as unknown as VerifyRecord;
    if (report === null) {
      failed++;
      if (without.length < MOST_NAMED) without.push(`error: ${visibleLine(why!)}\n`);
      continue;
    }
    const { verdict } = report;
    expectVerdict(verdict, verifyReportSchema.shape.verdict.options);
    counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
    if (!quiet || verdict !== 'ok') listed.add(report, verdict === 'ok');
  }
  function* json(): Generator<string> {
    for (const { result } of records()) {
      const { report } = result as unknown as VerifyRecord;
      if (report !== null) yield `${JSON.stringify(report)}\n`;
    }
  }
  const reports = plainReport(destinations, {
    json,
    pretty: (colors) =>
      `${listed.items.map((report) => playPretty(report, colors)).join('')}${unlistedInWords(listed.unlisted)}${countsPretty(counts)}`,
  });
  const more = failed > without.length ? `and ${failed - without.length} more without a verdict\n` : '';
  const isClean = [...counts.keys()].every((verdict) => verdict === 'ok');
  return { ...reports, messages: without.join('') + more, exitCode: failed > 0 ? 2 : isClean ? 0 : 1 };
}
