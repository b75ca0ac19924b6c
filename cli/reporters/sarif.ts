import { createHash } from 'node:crypto';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { plural } from '../../check/words/index.ts';
import type { CodeExplanation } from '../../schema/index.ts';
import { type CheckedLevel, keyOf } from '../check/index.ts';
import { EXPLAINED_CODES } from '../explained-codes.ts';
import type { ShownProblem } from '../report-parts/index.ts';
import { failureOf } from '../show-failure/index.ts';
import { visible, visibleLine } from '../terminal/index.ts';
import { unlistedInWords } from './early-end.ts';
import { pathInRepository, type ReportContext, type Results, rootOf } from './reporter.ts';

const SCHEMA = 'https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json';

/** The folder that paths are relative to, as readers of SARIF call the root of a repository. */
const ROOT = '%SRCROOT%';

/** GitHub refuses a run with more results. */
const MOST_RESULTS = 25_000;

/** Files that were not checked and that a message names. */
const MOST_NAMED = 100;

/** The results of `check` as SARIF 2.1.0: a result for each problem, a rule for each code that occurs. */
export function checkSarif(results: Results, context: ReportContext): string {
  const { levels, packs = [] } = results;
  const fingerprints = new Fingerprints();
  const { exitCode, places, version } = context;
  const all = [
    ...levels.flatMap((level) => {
      const place = failureOf(level, context.linkTo);
      return level.problems.map((problem) => resultOf(level, place, problem, fingerprints, context));
    }),
    ...packs.flatMap((pack) => pack.problems.map((problem) => resultOf(pack, null, problem, fingerprints, context))),
  ];
  const { kept, leftOut } = worst(all);
  const codes = [...new Set(kept.map(({ ruleId }) => ruleId))].sort();
  const run = {
    tool: {
      driver: { name: 'gq', fullName: 'Gravity Quest toolkit', semanticVersion: version, version, rules: codes.map(ruleOf) },
    },
    invocations: [
      {
        exitCode,
        ...(results.excess ? { exitCodeDescription: results.excess } : {}),
        executionSuccessful: exitCode < 2,
        workingDirectory: { uri: folderUri(places.directory) },
        toolExecutionNotifications: [...leftOut, ...unlisted(results), ...earlyEnd(results)],
      },
    ],
    originalUriBaseIds: { [ROOT]: { uri: folderUri(rootOf(places)) } },
    columnKind: 'utf16CodeUnits',
    results: kept.map((result) => ({ ...result, ruleIndex: codes.indexOf(result.ruleId) })),
  };
  return `${JSON.stringify({ $schema: SCHEMA, version: '2.1.0', runs: [run] }, null, 2)}\n`;
}

type Result = ReturnType<typeof resultOf>;

/** The results that a reader takes, errors before warnings, in the order in which they came; and how many are left out. */
function worst(all: readonly Result[]): { readonly kept: readonly Result[]; readonly leftOut: readonly Notification[] } {
  if (all.length <= MOST_RESULTS) return { kept: all, leftOut: [] };
  const errors = all.filter(({ level }) => level === 'error');
  const warnings = all.filter(({ level }) => level !== 'error');
  const keptErrors = errors.slice(0, MOST_RESULTS);
  const keptWarnings = warnings.slice(0, MOST_RESULTS - keptErrors.length);
  const kept = new Set([...keptErrors, ...keptWarnings]);
  const lost = [
    [errors.length - keptErrors.length, 'error'],
    [warnings.length - keptWarnings.length, 'warning'],
  ] as const;
  const words = lost.filter(([count]) => count > 0).map(([count, one]) => plural(count, one));
  const text = `${words.join(' and ')} left out: a run may have ${MOST_RESULTS} results, and errors come first; the JSON report has all`;
  return { kept: all.filter((result) => kept.has(result)), leftOut: [{ level: 'warning', message: { text } }] };
}

function ruleOf(code: string) {
  const explained = EXPLAINED_CODES.find((one) => one.code === code);
  if (explained === undefined) return { id: code };
  const { title, why, severity } = explained;
  return {
    id: code,
    shortDescription: { text: title },
    fullDescription: { text: why },
    help: helpOf(explained),
    defaultConfiguration: { level: severity },
  };
}

