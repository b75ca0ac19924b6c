import { plural } from '../../check/words/index.ts';
import { failureOf, placeInWords } from '../show-failure/index.ts';
import { earlyEndInWords } from './early-end.ts';
import { pathInWorkspace, type ReportContext, type Results } from './reporter.ts';
import { type Annotation, workflowCommands } from './workflow-command.ts';

/** The results of `check` as workflow commands, which GitHub shows at the lines of a pull request, and a summary line. */
export function checkGithub(results: Results, { places, linkTo, quiet = false }: ReportContext): string {
  const { levels, totals } = results;
  const annotations = levels.flatMap((level): Annotation[] => {
    const failure = failureOf(level, linkTo);
    const file = pathInWorkspace(level.file, places);
    const problems = quiet ? level.problems.filter(({ severity }) => severity === 'error') : level.problems;
    return problems.map(({ severity, code, message, hint, line, column }) => {
      const lines = [message, hint];
      if (severity === 'error' && failure !== null) lines.push(`look at it: ${placeInWords(failure)}`);
      return { severity, file, line, column, title: code, message: lines.filter((text) => text !== '').join('\n') };
    });
  });
  for (const { file, problems } of results.packs ?? []) {
    for (const { severity, code, message, hint, line, column } of problems) {
      if (quiet && severity === 'warning') continue;
      annotations.push({
        severity,
        file: pathInWorkspace(file, places),
        line,
        column,
        title: code,
        message: hint === '' ? message : `${message}\n${hint}`,
      });
    }
  }
  const counts = Object.entries(totals.summary).filter(([, count]) => count > 0);
  const words = counts.map(([verdict, count]) => `${count} ${verdict}`).join(', ');
  const summary = `${plural(totals.levels, 'level')}${words === '' ? '' : `: ${words}`}`;
  if (results.excess) annotations.push(excessOf(results.excess));
  return `${workflowCommands(annotations)}${summary}\n${earlyEndInWords(results)}`;
}

const excessOf = (message: string): Annotation => ({
  severity: 'error',
  file: null,
  line: null,
  column: null,
  title: 'too many warnings',
  message,
});
