import { plural } from '../../../check/words/index.ts';
import type { GenerateReport } from '../../../schema/index.ts';
import type { Colors } from '../../colors.ts';
import { alignColumns, percent } from '../../report-parts/index.ts';
import { visibleLine } from '../../visible.ts';

/** The results of `generate` as JSON. */
export const generateJson = (report: GenerateReport): string => `${JSON.stringify(report)}\n`;

/** The results of `generate` for people. */
export function generatePretty({ levels, rejected }: GenerateReport, colors: Colors): string {
  const rows = levels.map(({ file, seed, status, grade, p40, certifiedTicks, length, presses, attempts }) => [
    status,
    file === null ? `seed ${seed}` : visibleLine(file),
    grade === null ? '' : `${grade.word} ${grade.value.toFixed(1)}`,
    p40 === null ? '' : `${percent(p40)} success at 40 ms`,
    certifiedTicks === null ? '' : `certified ${plural(certifiedTicks, 'tick')}`,
    length === null || presses === null ? '' : `${length.toFixed(2)} s, ${plural(presses, 'press', 'presses')}`,
    `${plural(attempts, 'layout')} tried`,
  ]);
  const paint = (status: GenerateReport['levels'][number]['status']) =>
    status === 'written' || status === 'unchanged' ? colors.green : colors.yellow;
  const lines = alignColumns(rows).map((line, i) => {
    const { status } = levels[i];
    return `${paint(status)(status)}${line.slice(status.length)}\n`;
  });
  const written = levels.filter(({ status }) => status === 'written').length;
  const thrown =
    rejected === 0 ? '' : `; ${plural(rejected, 'layout')} rejected: not completable, not robust, too easy or too hard`;
  return `${lines.join('')}${plural(written, 'level')} written${thrown}\n`;
}
