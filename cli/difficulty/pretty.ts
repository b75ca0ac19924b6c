import { holdsInWords, plural } from '../../check/words/index.ts';
import { TICK } from '../../engine/index.ts';
import { objectName } from '../../schema/index.ts';
import type { Difficulty, GradeWord } from '../../solver/index.ts';
import { alignColumns, percent, robustnessLines, showFileProblems } from '../report-parts/index.ts';
import { type Colors, visible, visibleLine } from '../terminal/index.ts';
import type { MeasuredLevel } from './measured-level.ts';
import { forecastLines, playersDetail, playersTable, playsInWords } from './players-pretty.ts';
import type { CollectedPlays } from './plays/index.ts';

/**
 * The difficulty of levels for people: one level in detail, several as a table with the easiest first.
 * @param form a level that was measured as one of many lacks details, so a single one makes a table, too
 */
export function difficultyPretty(
  levels: readonly MeasuredLevel[],
  plays: CollectedPlays | null,
  colors: Colors,
  width: number | null = null,
  form: 'detail' | 'table' = levels.length === 1 ? 'detail' : 'table',
): string {
  const measured = levels.filter(hasDifficulty);
  const text = form === 'detail' && measured.length === 1 ? detail(measured[0], colors) : table(measured, colors, width);
  const failures = levels.filter(({ difficulty }) => difficulty === null);
  const reported = failures.map(({ file, why, problems }) =>
    problems.length > 0
      ? showFileProblems(file, problems, colors)
      : `${visibleLine(file)}: ${colors.yellow('not measured')}: ${visibleLine(why)}\n`,
  );
  const [only] = levels;
  const taught =
    form === 'detail' && only.players !== null ? playersDetail(only.players, colors, width) : playersTable(levels, colors, width);
  const read = plays === null ? '' : playsInWords(plays);
  const grade = measured.length === 0 ? '' : GRADE_IN_WORDS;
  return `${text}${taught}${reported.join('')}${read}${grade}`;
}

const GRADE_IN_WORDS =
  'the grade (1 to 10) is an estimate from the other numbers and the lowest of any run; it was not fitted to players\n';

const UNCALIBRATED_IN_WORDS = 'not calibrated: its numbers are from the literature on timing, not from players of this game';

type Hard = MeasuredLevel & { readonly difficulty: Difficulty };

const hasDifficulty = (level: MeasuredLevel): level is Hard => level.difficulty !== null;

function table(levels: readonly Hard[], colors: Colors, width: number | null): string {
  if (levels.length === 0) return '';
  const sorted = [...levels].sort((a, b) => a.difficulty.grade.value - b.difficulty.grade.value);
  const head = ['grade', '', 'success at 40 ms', 'half at', 'first try', 'window', 'presses', 'length', 'random', 'level'];
  const rows = sorted.map(({ file, difficulty }) => {
    const { grade, robustness, sigmaAtHalf, smallestWindow, presses, length, randomPlay, forecast } = difficulty;
    return [
      grade.value.toFixed(1),
      grade.word,
      percent(robustness.p40.p),
      sigmaInWords(sigmaAtHalf),
      forecast === null ? '' : percent(forecast.attempts[0].pass.p),
      smallestWindow === null ? '' : windowInWords(smallestWindow),
      String(presses),
      `${length.toFixed(2)} s`,
      percent(randomPlay.share),
      visibleLine(file),
    ];
  });
  const [first, ...lines] = alignColumns(rows, { right: [0, 2, 3, 4, 5, 6, 7, 8], head, lead: 9, width });
  const painted = lines.map((line, i) => paint(sorted[i].difficulty.grade.word, colors)(line));
  return `${first === '' ? '' : `${colors.bold(first)}\n`}${painted.join('\n')}\n\n`;
}

const sigmaInWords = ({ ms, capped }: Difficulty['sigmaAtHalf']): string => `${capped ? '> ' : ''}${ms.toFixed(0)} ms`;

const windowInWords = (ticks: number): string => `${(1000 * ticks * TICK).toFixed(0)} ms`;

