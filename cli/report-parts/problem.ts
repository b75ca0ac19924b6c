import { plural } from '../../check/words/index.ts';
import { MORE_WARNINGS } from '../../engine/basics/index.ts';
import { type Colors, visible, visibleLine } from '../io/index.ts';
import { MAX_SHOWN, type ShownProblem } from '../shown-problem.ts';

/** `file:line:col`, or only the file if a problem concerns all of it. */
function place(file: string, { line, column }: ShownProblem): string {
  return visibleLine(line === null ? file : `${file}:${line}:${column ?? 1}`);
}

/** One problem for people: its place first, then the message, the lines around it, and the hint. */
export function showProblem(file: string, problem: ShownProblem, colors: Colors): string {
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
