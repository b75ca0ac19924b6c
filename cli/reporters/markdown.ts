import { statSync } from 'node:fs';
import { plural, VERDICT_MEANS } from '../../check/words/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import type { ResultFile } from '../command.ts';
import { MAX_SHOWN, type ShownProblem } from '../report-parts/index.ts';
import { type EditorLink, failureOf, isFailing } from '../show-failure/index.ts';
import { visible, visibleLine } from '../terminal/index.ts';
import { runInWords } from './early-end.ts';
import { pathInWorkspace, type ReportContext, type Results } from './reporter.ts';

/** Bytes that a comment on GitHub may have. */
export const COMMENT_BYTES = 65_536;

/** Bytes that are kept for what was left out. */
const RESERVE = 400;

/** A part of the report, which is there as a whole or not at all. */
interface Part {
  readonly text: string;
  readonly bytes: number;
}

const part = (text: string): Part => ({ text, bytes: Buffer.byteLength(text) });

/** The results of `check` as Markdown for people: failing levels first, each with its problems folded; at most a comment's size. */
export const checkMarkdown = (results: Results, { linkTo }: ReportContext): string =>
  markdownWithin(results, linkTo, COMMENT_BYTES);

/**
 * The same in any size.
 * @param mostBytes the largest size in UTF-8; what does not fit is left out, and the end says so
 * @param shown a file as the table names it
 */
export function markdownWithin(
  results: Results,
  linkTo: EditorLink | null,
  mostBytes: number,
  shown: (file: string) => string = (file) => file,
): string {
  const { levels, packs = [], unlisted = 0 } = results;
  const failing = levels.filter(isFailing);
  const passing = levels.filter((level) => !isFailing(level));
  const warned = passing.filter(({ problems }) => problems.length > 0);
  const space = new Space(mostBytes - RESERVE);

  const head = space.take([part(heading(results))]);
  if (head.length === 0) return '';
  const rows = space.take(
    failing.map((level) => part(row(level, shown))),
    TABLE,
  );
  const wrong = packs.filter(({ problems }) => problems.length > 0);
  const orders = space.take(wrong.map((pack) => part(details(pack, '', shown))));
  const problems = space.take([...failing, ...warned].map((level) => part(details(level, placeText(level, linkTo), shown))));
  const fine = space.take(
    passing.map((level) => part(row(level, shown))),
    PASSING,
  );
  const early = space.take(earlyEnd(results).map(part));

  const left = [
    [failing.length + unlisted - rows.length, 'failing level', 'failing levels'],
    [wrong.length - orders.length, 'order of a pack', 'orders of packs'],
    [failing.length + warned.length - problems.length, 'level with its problems', 'levels with their problems'],
    [passing.length - fine.length, 'completable level', 'completable levels'],
  ] as const;
  const leftOut = left.filter(([count]) => count > 0).map(([count, one, many]) => plural(count, one, many));
  const note =
    leftOut.length === 0 ? '' : `\nLeft out, as it did not fit: ${leftOut.join('; ')}. The JSON report has everything.\n`;
  const text = [
    head.join(''),
    rows.length === 0 ? '' : `${TABLE}${rows.join('')}`,
    orders.length === 0 ? '' : `\n${orders.join('')}`,
    problems.length === 0 ? '' : `\n${problems.join('')}`,
    fine.length === 0 ? '' : `${PASSING}${fine.join('')}\n</details>\n`,
    early.join(''),
    note,
  ].join('');
  return Buffer.byteLength(text) <= mostBytes ? text : '';
}

/** The space that is left in a report. */
class Space {
  constructor(private left: number) {}

  /** The first parts that fit, below a frame that is only there if one of them is. */
  take(parts: readonly Part[], frame = ''): string[] {
    const taken: string[] = [];
    const before = this.left;
    this.left -= frame === '' ? 0 : Buffer.byteLength(frame) + FRAME_END;
    for (const { text, bytes } of parts) {
      if (bytes > this.left) break;
      this.left -= bytes;
      taken.push(text);
    }
    if (taken.length === 0) this.left = before;
    return taken;
  }
}

/** Bytes of what may follow a frame's parts. */
const FRAME_END = 20;

const HEADER = '| verdict | level | name | run or problem |\n| --- | --- | --- | --- |\n';
const TABLE = `\n${HEADER}`;
const PASSING = `\n<details><summary>Completable levels</summary>\n\n${HEADER}`;

const GOOD = 'Every level is good';

function heading({ totals, unchecked, interrupted, excess }: Results): string {
  const { levels, packErrors } = totals;
  const failing = levels - totals.good;
  const counts = Object.entries(totals.summary).filter(([, count]) => count > 0);
  const words = counts.map(([verdict, count]) => `${count} ${verdict}`).join(', ');
  const title =
    levels === 0
      ? 'No level was checked'
      : failing === 0
        ? packErrors > 0
          ? 'The order of a pack has errors'
          : excess
            ? 'Too many warnings'
            : interrupted || unchecked.length > 0
              ? 'The check is not complete'
              : GOOD
        : `${failing} of ${plural(levels, 'level')} ${failing === 1 ? 'fails' : 'fail'}`;
  const isGood = title === GOOD;
  return `### ${isGood ? '✅' : '❌'} ${title}\n\n${plural(levels, 'level')}${words === '' ? '' : `: ${words}`}\n${excess ? `\n**${excess}**\n` : ''}`;
}

function row(level: CheckedLevel, shownFile: (file: string) => string): string {
  const { verdict, file, name, problems } = level;
  const error = problems.find(({ severity }) => severity === 'error');
  const last =
    error === undefined
      ? runInWords(level).join(', ') || (verdict === 'completable' ? '' : VERDICT_MEANS[verdict])
      : error.message;
  return `| ${isFailing(level) ? '❌ ' : ''}${verdict} | ${markdownCode(shownFile(file))} | ${markdownText(name)} | ${markdownText(last)} |\n`;
}

