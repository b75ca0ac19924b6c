import {
  accessSync,
  closeSync,
  constants,
  existsSync,
  fstatSync,
  lstatSync,
  readlinkSync,
  readSync,
  realpathSync,
  type Stats,
  statSync,
} from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';
import { entryName } from './packs/index.ts';
import { openRegularFile } from './regular-file.ts';

/** The files that a command reads, by what each of them is in words; null: there is none. */
export type Inputs = Readonly<Record<string, string | readonly string[] | null>>;

/**
 * The levels that a command reads, as {@link Inputs}. An entry of a pack stands for its pack.
 * @param done what is done with them, for messages
 */
export const levelsRead = (files: readonly string[], done: 'checked' | 'read'): Inputs => ({
  [`a level that is ${done}`]: files.map(fileOf),
});

function fileOf(level: string): string {
  const entry = existsSync(level) ? null : entryName(level);
  return entry === null ? level : entry.pack;
}

/**
 * Decides, for every command, which file its output may replace: none that it reads, by whatever name, and no level.
 */
export class Outputs {
  private readonly read: ReadonlyMap<string, string>;
  private names: ReadonlyMap<string, string> | null = null;

  constructor(private readonly inputs: Inputs) {
    this.read = this.inWords((path) => realTarget(path));
  }

  /** What output at a path would replace, in words; null if nothing that must stay. */
  wouldReplace(path: string): string | null {
    const stats = statsOf(path);
    // a device has nothing to lose
    if (stats !== undefined && !stats.isFile()) return null;
    return this.input(path, stats) ?? (stats !== undefined && standing(path) === 'level' ? 'a level' : null);
  }

  /** The same for output that is levels: only what the command reads must stay. */
  wouldReplaceInput(path: string): string | null {
    return this.input(path, statsOf(path));
  }

  private input(path: string, stats: Stats | undefined): string | null {
    return this.read.get(realTarget(path)) ?? (stats === undefined ? null : this.byOtherName(stats));
  }

  /** The input that is the same file by another name, a hard link. */
  private byOtherName(stats: Stats): string | null {
    if (stats.nlink < 2) return null;
    this.names ??= this.inWords((path) => {
      const input = statsOf(path);
      return input === undefined ? '' : idOf(input);
    });
    return this.names.get(idOf(stats)) ?? null;
  }

  private inWords(keyOf: (path: string) => string): Map<string, string> {
    const words = new Map<string, string>();
    for (const [what, paths] of Object.entries(this.inputs)) {
      for (const path of [paths ?? []].flat()) {
        try {
          words.set(keyOf(path), what);
        } catch {
          // what can't be reached can't be replaced
        }
      }
    }
    return words;
  }
}

/** undefined: there is nothing, and perhaps there can't be, since a part of the path is a file; writing says so. */
function statsOf(path: string): Stats | undefined {
  try {
    return statSync(path, { throwIfNoEntry: false });
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ENOTDIR') return undefined;
    throw error;
  }
}

const idOf = ({ dev, ino }: Stats): string => `${dev} ${ino}`;

/** What is at a path; a file that can't be read is none of ours. */
export function standing(path: string): Occupant {
  try {
    return whatStands(path);
  } catch {
    return 'other';
  }
}

/**
 * Checks before the work that output may be written to a path.
 * @param given the option and its value, for the message
 * @throws Failure if it would replace what must stay
 */
export function expectOutput(given: string, path: string, inputs: Inputs): void {
  let what: string | null;
  try {
    what = new Outputs(inputs).wouldReplace(path);
  } catch (error) {
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
  if (what !== null) throw new Failure(`nothing was done: ${given}: it would replace ${what}; give it another file`);
}

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
export type Occupant = 'nothing' | 'report' | 'level' | 'other';

/**
 * Recognizes a file by its content.
 * @throws NotAFile, and system errors
 */
export function whatStands(path: string): Occupant {
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

/** Why an existing file must not be written, for people; null if it may. A read-only file counts as such even for root. */
export function whyNotWritable(path: string): string | null {
  const entry = existsSync(path) ? null : entryName(path);
  if (entry !== null && existsSync(entry.pack)) return `it is in the pack ${namedPath(entry.pack)}: take it out first`;
  try {
    accessSync(path, constants.W_OK);
    const { mode } = statSync(path);
    return (mode & 0o222) === 0 ? `it is read-only (mode ${(mode & 0o777).toString(8).padStart(3, '0')})` : null;
  } catch (error) {
    return systemReason(error);
  }
}

/** Why no file can be written to a path, for people; null if one can. The folders above it may be missing. */
export function whyUnreachable(file: string): string | null {
  try {
    const stats = statSync(file, { throwIfNoEntry: false });
    if (stats?.isDirectory()) return 'it is a folder; expected a file';
    if (stats !== undefined) return whyNotWritable(file);
    if (/[/\\]$/.test(file)) return 'it names a folder; expected a file';
    for (let folder = dirname(resolve(file)); ; folder = dirname(folder)) {
      const above = statSync(folder, { throwIfNoEntry: false });
      if (above === undefined && lstatSync(folder, { throwIfNoEntry: false })?.isSymbolicLink())
        return `${folder} is a broken link`;
      if (above?.isDirectory() === false) return `${folder} is a file, not a folder`;
      if (above !== undefined) {
        const why = whyNotWritable(folder);
        return why === null ? null : `${folder}: ${why}`;
      }
      if (dirname(folder) === folder) return 'no such folder';
    }
  } catch (error) {
    return systemReason(error);
  }
}

/** Links that are followed at most, as many as Linux follows. */
const MOST_LINKS = 40;

/**
 * Where writing to a path leads: absolute, without symbolic links, whether or not it exists. The same text for paths that lead to the
 * same place.
 * @throws system errors, such as ELOOP
 */
export const realTarget = (path: string): string => follow(resolve(path), MOST_LINKS);

function follow(path: string, left: number): string {
  try {
    return realpathSync(path);
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    if ((code !== 'ENOENT' && code !== 'ENOTDIR') || left === 0) throw error;
  }
  const above = dirname(path);
  if (above === path) return path;
  const folder = follow(above, left);
  // the link is broken: a file that is written through it comes to where it leads
  return isLink(path) ? follow(resolve(folder, readlinkSync(path)), left - 1) : join(folder, basename(path));
}

function isLink(path: string): boolean {
  try {
    return lstatSync(path, { throwIfNoEntry: false })?.isSymbolicLink() === true;
  } catch (error) {
    // a part of the path is a file, so there is nothing
    if ((error as NodeJS.ErrnoException).code === 'ENOTDIR') return false;
    throw error;
  }
}
