import { closeSync, fstatSync, readSync } from 'node:fs';
import { openRegularFile } from './regular-file.ts';

/** Bytes at the begin and the end of a file that are looked at. */
const NEAR = 64 * 1024;

/** What reports begin with. A list of a pack and a lock begin otherwise. */
const BEGINS = [
  // JSON
  /^\s*\{\s*"version":\s*1,\s*"(?:levels|plays)":\s*\[\s*(?:\{\s*"(?:version|file|plays?)"|\])/,
  // lines of JSON, one a play
  /^\s*\{\s*"version":\s*1,\s*"file":.*"(?:verdict|play)":/,
  // JUnit
  /^<\?xml [^>]*>\s*<testsuites name="gq /,
  // SARIF
  /^\s*\{\s*"\$schema":[^{}]*sarif[^{}]*"runs":\s*\[\s*\{\s*"tool":\s*\{\s*"driver":\s*\{\s*"name":\s*"gq"/,
  // Markdown
  /^### [✅❌] .+\n\n(?:0 levels\n|\d[\d,]* levels?: \d)/u,
];

/** Every verdict on levels and plays, written out: most commands that ask here need neither schema nor game. */
export const SUMMED_UP =
  'completable broken unproven impossible invalid crashed ok claim-differs stale-level other-accuracy unknown-engine malformed too-long';

/** The line with which reports for people and for GitHub end: `22 levels, at arcade: 21 completable, 1 broken`. */
const SUMMARY = new RegExp(
  `^(?:0 levels|\\d[\\d,]* (?:levels?|plays?)(?:, [^:]+)?: \\d[\\d,]* (?:${SUMMED_UP.replaceAll(' ', '|')})\\b.*)$`,
);

/** Lines that may follow it: what was not checked, what is not listed. */
const LINES_AFTER = 20;

/** What files are that no report may replace. */
const LEVEL = [/"astronaut"\s*:\s*\{/, /"blackHole"\s*:\s*\{/];

/** What is at a path where a report is to be written. */
export type Standing = 'nothing' | 'report' | 'level' | 'other';

/**
 * Recognizes a file by its content.
 * @throws NotAFile, and system errors
 */
export function whatStands(path: string): Standing {
  const descriptor = openRegularFile(path);
  try {
    const { size } = fstatSync(descriptor);
    const begin = textAt(descriptor, 0);
    if (begin.trim() === '' && size <= NEAR) return 'nothing';
    const end = size <= NEAR ? begin : textAt(descriptor, size - NEAR);
    if (BEGINS.some((form) => form.test(begin))) return 'report';
    if (/\.level\.json$/i.test(path) || (/^\s*\{/.test(begin) && LEVEL.every((key) => key.test(begin)))) return 'level';
    return endsInSummary(end) && !/^\s*[{[]/.test(begin) ? 'report' : 'other';
  } finally {
    closeSync(descriptor);
  }
}

const endsInSummary = (text: string): boolean =>
  text
    .trimEnd()
    .split('\n')
    .slice(-LINES_AFTER)
    .some((line) => SUMMARY.test(line));

function textAt(descriptor: number, position: number): string {
  const bytes = Buffer.alloc(NEAR);
  return bytes.toString('utf8', 0, readSync(descriptor, bytes, { position }));
}
