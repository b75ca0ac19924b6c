import type { CheckedLevel } from '../check/index.ts';
import type { CheckedPack } from '../pack-file/index.ts';
import type { ShownProblem } from '../report-parts/index.ts';
import { type EditorLink, failureOf, isFailing } from '../show-failure/index.ts';
import { visibleLine } from '../terminal/index.ts';
import { runInWords, unlistedInWords } from './early-end.ts';
import { pathInRepository, type ReportContext, type Results } from './reporter.ts';

type State = 'passed' | 'failure' | 'error' | 'skipped';

interface TestCase {
  readonly folder: string;
  readonly state: State;
  /** s */
  readonly time: number;
  readonly xml: string;
}

/** The results of `check` as JUnit XML: a test case for each level, a suite for each folder. */
export function checkJunit(results: Results, context: ReportContext): string {
  const { levels, packs = [], unchecked, interrupted, excess } = results;
  const why = interrupted ? 'not checked: a signal ended the check early' : 'not checked: the check ended early';
  const cases = [
    ...levels.map((level) => caseOf(level, context)),
    ...packs.map((pack) => packCase(pack, context)),
    ...unchecked.map((file) => skippedCase(file, why, context)),
  ];
  const folders = [...new Set(cases.map(({ folder }) => folder))];
  const suites = folders.map((folder) =>
    suiteOf(
      folder,
      cases.filter((one) => one.folder === folder),
      context,
      [excess ?? '', unlistedInWords(results)].filter((text) => text !== ''),
    ),
  );
  const { skipped: _, ...counts } = countsOf(cases);
  return `<?xml version="1.0" encoding="UTF-8"?>\n<testsuites${xmlAttributes({ name: 'gq check', ...counts })}>\n${suites.join('')}</testsuites>\n`;
}

function countsOf(cases: readonly TestCase[]) {
  const count = (state: State): number => cases.filter((one) => one.state === state).length;
  return {
    tests: cases.length,
    failures: count('failure'),
    errors: count('error'),
    skipped: count('skipped'),
    time: cases.reduce((sum, { time }) => sum + time, 0).toFixed(3),
  };
}

/** @param words what is true of the whole check and of no level: too many warnings, levels that are not listed */
function suiteOf(
  folder: string,
  cases: readonly TestCase[],
  { version, terms: { accuracy, maxTime, maxWork } }: ReportContext,
  words: readonly string[],
): string {
  const said = {
    'gq.version': version,
    'gq.accuracy': accuracy.name,
    'gq.maxTime': String(maxTime),
    'gq.maxWork': String(maxWork),
  };
  const properties = Object.entries(said)
    .map(([name, value]) => `      <property${xmlAttributes({ name, value })}/>\n`)
    .join('');
  const system = words.length === 0 ? '' : `    <system-err>${xmlText(words.join('\n'))}\n</system-err>\n`;
  const head = xmlAttributes({ name: folder, ...countsOf(cases) });
  return `  <testsuite${head}>\n    <properties>\n${properties}    </properties>\n${cases.map(({ xml }) => xml).join('')}${system}  </testsuite>\n`;
}

/** How a test case is found: its folder as the class, its file as the name. */
function identityOf(file: string, { places, isJenkins }: ReportContext) {
  const path = pathInRepository(file, places) ?? file.replaceAll('\\', '/');
  const at = path.lastIndexOf('/');
  const folder = at < 0 ? '.' : path.slice(0, at) || '/';
  return {
    folder,
    // Jenkins groups by what stands before the last dot
    classname: folder === '.' ? 'levels' : folder.replace(/^\/+/, '').replaceAll('/', '.'),
    name: path.slice(at + 1).replace(/\.level\.json$/, ''),
    // the schema of Jenkins' xUnit plugin refuses it; GitLab and others link to it
    file: isJenkins ? undefined : path,
  };
}

function caseOf(level: CheckedLevel, context: ReportContext): TestCase {
  const { folder, ...identity } = identityOf(level.file, context);
  const state = stateOf(level);
  const time = level.ms / 1000;
  const body = `${state === 'passed' ? '' : failure(state, level, context.linkTo)}      <system-out>${xmlText(output(level, context.linkTo))}</system-out>\n`;
  const head = xmlAttributes({ ...identity, time: time.toFixed(3) });
  return { folder, state, time, xml: `    <testcase${head}>\n${body}    </testcase>\n` };
}

