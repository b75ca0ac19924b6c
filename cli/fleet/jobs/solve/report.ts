import { holdsInWords, plural } from '../../../../check/words/index.ts';
import type { SolveReport, SolveSetReport } from '../../../../schema/index.ts';
import type { CommandResult } from '../../../command.ts';
import { alignColumns, jsonWithLevels, percent, problemJson, showFileProblems } from '../../../report-parts/index.ts';
import type { Destination } from '../../../reporters/index.ts';
import { type Colors, visibleLine } from '../../../terminal/index.ts';
import type { ShardRecord } from '../../job.ts';
import { expectVerdict, Listed, plainReport, type ReportOptions, unlistedInWords } from '../kind.ts';
import type { SolveRecord, SolveVerdict } from './record.ts';

interface SolvedLevel extends SolveRecord {
  readonly file: string;
  /** ms of wall time; 0 if reports have no times. */
  readonly ms: number;
}

type Summary = Record<SolveVerdict, number>;

/** The reports of `gq solve` on a set. */
export function reportSolved(
  records: () => Iterable<ShardRecord>,
  destinations: readonly Destination[],
  { quiet = false, withTimes }: ReportOptions,
): CommandResult {
  function* levels(): Generator<SolvedLevel> {
    for (const { file, ms, result } of records()) yield { ...(result as unknown as SolveRecord), file, ms: withTimes ? ms : 0 };
  }
  const summary: Summary = { found: 0, impossible: 0, 'not-found': 0, invalid: 0, crashed: 0 };
  const listed = new Listed<SolvedLevel>();
  let failed = 0;
  for (const level of levels()) {
    const { verdict, unreadable } = level;
    expectVerdict(verdict, Object.keys(summary));
    summary[verdict]++;
    if (verdict === 'crashed' || unreadable) failed++;
    if (!quiet || verdict !== 'found') listed.add(level, verdict === 'found');
  }
  const total = Object.values(summary).reduce((sum, count) => sum + count, 0);
  const reports = plainReport(destinations, {
    json: () => jsonWithLevels(levels(), levelJson, { summary }),
    pretty: (colors, width) => solvedPretty(listed, summary, total, colors, width),
  });
  return { ...reports, exitCode: failed > 0 ? 2 : summary.found === total ? 0 : 1 };
}

function levelJson({ file, name, verdict, solved, why, problems, ms }: SolvedLevel): SolveSetReport['levels'][number] {
  const timed = (report: SolveReport): SolveReport => ({
    ...report,
    effort: { ...report.effort, seconds: ms / 1000 },
    ...(report.solutions && {
      solutions: report.solutions.map((one) => ({ ...one, effort: { ...one.effort, seconds: ms / 1000 } })),
    }),
  });
  return { file, name, verdict, solved: solved && timed(solved), why, problems: problems.map(problemJson), ms };
}

const IN_WORDS: Readonly<Record<SolveVerdict, string>> = {
  found: 'a run was found',
  impossible: 'proved impossible',
  'not-found': 'no run was found, which does not prove that there is none',
  invalid: 'not a valid level',
  crashed: 'gq failed: please report it, with the level',
};

function solvedPretty(
  listed: Listed<SolvedLevel>,
  summary: Summary,
  total: number,
  colors: Colors,
  width: number | null,
): string {
  const paint = (verdict: SolveVerdict): ((text: string) => string) =>
    verdict === 'found' ? colors.green : verdict === 'not-found' ? colors.yellow : colors.red;
  const lines = alignColumns(listed.items.map(row), { right: [2, 3], width });
  let text = '';
  for (const [i, { file, verdict, problems }] of listed.items.entries())
    text += `${paint(verdict)(verdict)}${lines[i].slice(verdict.length)}\n${showFileProblems(file, problems, colors)}`;
  const counts = (Object.entries(summary) as [SolveVerdict, number][]).filter(([, count]) => count > 0);
  const words = counts.map(([verdict, count]) => paint(verdict)(`${count} ${verdict}`)).join(', ');
  text += `${text === '' ? '' : '\n'}${unlistedInWords(listed.unlisted)}${colors.bold(plural(total, 'level'))}: ${words}\n`;
  for (const [verdict] of counts) if (verdict !== 'found') text += `${verdict}: ${IN_WORDS[verdict]}\n`;
  return text;
}

/** The cells of a line: verdict, file, time, success, and holds or why there are none. */
function row({ verdict, file, solved, why }: SolvedLevel): string[] {
  const { time, robustness, holds, impossible, closest } = solved ?? {};
  const near = closest == null ? '' : `closest ${closest.distance.toFixed(1)} px`;
  const what = holds != null ? holdsInWords(holds) : (impossible?.reason ?? why ?? near);
  return [
    verdict,
    visibleLine(file),
    time == null ? '' : `${time.toFixed(2)} s`,
    robustness == null ? '' : `${percent(robustness.p40)} at 40 ms`,
    visibleLine(what),
  ];
}