const paint = (word: GradeWord, colors: Colors) =>
  word === 'hard' || word === 'brutal' ? colors.red : word === 'medium' ? colors.yellow : colors.green;

const USES = {
  avoidable: 'is not needed: a run completes the level without using it',
  replaceable: 'could be deleted: a run completes the level without it',
  needed: 'is needed: without it the level is proved impossible',
  unknown: 'is most likely needed: no run without it was found',
} as const;

function detail({ name, runName, difficulty }: Hard, colors: Colors): string {
  const { run, comparison, grade, robustness, sigmaAtHalf, smallestWindow, presses, length, randomPlay } = difficulty;
  const { mineralsExtra, shortcuts, forecast } = difficulty;
  const { low, high, capped } = sigmaAtHalf;
  const { withoutPressing, onePress, withoutAsteroid } = shortcuts;
  const lines: [string, string][] = [
    ['run', `${runName === null ? 'found by a search' : JSON.stringify(runName)}: ${holdsInWords(run.holds)}`],
    ...comparisonLines(comparison),
    ['length', `${length.toFixed(2)} s, ${plural(presses, 'press', 'presses')}`],
    ...robustnessLines(robustness),
    [
      'half at',
      `${sigmaInWords(sigmaAtHalf)} of timing noise: every second attempt succeeds${capped ? '' : ` (${low.toFixed(0)} to ${high.toFixed(0)} ms)`}`,
    ],
  ];
  if (smallestWindow !== null) lines.push(['window', `${windowInWords(smallestWindow)} for the tightest press or release`]);
  lines.push(['random', `${percent(randomPlay.share)} of ${randomPlay.samples} random runs complete it`]);
  if (forecast !== null) lines.push(...forecastLines(forecast), ['', UNCALIBRATED_IN_WORDS]);
  if (mineralsExtra !== null) lines.push(['minerals', mineralsInWords(mineralsExtra)]);
  lines.push([
    'no press',
    withoutPressing === null ? 'does not complete it' : `completes it in ${withoutPressing.time.toFixed(2)} s`,
  ]);
  lines.push(['one press', onePressInWords(onePress)]);
  for (const { asteroid, use, run: way } of withoutAsteroid) {
    lines.push([objectName('asteroid', asteroid), `${USES[use]}${way === null ? '' : `: ${holdsInWords(way.holds)}`}`]);
  }
  const title = `${colors.bold(visibleLine(name))}: ${paint(grade.word, colors)(`${grade.word}, ${grade.value.toFixed(1)} of 10`)}`;
  return `${title}\n${lines.map(([label, text]) => `${label.padEnd(12)}${visible(text)}\n`).join('')}\n`;
}

function comparisonLines({ runs, meanP40, meanGrade }: Difficulty['comparison']): [string, string][] {
  if (runs.length === 1) return [];
  const mean = `the mean of all: grade ${meanGrade.toFixed(1)}, ${percent(meanP40)} succeed at 40 ms of timing noise`;
  return [['compared', `${runs.length} runs, of which this one forgives most; ${mean}`]];
}

function mineralsInWords({ time, presses, p40 }: NonNullable<Difficulty['mineralsExtra']>): string {
  const than = (value: number, size: string, less: string, more: string): string => `${size} ${value < 0 ? less : more}`;
  const quick = than(time, `${Math.abs(time).toFixed(2)} s`, 'quicker', 'slower');
  const many = than(presses, plural(Math.abs(presses), 'press', 'presses'), 'fewer', 'more');
  const sure = than(p40, `${Math.abs(100 * p40).toFixed(1)} points`, 'less', 'more');
  return `collecting all of them is ${quick}, with ${many} and ${sure} of success at 40 ms`;
}

function onePressInWords({ count, tried, example }: Difficulty['shortcuts']['onePress']): string {
  if (count === 0) return `never completes it (${tried} pairs of press and release tried)`;
  const way = example === null ? '' : `, for example ${holdsInWords(example.holds)}`;
  return `completes it with ${count} of ${tried} pairs of press and release (${percent(count / tried)})${way}`;
}
