import { statSync } from 'node:fs';
import { Option } from 'commander';
import { type Inputs, Outputs, realTarget, standing, whyUnreachable } from '../io/index.ts';
import { didYouMean, Failure, namedPath } from '../terminal/index.ts';
import { REPORTER_NAMES, type ReporterName } from './reporter.ts';

/** A report that is asked for. */
export interface Destination {
  readonly name: ReporterName;
  /** The file it is written to; null: stdout. */
  readonly file: string | null;
}

/** The ways to ask for reports, as they were given. */
interface AskedReports {
  /** `--format NAME`, the short form for stdout. */
  readonly format?: string;
  /** `--reporter NAME[=FILE]`, as often as it was given. */
  readonly reporter?: readonly string[];
  /** `reporters` of the configuration. */
  readonly configured?: readonly string[];
}

const NAMES = REPORTER_NAMES.join(', ');

/** `--format`, whose default depends on the other options. */
export const reportFormatOption = (): Option =>
  new Option('--format <format>', 'format of the report on stdout: the short form of --reporter')
    .choices(REPORTER_NAMES)
    .default(undefined, 'pretty');

export const reporterOption = (): Option =>
  new Option(
    '--reporter <name[=file]>',
    `write a report to stdout or into a file; may be given several times: ${NAMES}`,
  ).argParser((text: string, others: readonly string[] | undefined) => [...(others ?? []), text]);

/**
 * The reports that are asked for. Options win over the configuration: `--reporter` replaces all of its reports, `--format` the
 * one for stdout. Without a report for stdout, there is a pretty one.
 * @throws Failure if they can't all be made
 */
export function chooseReports({ format, reporter, configured = [] }: AskedReports): Destination[] {
  const parsed =
    reporter !== undefined
      ? reporter.map((text) => parse(text, `--reporter ${text}`))
      : configured.map((text) => parse(text, `reporters: ${JSON.stringify(text)} in the configuration`));
  const forStdout = parsed.filter(({ file }) => file === null);
  const forFiles = parsed.filter(({ file }) => file !== null);
  if (format !== undefined && reporter === undefined) forStdout.length = 0;
  if (format !== undefined) forStdout.push({ name: format as ReporterName, file: null });
  if (forStdout.length > 1) {
    const names = forStdout.map(({ name }) => name);
    throw new Failure(
      `only one report can go to stdout, found ${forStdout.length}: ${names.join(', ')}; give the others a file, as in --reporter ${names[0]}=FILE`,
    );
  }
  return [...forFiles, forStdout[0] ?? { name: 'pretty', file: null }];
}

function parse(text: string, given: string): Destination {
  const at = text.indexOf('=');
  const name = at < 0 ? text : text.slice(0, at);
  const known = REPORTER_NAMES.find((one) => one === name);
  if (known === undefined) {
    throw new Failure(
      `${given}: there is no reporter ${JSON.stringify(name)}${didYouMean(name, REPORTER_NAMES)}; expected one of ${NAMES}`,
    );
  }
  if (at < 0) return { name: known, file: null };
  const file = text.slice(at + 1);
  if (file === '') throw new Failure(`${given}: expected a file after the =; without the =, the report goes to stdout`);
  return { name: known, file };
}

/**
 * Checks before the work that the reports can be written, and that they replace no file but an earlier report.
 * @param inputs files that no report may replace
 * @param force whether a report may replace a file that is none; never one of the inputs, nor a level
 * @throws Failure for each file that can't be written
 */
export function expectReportFiles(reports: readonly Destination[], inputs: Inputs, force: boolean): void {
  const files = reports.flatMap(({ name, file }) => (file === null ? [] : [{ name, file }]));
  if (files.length === 0) return;
  const seen = new Map<string, string>();
  const outputs = new Outputs(inputs);
  const wrong: string[] = [];
  for (const { name, file } of files) {
    const given = `--reporter ${name}=${file}`;
    const why = whyUnreachable(file);
    if (why !== null) {
      wrong.push(`${given}: ${namedPath(file)} can't be written: ${why}`);
      continue;
    }
    const id = realTarget(file);
    const other = seen.get(id);
    const replaced = outputs.wouldReplace(file);
    if (other !== undefined) wrong.push(`${given}: ${other} writes the same file; give each report a file of its own`);
    else if (replaced !== null) wrong.push(`${given}: the report would replace ${replaced}; give it another file`);
    else if (!force && isOther(file))
      wrong.push(
        `${given}: the report would replace ${namedPath(file)}, which is no report of gq; give it another file, or --force to replace it`,
      );
    if (isRegularOrNew(file)) seen.set(id, given);
  }
  if (wrong.length > 0) throw new Failure(`nothing was checked: ${wrong.join('\n')}`);
}

/** Whether a file is there that is no report. */
const isOther = (file: string): boolean =>
  statSync(file, { throwIfNoEntry: false })?.isFile() === true && standing(file) === 'other';

export const forceReportsOption = (): Option =>
  new Option('--force', 'let a report replace a file that is no report of gq; a level, and what is read, is never replaced');

/** Whether writing replaces a file, as opposed to a device such as /dev/null. */
const isRegularOrNew = (file: string): boolean => statSync(file, { throwIfNoEntry: false })?.isFile() !== false;
