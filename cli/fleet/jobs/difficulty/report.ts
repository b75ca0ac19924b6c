import { plural } from '../../../../check/words/index.ts';
import { GRADE_WORDS, type GradeWord } from '../../../../solver/index.ts';
import type { CommandResult } from '../../../command.ts';
import { difficultyPretty, type MeasuredLevel, measuredJson } from '../../../difficulty/index.ts';
import { jsonWithLevels } from '../../../report-parts/index.ts';
import type { Destination } from '../../../reporters/index.ts';
import type { ShardRecord } from '../../job.ts';
import { expectVerdict, Listed, plainReport, type ReportOptions, unlistedInWords } from '../kind.ts';
import { levelOf } from './work.ts';

/** The reports of `gq difficulty` on a set: the easiest first, or of a large one, how many levels have which grade. */
export function reportMeasured(
  records: () => Iterable<ShardRecord>,
  destinations: readonly Destination[],
  { quiet = false }: ReportOptions,
): CommandResult {
  const grades = new Map<GradeWord, number>(GRADE_WORDS.map(([, word]) => [word, 0]));
  const listed = new Listed<MeasuredLevel>();
  let total = 0;
  let measured = 0;
  let code: MeasuredLevel['code'] = 0;
  for (const { file, result } of records()) {
    const level = levelOf(file, result);
    const { difficulty } = level;
    expectVerdict(level.code, difficulty === null ? [1, 2] : [0]);
    total++;
    code = Math.max(code, level.code) as typeof code;
    if (difficulty !== null) {
      measured++;
      const { word } = difficulty.grade;
      grades.set(word, grades.get(word)! + 1);
    }
    if (!quiet || difficulty === null) listed.add(level, difficulty !== null);
  }
  const counts = [...grades].map(([word, count]) => `${count} ${word}`).join(', ');
  const summary = `${unlistedInWords(listed.unlisted)}${plural(total, 'level')}: ${measured} measured: ${counts}\n`;
  const reports = plainReport(destinations, {
    json: () => jsonWithLevels(records(), ({ file, result }) => measuredJson(levelOf(file, result)), {}),
    pretty: (colors, width) => `${difficultyPretty(listed.items, null, colors, width, 'table')}${summary}`,
  });
  return { ...reports, exitCode: code };
}
