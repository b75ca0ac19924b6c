import process from 'node:process';
import { closestInWords, holdsInWords, plural } from '../../check/words/index.ts';
import { MORE_WARNINGS, TICK } from '../../engine/basics/index.ts';
import type { CheckReport, Problem, RobustnessReport } from '../../schema/index.ts';
import { codeFrame } from '../../schema/json/index.ts';
import type { Closest, Robustness } from '../../solver/index.ts';
import { type Colors, colorsFor, Failure, visible, visibleLine } from '../terminal/index.ts';

/** A run as an option, for the end of a sentence. */
export const byHolds = (holds: string): string => `, with --holds ${holds}`;

/** Says how close the closest run came, and which run that is. */
export const closestRunInWords = (closest: Closest): string => closestInWords(closest) + byHolds(holdsInWords(closest.holds));

/** Text in pieces that can be read as often as is wanted. */
export const inPieces = (make: () => Iterable<string>): Iterable<string> => ({
  [Symbol.iterator]: () => make()[Symbol.iterator](),
});

/**
 * A report as JSON in pieces, for any number of levels.
 * @param rest all keys but `version` and `levels`
 */
export function* jsonWithLevels<T>(levels: Iterable<T>, toJson: (level: T) => object, rest: object): Generator<string> {
  yield `{"version":1,"levels":[`;
  let comma = '';
  for (const level of levels) {
    yield comma + JSON.stringify(toJson(level));
    comma = ',';
  }
  const tail = JSON.stringify(rest).slice(1);
  yield tail === '}' ? ']}\n' : `],${tail}\n`;
}

/** `file:line:col`, or only the file if a problem concerns all of it. */
function place(file: string, { line, column }: ShownProblem): string {
  return visibleLine(line === null ? file : `${file}:${line}:${column ?? 1}`);
}

/** One problem for people: its place first, then the message, the lines around it, and the hint. */
function showProblem(file: string, problem: ShownProblem, colors: Colors): string {
  const paint = problem.severity === 'error' ? colors.red : colors.yellow;
  const head = `${place(file, problem)}: ${paint(problem.severity)} ${colors.dim(problem.code)}: ${visibleLine(problem.message)}`;
  const frame = problem.frame === null ? '' : `${indent(visible(problem.frame.trimEnd()))}\n`;
  const hint = problem.hint === '' ? '' : `${indent(visible(problem.hint))}\n`;
  return `${head}\n${frame}${hint}`;
}

const isCount = ({ code, message }: ShownProblem): boolean => code === 'more-problems' || message === MORE_WARNINGS;

/** The problems of one file; if there are very many, only the first. */
export function showFileProblems(file: string, problems: readonly ShownProblem[], colors: Colors): string {
  // an entry that only says how many problems were left out earlier is not counted as a problem
  const counts = problems.filter(isCount);
  const all = counts.length === 0 ? problems : problems.filter((problem) => !isCount(problem));
  const shown = all.slice(0, MAX_SHOWN).map((problem) => showProblem(file, problem, colors));
  const more = all.length - shown.length;
  if (more > 0) {
    const least = counts.length > 0 ? 'at least ' : '';
    shown.push(`${visibleLine(file)}: ${least}${plural(more, 'more problem', 'more problems')} like these\n`);
  }
  return [...shown, ...counts.map((count) => showProblem(file, count, colors))].join('');
}

const indent = (text: string): string => text.replace(/^(?=.)/gm, '    ');

/** A problem with the surrounding lines of the file. */
export interface ShownProblem extends Problem {
  readonly frame: string | null;
  /** Where it is, by ids and names instead of indices; left out where a problem has no pointer into a file. */
  readonly key?: string;
}

/** The largest number of problems that are shown for one file. */
export const MAX_SHOWN = 20;

/** A problem as in every JSON report. */
export function problemJson({
  code,
  severity,
  message,
  line,
  column,
  pointer,
}: Problem): CheckReport['levels'][number]['problems'][number] {
  return { code, severity, message, line, column, pointer };
}

/** How a table is laid out. */
interface TableLayout {
  /** The columns, from 0, that are aligned to the right. */
  readonly right?: readonly number[];
  /** The titles of the columns; a line of their own where the table fits. */
  readonly head?: readonly string[];
  /** The column that begins a row where the table does not fit; by default the first. */
  readonly lead?: number;
  /** The characters of a line of the terminal; null, or nothing: a line can be as long as it likes. */
  readonly width?: number | null;
}

/** what the further lines of a row begin with */
const INDENT = '    ';

/**
 * Formats rows of cells as lines. Every column is as wide as its widest cell; lines have no trailing spaces. Where that does not
 * fit into the width, every row is a text of several lines instead, in which each cell has the title of its column.
 * @returns a text for each row, after one for the titles if there are any (empty where they stand in the rows)
 */
