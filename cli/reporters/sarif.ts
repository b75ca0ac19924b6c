import { createHash } from 'node:crypto';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { plural } from '../../check/words/index.ts';
import type { CodeExplanation } from '../../schema/index.ts';
import { type CheckedLevel, keyOf } from '../check/index.ts';
import { EXPLAINED_CODES } from '../explained-codes.ts';
import { failureOf } from '../show-failure/index.ts';
import type { ShownProblem } from '../shown-problem.ts';
import { visible, visibleLine } from '../visible.ts';
import { pathInRepository, rootOf } from './paths.ts';
import type { ReportContext, Results } from './reporter.ts';

const SCHEMA = 'https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json';

/** The folder that paths are relative to, as readers of SARIF call the root of a repository. */
const ROOT = '%SRCROOT%';

/** The results of `check` as SARIF 2.1.0: a result for each problem, a rule for each code that occurs. */
export function checkSarif(results: Results, context: ReportContext): string {
  const { levels, packs = [] } = results;
  const codes = [...new Set([...levels, ...packs].flatMap(({ problems }) => problems.map(({ code }) => code)))].sort();
  const fingerprints = new Fingerprints();
  const { exitCode, places, version } = context;
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
        toolExecutionNotifications: earlyEnd(results),
      },
    ],
    originalUriBaseIds: { [ROOT]: { uri: folderUri(rootOf(places)) } },
    columnKind: 'utf16CodeUnits',
    results: [
      ...levels.flatMap((level) =>
        level.problems.map((problem) => resultOf(level, failureOf(level, context.linkTo), problem, codes, fingerprints, context)),
      ),
      ...packs.flatMap((pack) => pack.problems.map((problem) => resultOf(pack, null, problem, codes, fingerprints, context))),
    ],
  };
  return `${JSON.stringify({ $schema: SCHEMA, version: '2.1.0', runs: [run] }, null, 2)}\n`;
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
  codes: readonly string[],
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
    ruleIndex: codes.indexOf(code),
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

function earlyEnd({ unchecked, interrupted }: Results) {
  if (!interrupted && unchecked.length === 0) return [];
  const why = interrupted ? 'a signal ended the check early' : 'the check ended early';
  const files = unchecked.map((file) => wellFormed(visibleLine(file))).join(', ');
  return [{ level: 'error', message: { text: `${why}: ${plural(unchecked.length, 'level')} not checked: ${files}` } }];
}
