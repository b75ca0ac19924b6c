import { plural } from '../../../check/words/index.ts';
import type { GenerateReport } from '../../../schema/index.ts';
import type { Rejection } from '../../../solver/index.ts';
import { alignColumns, percent } from '../../report-parts/index.ts';
import { type Colors, visibleLine } from '../../terminal/index.ts';

/** The results of `generate` as JSON. */
export const generateJson = (report: GenerateReport): string => `${JSON.stringify(report)}\n`;

/** The results of `generate` for people. */
export function generatePretty({ levels, rejected, reasons, variety, pack }: GenerateReport, colors: Colors): string {
  const isThemed = levels.some(({ theme }) => theme !== null);
  const rows = levels.map(
    ({ file, seed, status, grade, p40, certifiedTicks, length, presses, attempts, theme, symmetry, aside }) => [
      status,
      file === null ? `seed ${seed}` : visibleLine(file),
      grade === null ? '' : `${grade.word} ${grade.value.toFixed(1)}`,
      p40 === null ? '' : `${percent(p40)} success at 40 ms`,
      certifiedTicks === null ? '' : `certified ${plural(certifiedTicks, 'tick')}`,
      length === null || presses === null ? '' : `${length.toFixed(2)} s, ${plural(presses, 'press', 'presses')}`,
      ...(isThemed ? [themeWords(theme, symmetry), aside === null ? '' : `${plural(aside, 'mineral')} off the solution`] : []),
      `${plural(attempts, 'layout')} tried`,
    ],
  );
  const paint = (status: GenerateReport['levels'][number]['status']) =>
    status === 'written' || status === 'unchanged' ? colors.green : colors.yellow;
  const lines = alignColumns(rows).map((line, i) => {
    const { status } = levels[i];
    return `${paint(status)(status)}${line.slice(status.length)}\n`;
  });
  const written = levels.filter(({ status }) => status === 'written').length;
  const parts = Object.entries(WORDS).flatMap(([reason, words]) =>
    (reasons[reason] ?? 0) > 0 ? [`${reasons[reason]} ${words}`] : [],
  );
  const thrown = parts.length === 0 ? '' : `; ${plural(rejected, 'layout')} rejected: ${parts.join(', ')}`;
  const differ =
    variety === null
      ? ''
      : `variety ${variety.mean.toFixed(2)} (0 alike, 1 nothing in common); the most similar are seeds ${variety.closest.seeds.join(' and ')}, ${variety.closest.distance.toFixed(2)} apart\n`;
  if (pack !== undefined) lines.push(`${paint(pack.status)(pack.status)} ${visibleLine(pack.file)}\n`);
  return `${lines.join('')}${plural(written, 'level')} written${thrown}\n${differ}`;
}

/** How much a level is of its theme, and how symmetric. */
function themeWords(
  theme: GenerateReport['levels'][number]['theme'],
  symmetry: GenerateReport['levels'][number]['symmetry'],
): string {
  if (theme === null) return '';
  const novae = symmetry === null ? '' : `, ${percent(symmetry.share)} of the novae have a counterpart`;
  return `${theme.name}: ${theme.value.toFixed(2)} ${theme.measured}${novae}`;
}

/** Why layouts are rejected, in words. */
const WORDS: Readonly<Record<Rejection | 'alike', string>> = {
  noRoom: 'without room for the asteroids',
  noRun: 'without a run to build around',
  noDetour: 'whose minerals lead nowhere else',
  offTheme: 'with too little of the theme',
  asymmetric: 'not symmetric enough',
  tooEasy: 'too easy',
  tooHard: 'too hard',
  unforgiving: 'not robust',
  outOfTerms: 'not within the terms',
  noMinerals: 'whose minerals no run collects',
  warnings: 'with warnings',
  alike: 'too close to an earlier level of the pack',
};
