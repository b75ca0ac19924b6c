import { plural, termsInWords, VERDICT_MEANS } from '../../check/words/index.ts';
import { TICK } from '../../engine/basics/index.ts';
import type { SoftlockReport, Verdict } from '../../schema/index.ts';
import type { CheckedLevel, Totals } from '../check/index.ts';
import { alignColumns, showFileProblems } from '../report-parts/index.ts';
import { failureOf, placeInWords } from '../show-failure/index.ts';
import { visibleLine } from '../terminal/index.ts';
import { earlyEndInWords, runInWords } from './early-end.ts';
import type { ReportContext, Results } from './reporter.ts';

const WHAT_TO_DO: Record<Exclude<Verdict, 'completable'>, string> = {
  broken: 'change the level or a run; gq simulate shows how a run ends',
  unproven: 'gq solve looks for a run',
  impossible: 'change the level',
  invalid: 'fix the problems above',
  crashed: 'please report it, with the level',
};

/** The results of `check` for people: a line for each level with its problems below, and a summary. */
export function checkPretty(results: Results, { colors, width, linkTo, terms, quiet = false }: ReportContext): string {
  const { levels: reports, totals } = results;
  const listed = quiet ? reports.flatMap(onlyErrors) : reports;
  const lines = alignColumns(listed.map(row), { right: [TIME_COLUMN], width });
  const paint = (verdict: Verdict): ((text: string) => string) =>
    verdict === 'completable' ? colors.green : verdict === 'unproven' ? colors.yellow : colors.red;
  let text = '';
  for (const [i, level] of listed.entries()) {
    const { file, verdict, problems } = level;
    if (results.shown?.has(file) === false) continue;
    text += `${paint(verdict)(verdict)}${lines[i].slice(verdict.length)}\n${showFileProblems(file, problems, colors)}`;
    if (level.softlocks !== undefined && !quiet)
      text += softlockLines(level.softlocks)
        .map((line) => `    ${colors.dim(line)}\n`)
        .join('');
    const failure = failureOf(level, linkTo);
    if (failure !== null) text += `    ${colors.dim(`look at it: ${visibleLine(placeInWords(failure))}`)}\n`;
  }
  const packs = (quiet ? results.packs?.map(withoutWarnings) : results.packs) ?? [];
  for (const { file, problems } of packs) text += showFileProblems(file, problems, colors);
  const counts = Object.entries(totals.summary).filter(([, count]) => count > 0);
  const words = counts.map(([v, count]) => paint(v as Verdict)(`${count} ${v}`)).join(', ');
  const under = termsInWords(terms);
  const count = `${colors.bold(plural(totals.levels, 'level'))}${under === '' ? '' : `, ${under}`}${words === '' ? '' : `: ${words}`}${besides(totals, quiet)}`;
  text += `${quiet && listed.length === 0 && packs.every(({ problems }) => problems.length === 0) ? '' : '\n'}${count}\n${earlyEndInWords(results)}`;
  if (results.excess) text += `${colors.red(results.excess)}\n`;
  const { tight, differing, packErrors } = totals;
  if (packErrors > 0) text += `${colors.red(`${plural(packErrors, 'error')} in the order of a pack`)}\n`;
  if (tight > 0)
    text += `${colors.red(`${plural(tight, 'level')} ${tight === 1 ? 'forgives' : 'forgive'} less than --require-slack requires`)}\n`;
  if (differing > 0) text += `${colors.red(`${plural(differing, 'level')} not as agreed on in the lock`)}\n`;
  for (const [verdict] of counts as [Verdict, number][]) {
    if (verdict !== 'completable') text += `${verdict}: ${VERDICT_MEANS[verdict]}: ${WHAT_TO_DO[verdict]}\n`;
  }
  if ([...listed, ...packs].some(({ problems }) => problems.length > 0)) text += 'gq explain CODE says more about a problem\n';
  return text;
}

const withoutWarnings = <T extends Pick<CheckedLevel, 'problems'>>(checked: T): T => ({
  ...checked,
  problems: checked.problems.filter(({ severity }) => severity === 'error'),
});

/** A level that has errors, with those alone; nothing for another. */
function onlyErrors(report: CheckedLevel): CheckedLevel[] {
  const level = withoutWarnings(report);
  return level.problems.length === 0 && report.verdict === 'completable' ? [] : [level];
}

/** What the summary says besides verdicts: allowed problems, and warnings where they are not listed. */
function besides({ allowed, warnings }: Totals, quiet: boolean): string {
  const notes = [
    warnings === 0 || !quiet ? '' : plural(warnings, 'warning'),
    allowed === 0 ? '' : `${plural(allowed, 'problem')} allowed`,
  ];
  const said = notes.filter((note) => note !== '').join(', ');
  return said === '' ? '' : `; ${said}`;
}

const TIME_COLUMN = 3;

/** The cells of a line: verdict, file, name, time, minerals, clearance. */
function row(level: CheckedLevel): string[] {
  const { verdict, file, name } = level;
  const shownName = verdict === 'invalid' || verdict === 'crashed' ? '' : visibleLine(name);
  return [verdict, visibleLine(file), shownName, ...runInWords(level)];
}

/** At most so many places are listed. */
const MOST = 5;

/** How many of the states are open, lost, about to end, and undecided. What is proved and what was not found stay apart. */
function counts({ states, lasting, isFinished }: SoftlockReport): string {
  const share = (count: number): string => `${count} (${((100 * count) / Math.max(1, states.examined)).toFixed(0)} %)`;
  const soonOver = states.proved - lasting.proved + states.notFound - lasting.notFound;
  return [
    `of ${plural(states.examined, 'state')} ${share(states.open)} open`,
    `lost although she lives on: ${share(lasting.proved)} proved, ${share(lasting.notFound)} from which no run was found`,
    ...(soonOver > 0 ? [`${share(soonOver)} over within a second`] : []),
    ...(states.unknown > 0 ? [`${share(states.unknown)} undecided`] : []),
    ...(isFinished ? [] : ['the effort ended the search']),
  ].join('; ');
}

/** Where a level is already lost, in lines. @param report null: it was not examined */
export function softlockLines(report: SoftlockReport | null): string[] {
  if (report === null) return ['where it is already lost was not examined: no run completes the level'];
  const { places } = report;
  const lines = places.slice(0, MOST).map(({ x, y, tick, alive, proof, searched }) => {
    const known = proof === null ? `no run found in ${searched} ticks, which proves nothing` : `proved (${proof.code})`;
    return `  (${Math.round(x)}, ${Math.round(y)}) from ${(tick * TICK).toFixed(2)} s on, alive for ${(alive * TICK).toFixed(1)} s after it: ${known}`;
  });
  return [
    counts(report),
    ...lines,
    ...(places.length > MOST ? [`  and ${places.length - MOST} more: --format json lists them`] : []),
  ];
}
