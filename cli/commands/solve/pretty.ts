import { accuracyInWords, countMinerals, effortInWords, holdsInWords, outcomeInWords } from '../../../check/words/index.ts';
import { type Colors, visible, visibleLine } from '../../io/index.ts';
import { closestRunInWords, robustnessLines } from '../../report-parts/index.ts';
import type { Solved, SolvedRun, SolveSettings } from '../../solve/index.ts';

/** The results of `solve` for people. */
export function solvePretty(settings: SolveSettings, solved: Solved, colors: Colors): string {
  const { level, terms } = settings;
  const { runs, effort, impossible, closest } = solved;
  const head = `${colors.bold(visibleLine(level.name))}, ${accuracyInWords(terms)}`;
  if (impossible !== null) {
    return (
      `${head}\n${colors.red('proved impossible')}: ${visible(impossible.reason)}\n\n` +
      `${rows([['proof', `${impossible.code}; a separate checker has confirmed its certificate (--format json shows it)`]])}`
    );
  }
  const spent: [string, string] = ['effort', `${effortInWords(effort)}, ${solved.seconds.toFixed(1)} s, seed ${settings.seed}`];
  if (runs.length === 0) {
    const lines: [string, string][] = [spent];
    if (closest !== null) lines.push(['closest', closestRunInWords(closest)]);
    return `${head}\n${colors.yellow('no run found')}; this does not prove that there is none\n\n${rows(lines)}`;
  }
  const parts = runs.map((run, i) => {
    const title = runs.length === 1 ? '' : `${colors.bold(`${i + 1} of ${runs.length}`)}: `;
    return `${title}${colors.green(outcomeInWords(run.run, level.range))}\n${rows(linesOf(settings, run))}`;
  });
  return `${head}\n${parts.join('\n')}\n${rows([spent])}`;
}

function linesOf({ level }: SolveSettings, { holds, run, robustness }: SolvedRun): [string, string][] {
  return [
    ['holds', holdsInWords(holds)],
    ['minerals', `${countMinerals(run)} of ${level.minerals.length}`],
    ...robustnessLines(robustness),
    ['hash', run.hash],
  ];
}

const WIDTH = 11;

const rows = (lines: readonly (readonly [string, string])[]): string =>
  lines.map(([label, text]) => `${label.padEnd(WIDTH)}${text}\n`).join('');
