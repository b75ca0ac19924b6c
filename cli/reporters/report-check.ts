import process from 'node:process';
import type { CheckedLevel } from '../check/index.ts';
import type { CommandResult, ResultFile } from '../command.ts';
import { inPieces } from '../report-parts/index.ts';
import { colorsFor, PLAIN, readVersion, widthOf } from '../terminal/index.ts';
import type { Destination } from './destinations.ts';
import { placesOf, type ReportContext, type Reporter, type ReporterName, type Results } from './reporter.ts';

/** Loads a reporter, and with it the words that it needs: only one that is used. */
const REPORTERS: Readonly<Record<ReporterName, () => Promise<Reporter>>> = {
  pretty: async () => (await import('./pretty.ts')).checkPretty,
  json: async () => (await import('./json.ts')).checkJson,
  github: async () => (await import('./github.ts')).checkGithub,
  junit: async () => (await import('./junit.ts')).checkJunit,
  sarif: async () => (await import('./sarif.ts')).checkSarif,
  markdown: async () => (await import('./markdown.ts')).checkMarkdown,
};

/**
 * Makes the reports of a check: those for files, and the one for stdout.
 * @param levels for a large set: gives all levels, as often as it is called; JSON is then made in pieces
 */
export async function reportCheck(
  results: Results,
  reports: readonly Destination[],
  {
    exitCode,
    terms,
    linkTo,
    quiet,
  }: Pick<ReportContext, 'terms' | 'linkTo' | 'quiet'> & { readonly exitCode: CommandResult['exitCode'] },
  levels: (() => Iterable<CheckedLevel>) | null = null,
): Promise<CommandResult> {
  const context: ReportContext = {
    colors: PLAIN,
    width: null,
    version: readVersion(),
    terms,
    exitCode,
    linkTo,
    quiet,
    places: placesOf(process.cwd(), process.env),
    isJenkins: Boolean(process.env.JENKINS_URL),
  };
  const files: ResultFile[] = [];
  let output: CommandResult['output'] = '';
  for (const { name, file } of reports) {
    if (name === 'json' && levels !== null) {
      const { checkJsonOf } = await import('./json.ts');
      const pieces = inPieces(() => checkJsonOf(levels(), results, linkTo));
      if (file === null) output = pieces;
      else files.push({ path: file, content: pieces, mode: 'replace' });
      continue;
    }
    const make = await REPORTERS[name]();
    if (file === null) output = make(results, { ...context, colors: colorsFor(process.stdout), width: widthOf(process.stdout) });
    else files.push({ path: file, content: make(results, context), mode: 'replace' });
  }
  const isSaid = reports.some(({ name, file }) => file === null && name === 'pretty');
  const messages = results.excess && !isSaid ? `error: ${results.excess}\n` : '';
  const summary = process.env.GITHUB_STEP_SUMMARY;
  if (!summary || !reports.some(({ name }) => name === 'github')) return { output, files, messages, exitCode };
  const { stepSummary } = await import('./markdown.ts');
  const step = stepSummary(summary, results, context);
  return { output, files: [...files, ...step.files], messages: messages + step.messages, exitCode };
}