/** The order of a pack: a case beside those of its levels. */
function packCase(pack: CheckedPack, context: ReportContext): TestCase {
  const { folder, ...identity } = identityOf(pack.file, context);
  const errors = pack.problems.filter(({ severity }) => severity === 'error');
  const state = errors.length === 0 ? 'passed' : pack.unreadable ? 'error' : 'failure';
  const head = xmlAttributes({ message: visibleLine(errors[0]?.message ?? ''), type: errors[0]?.code ?? '' });
  const all = pack.problems.map((problem) => problemText(pack, problem)).join('\n');
  const failed =
    state === 'passed'
      ? ''
      : `      <${state}${head}>${xmlText(errors.map((problem) => problemText(pack, problem)).join('\n'))}</${state}>\n`;
  const output = `      <system-out>${xmlText(`${visibleLine(pack.name ?? 'not valid')}\n${all}`.trimEnd())}\n</system-out>\n`;
  const xml = `    <testcase${xmlAttributes({ ...identity, time: '0.000' })}>\n${failed}${output}    </testcase>\n`;
  return { folder, state, time: 0, xml };
}

function skippedCase(file: string, why: string, context: ReportContext): TestCase {
  const { folder, ...identity } = identityOf(file, context);
  const head = xmlAttributes({ ...identity, time: '0.000' });
  const xml = `    <testcase${head}>\n      <skipped${xmlAttributes({ message: why })}/>\n    </testcase>\n`;
  return { folder, state: 'skipped', time: 0, xml };
}

/** An error is a level that could not be judged. */
function stateOf(level: CheckedLevel): State {
  if (!isFailing(level)) return 'passed';
  return level.verdict === 'crashed' || level.unreadable ? 'error' : 'failure';
}

/** The failure of a level: its first error in brief, all of them in full, and where to look. */
function failure(state: State, level: CheckedLevel, linkTo: EditorLink | null): string {
  const { verdict, problems } = level;
  const errors = problems.filter(({ severity }) => severity === 'error');
  const message = errors.length === 0 ? verdict : `${verdict}: ${visibleLine(errors[0].message)}`;
  const text = [...errors.map((problem) => problemText(level, problem)), ...placeText(level, linkTo)].join('\n');
  const head = xmlAttributes({ message, type: errors[0]?.code ?? verdict });
  return `      <${state}${head}>${xmlText(text)}</${state}>\n`;
}

function problemText(
  { file }: Pick<CheckedLevel, 'file'>,
  { severity, code, message, hint, line, column, frame }: ShownProblem,
): string {
  const place = line === null ? file : `${file}:${line}:${column ?? 1}`;
  const rest = [frame?.trimEnd() ?? '', hint].filter((text) => text !== '').map((text) => `\n${text.replace(/^/gm, '    ')}`);
  return `${place}: ${severity} ${code}: ${message}${rest.join('')}`;
}

function placeText(level: CheckedLevel, linkTo: EditorLink | null): string[] {
  const place = failureOf(level, linkTo);
  if (place === null) return [];
  const { command, link } = place;
  return [`look at it: ${command}`, ...(link === null ? [] : [link])];
}

/** What a passing level says, too: its name, its run, its warnings. */
function output(level: CheckedLevel, linkTo: EditorLink | null): string {
  const run = runInWords(level);
  const lines = [`${level.verdict}: ${visibleLine(level.name)}`, ...(run.length === 0 ? [] : [run.join(', ')])];
  for (const problem of level.problems) if (problem.severity === 'warning') lines.push(problemText(level, problem));
  lines.push(...placeText(level, linkTo));
  return `${lines.join('\n')}\n`;
}

/**
 * Text for XML 1.0. Characters that no XML document can hold, not even as references, become visible \u escapes: control
 * characters, lone surrogates, U+FFFE and U+FFFF.
 */
function xmlText(text: string): string {
  return (
    text
      // biome-ignore lint/suspicious/noControlCharactersInRegex: control characters are what this looks for
      .replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\u007f-\u0084\u0086-\u009f\ufffe\uffff]|\p{Surrogate}/gu, asEscape)
      .replaceAll('&', '&amp;')
      .replaceAll('<', '&lt;')
      .replaceAll('>', '&gt;')
      // a reader turns a plain one into a newline
      .replaceAll('\r', '&#13;')
  );
}

/** Text for an attribute in double quotes, whose newlines and tabs a reader would turn into spaces. */
const xmlAttribute = (text: string): string =>
  xmlText(text).replaceAll('"', '&quot;').replaceAll('\n', '&#10;').replaceAll('\t', '&#9;');

const asEscape = (character: string): string => `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`;

/** The attributes of an element; those that are undefined are left out. */
function xmlAttributes(attributes: Readonly<Record<string, string | number | undefined>>): string {
  return Object.entries(attributes)
    .map(([name, value]) => (value === undefined ? '' : ` ${name}="${xmlAttribute(String(value))}"`))
    .join('');
}