/** The problems of a level or a pack, and where to look, folded. */
function details(
  { file, problems }: Pick<CheckedLevel, 'file' | 'problems'>,
  where: string,
  shownFile: (file: string) => string,
): string {
  const count = (severity: string): number => problems.filter((problem) => problem.severity === severity).length;
  const counts = [plural(count('error'), 'error'), plural(count('warning'), 'warning')].filter((text) => !text.startsWith('0'));
  const shown = problems.slice(0, MAX_SHOWN).map(problemText);
  const more = problems.length > MAX_SHOWN ? `- and ${problems.length - MAX_SHOWN} more\n` : '';
  const summary = `${markdownCode(shownFile(file))}: ${counts.join(', ')}`;
  return `<details><summary>${summaryHtml(summary)}</summary>\n\n${shown.join('')}${more}\n${where}</details>\n`;
}

/** A summary is HTML, in which nothing of Markdown is read. */
const summaryHtml = (markdown: string): string =>
  markdown.replace(
    /^`([^`]*)`/,
    (_, code: string) => `<code>${code.replace(/[&<>]/g, (one) => `&#${one.charCodeAt(0)};`)}</code>`,
  );

function problemText({ severity, code, message, hint, line, column, frame }: ShownProblem): string {
  const place = line === null ? '' : ` in line ${line}, column ${column ?? 1}`;
  const rest = hint === '' ? '' : `  \n  ${markdownText(hint)}`;
  const lines = frame === null ? '' : `\n${markdownBlock(visible(frame)).replace(/^(?=.)/gm, '  ')}`;
  return `- **${severity}** ${markdownCode(code)}${place}: ${markdownText(message)}${rest}\n${lines}`;
}

function placeText(level: CheckedLevel, linkTo: EditorLink | null): string {
  const place = failureOf(level, linkTo);
  if (place === null) return '';
  const { command, link } = place;
  const shown = link === null ? '' : `[Open the editor there](<${link.replace(/[<>\s]/g, encodeURIComponent)}>), or: `;
  return `${link === null ? 'Look at it: ' : shown}${markdownCode(command)}\n\n`;
}

function earlyEnd({ unchecked, interrupted }: Results): string[] {
  if (!interrupted && unchecked.length === 0) return [];
  const why = interrupted ? 'A signal ended the check early' : 'The check ended early';
  const files = unchecked.slice(0, 20).map((file) => `- ${markdownCode(file)}\n`);
  const more = unchecked.length > 20 ? `- and ${unchecked.length - 20} more\n` : '';
  return [`\n**${why}**: ${plural(unchecked.length, 'level')} not checked\n\n${files.join('')}${more}`];
}

/** Text on one line that is shown as it is: no markup, no HTML, no mention of a person or an issue, no end of a table's cell. */
export const markdownText = (text: string): string =>
  wellFormedLine(text)
    .replace(/[&<>|\\`*_[\]~]|@|#(?=\d)|:(?=\/\/)|(?<=\bwww)\./g, (found) => {
      if (/[&<>|\\]/.test(found)) return entity(found);
      // a service that looks for mentions and addresses finds none across a comment
      return /[`*_[\]~]/.test(found) ? `\\${found}` : `${found}<!-- -->`;
    })
    // what would begin a list or a heading
    .replace(/^[-+=](?= |$)|^#(?=#{0,5} )|^\d(?=\d*[.)](?: |$))/, entity);

const entity = (character: string): string => `&#${character.charCodeAt(0)};`;

/** Text in the letters of code, in a table's cell as well. */
export function markdownCode(text: string): string {
  const line = wellFormedLine(text);
  if (/^[^`|\\]+$/.test(line) && line.trim() === line) return `\`${line}\``;
  return `<code>${line.replace(/[!-/:-@[-`{-~]/g, entity)}</code>`;
}

/** Lines in the letters of code: a block that nothing in the text can end. */
export function markdownBlock(text: string): string {
  const longest = Math.max(2, ...[...text.matchAll(/`+/g)].map(([run]) => run.length));
  const fence = '`'.repeat(longest + 1);
  return `${fence}text\n${text.trimEnd().split('\n').map(wellFormedLine).join('\n')}\n${fence}\n`;
}

/** Characters that move the cursor or break a line become visible, and so do halves of characters. */
const wellFormedLine = (text: string): string =>
  visibleLine(text)
    .replace(/[\u2028\u2029]/g, ' ')
    .replace(/\p{Surrogate}/gu, '\ufffd');

/** Bytes that GitHub takes as the summary of a step; of a larger file it takes nothing. */
const STEP_BYTES = 1024 * 1024;

/**
 * What to add to the summary of a step of a workflow, of which earlier commands may have written a part.
 * @param path `GITHUB_STEP_SUMMARY`
 */
export function stepSummary(
  path: string,
  results: Results,
  { linkTo, places }: Pick<ReportContext, 'linkTo' | 'places'>,
): { readonly files: ResultFile[]; readonly messages: string } {
  const before = statSync(path, { throwIfNoEntry: false })?.size ?? 0;
  const start = before === 0 ? '' : '\n';
  const content = markdownWithin(results, linkTo, STEP_BYTES - before - start.length, (file) => pathInWorkspace(file, places));
  if (content !== '') return { files: [{ path, content: start + content, mode: 'append' }], messages: '' };
  return { files: [], messages: 'warning: the summary of this step is full (1 MiB): the table of levels is left out\n' };
}
