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
  /^#+ .*\blevels?\b/,
];

/** The line of a summary in reports for people and for GitHub: `22 levels: 22 completable`. */
const SUMMARY = /^\d[\d,]* (?:levels?|plays?)(?:: \d[\d,]* \w+|$)/m;

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
    return SUMMARY.test(end) && !/^\s*[{[]/.test(begin) ? 'report' : 'other';
  } finally {
    closeSync(descriptor);
  }
}

function textAt(descriptor: number, position: number): string {
  const bytes = Buffer.alloc(NEAR);
  return bytes.toString('utf8', 0, readSync(descriptor, bytes, { position }));
}