function helpOf({ why, fix, example }: CodeExplanation) {
  const shown = example === undefined ? ['', ''] : [`\n\nExample:\n${example}`, `\n\n\`\`\`text\n${example}\n\`\`\``];
  return { text: `${why}\n\nHow to fix it: ${fix}${shown[0]}`, markdown: `${why}\n\n**How to fix it:** ${fix}${shown[1]}` };
}

function resultOf(
  checked: Pick<CheckedLevel, 'file' | 'unreadable'>,
  place: ReturnType<typeof failureOf>,
  problem: ShownProblem,
  fingerprints: Fingerprints,
  context: ReportContext,
) {
  const { code, severity, message, hint, line, column } = problem;
  const failure = severity === 'error' ? place : null;
  const lines = [message, hint, failure === null ? '' : `look at it: ${failure.command}`].filter((text) => text !== '');
  const artifactLocation = locationOf(checked.file, context);
  const fingerprint = fingerprints.next(code, artifactLocation.uri, problem.key ?? keyOf(problem.pointer, null));
  // a problem of the whole file is shown at its first line; of a file that can't be read, nothing is known
  const region = line === null ? { startLine: 1 } : { startLine: line, startColumn: column ?? 1 };
  return {
    ruleId: code,
    level: severity,
    message: { text: wellFormed(visible(lines.join('\n'))) },
    locations: [{ physicalLocation: checked.unreadable ? { artifactLocation } : { artifactLocation, region } }],
    // GitHub reads only the second
    partialFingerprints: { 'gqProblem/v1': fingerprint, primaryLocationLineHash: fingerprint },
    ...(failure?.link ? { hostedViewerUri: failure.link } : {}),
  };
}

/** Fingerprints that stay when lines, other objects or other problems come and go. */
class Fingerprints {
  private readonly seen = new Map<string, number>();

  /** The fingerprint of the next problem of this code at this place. */
  next(code: string, uri: string, key: string): string {
    const hash = createHash('sha256')
      .update(JSON.stringify([code, uri, key]))
      .digest('hex')
      .slice(0, 32);
    const number = (this.seen.get(hash) ?? 0) + 1;
    this.seen.set(hash, number);
    return `${hash}:${number}`;
  }
}

function locationOf(file: string, { places }: ReportContext): { uri: string; uriBaseId?: string } {
  const inside = pathInRepository(file, places);
  if (inside !== null) return { uri: encodePath(inside), uriBaseId: ROOT };
  return { uri: pathToFileURL(resolve(places.directory, wellFormed(file))).href };
}

const encodePath = (path: string): string => wellFormed(path).split('/').map(encodeURIComponent).join('/');

const folderUri = (folder: string): string => pathToFileURL(join(folder, '/')).href;

/** Halves of characters can't be percent-encoded. */
const wellFormed = (text: string): string => text.replace(/\p{Surrogate}/gu, '\ufffd');

/** What happened besides results, as readers of SARIF are told. */
interface Notification {
  readonly level: 'error' | 'warning';
  readonly message: { readonly text: string };
}

/** The levels of a large set that fail and are not listed. */
function unlisted(results: Results): readonly Notification[] {
  const text = unlistedInWords(results);
  return text === '' ? [] : [{ level: 'warning', message: { text } }];
}

function earlyEnd({ unchecked, interrupted }: Results): readonly Notification[] {
  if (!interrupted && unchecked.length === 0) return [];
  const why = interrupted ? 'a signal ended the check early' : 'the check ended early';
  const named = unchecked.slice(0, MOST_NAMED).map((file) => wellFormed(visibleLine(file)));
  const more = unchecked.length > MOST_NAMED ? ` and ${unchecked.length - MOST_NAMED} more` : '';
  const text = `${why}: ${plural(unchecked.length, 'level')} not checked: ${named.join(', ')}${more}`;
  return [{ level: 'error', message: { text } }];
}