export function alignColumns(rows: readonly (readonly string[])[], layout: TableLayout = {}): string[] {
  const { right = [], head, width = null } = layout;
  const all = head === undefined ? rows : [head, ...rows];
  const widths: number[] = [];
  for (const row of all) for (const [i, cell] of row.entries()) widths[i] = Math.max(widths[i] ?? 0, length(cell));
  const pad = (cell: string, i: number): string => {
    const space = ' '.repeat(widths[i] - length(cell));
    return right.includes(i) ? space + cell : cell + space;
  };
  const lines = all.map((row) => row.map(pad).join('  ').trimEnd());
  if (width === null || lines.every((line) => length(line) <= width)) return lines;
  const narrow = rows.map((row) => stacked(row, layout, width));
  return head === undefined ? narrow : ['', ...narrow];
}

/** A row as lines of at most `width` characters, if no word is longer. */
function stacked(row: readonly string[], { head = [], lead = 0 }: TableLayout, width: number): string {
  const titled = row.map((cell, i) => (cell === '' || i === lead || !head[i] ? cell : `${head[i]} ${cell}`));
  const cells = [titled[lead] ?? '', ...titled.filter((_, i) => i !== lead)].filter((cell) => cell !== '');
  const lines: string[] = [];
  let line = '';
  const put = (text: string, gap: string): void => {
    if (line === '' || length(line + gap + text) <= width) line += (line === '' ? '' : gap) + text;
    else {
      lines.push(line);
      line = INDENT + text;
    }
  };
  for (const cell of cells) {
    // a cell stays whole if it fits into a line
    if (length(INDENT + cell) <= width) put(cell, '  ');
    else for (const [i, word] of cell.split(' ').entries()) put(word, i === 0 ? '  ' : ' ');
  }
  return [...lines, line].join('\n');
}

/** The number of characters, not of UTF-16 code units. */
const length = (cell: string): number => [...cell].length;

const SIGMAS = ['p30', 'p40', 'p60', 'p80'] as const;

/** The robustness of a run as in JSON reports. */
export function robustnessJson(robustness: Robustness): RobustnessReport {
  const { p30, p40, p60, p80, certifiedTicks, decided, slack } = robustness;
  const interval = ({ low, high }: typeof p30): [number, number] => [low, high];
  return {
    p30: p30.p,
    p40: p40.p,
    p60: p60.p,
    p80: p80.p,
    certifiedTicks,
    decided,
    slack: slack.map(({ earlier, later }) => [earlier, later]),
    intervals: { p30: interval(p30), p40: interval(p40), p60: interval(p60), p80: interval(p80) },
    samples: p40.samples,
  };
}

/** `99.2 %`; 100 % and 0 % only if the value is exactly that. */
export function percent(share: number): string {
  if (share === 0 || share === 1) return `${100 * share} %`;
  return `${Math.min(99.9, Math.max(0.1, 100 * share)).toFixed(1)} %`;
}

/** The robustness of a run for people: lines with a label and a value. */
export function robustnessLines(robustness: Robustness): [label: string, text: string][] {
  const { certifiedTicks: ticks, slack, p40, decided } = robustness;
  const success = SIGMAS.map((key) => `${percent(robustness[key].p)} at ${robustness[key].sigma} ms`).join(', ');
  const sure =
    ticks === 0
      ? ''
      : `${plural(ticks, 'tick')} (${(1000 * ticks * TICK).toFixed(0)} ms): all presses and releases may be off by up to that, in every combination`;
  const beyond = decided ? '' : `; ${plural(ticks + 1, 'tick')} undecided: too many combinations to try`;
  const all = (sure || (decided ? 'no tick: some combination that is off by one tick fails' : 'no tick')) + beyond;
  const edges = slack.map(
    ({ earlier, later }, i) => `${i % 2 === 0 ? 'press' : 'release'} ${1 + (i >> 1)} -${earlier} +${later}`,
  );
  const lines: [string, string][] = [
    ['success', `${success} of timing noise`],
    ['', `at 40 ms between ${percent(p40.low)} and ${percent(p40.high)}, from ${p40.samples} attempts`],
    ['certified', all],
  ];
  for (let i = 0; i < edges.length; i += 4)
    lines.push([i === 0 ? 'slack' : '', `${edges.slice(i, i + 4).join(', ')}${i + 4 < edges.length ? ',' : ' ticks'}`]);
  return lines;
}

/** Adds the surrounding lines of the file to each problem that will be shown and has a place in the file. */
export function showProblems(problems: readonly Problem[], text: string): ShownProblem[] {
  return problems.map((problem, i) => ({
    ...problem,
    frame: i < MAX_SHOWN && problem.line !== null ? codeFrame(text, problem.line, problem.column ?? 1) : null,
  }));
}

/** The problems of a file that keep a command from its work. */
export interface FileProblems {
  readonly file: string;
  readonly problems: readonly ShownProblem[];
}

/**
 * Files have problems that must be corrected first. The message is for a terminal, with the lines around each place; who shows it
 * elsewhere takes `reason` and `files`.
 */
export class FileFailure extends Failure {
  /** @param reason what was not done and why, without the problems */
  constructor(
    readonly reason: string,
    readonly files: readonly FileProblems[],
  ) {
    const colors = colorsFor(process.stderr);
    super(
      `${reason}:\n${files
        .map(({ file, problems }) => showFileProblems(file, problems, colors))
        .join('')
        .trimEnd()}`,
    );
  }
}
