import { readFileSync } from 'node:fs';
import process from 'node:process';
import { closestName } from '../../schema/basics/index.ts';

/**
 * An error that the user can fix: the command ends with exit code 2 and this message, without a stack. The message says what
 * was expected, what was found, and what to do.
 */
export class Failure extends Error {
  override readonly name = 'Failure';
}

const REASONS: Record<string, string> = {
  EACCES: 'permission denied',
  EPERM: 'not permitted',
  ENOENT: 'no such file or directory',
  ENOTDIR: 'part of its path is a file, not a directory',
  EISDIR: 'is a directory',
  EEXIST: 'a file of that name is in the way',
  ELOOP: 'its symbolic links go round in circles',
  ENAMETOOLONG: 'its name is too long',
  ENOSPC: 'no space left on the device',
  EROFS: 'the file system is read-only',
  EMFILE: 'too many open files',
};

/** A system error in words. */
export function systemReason(error: unknown): string {
  const code = (error as NodeJS.ErrnoException | null)?.code;
  if (code !== undefined && REASONS[code] !== undefined) return REASONS[code];
  return error instanceof Error ? error.message : String(error);
}

/**
 * A path quoted for a shell. A name with characters that mean something between double quotes gets single quotes, so that no
 * file name can run a command when a person pastes the line. On Windows, cmd.exe knows only double quotes, which no name has.
 */
export function shellPath(file: string, platform: string = process.platform): string {
  // a name that looks like an option
  const path = file.startsWith('-') && file !== '-' ? `./${file}` : file;
  if (platform === 'win32') return /^[\w./\\:-]+$/.test(path) ? path : `"${path}"`;
  return /^[\w./:-]+$/.test(path) ? path : quoted(path);
}

/** Any text as one word of a POSIX shell, also one that is an option. */
export const shellWord = (text: string): string => (/^[\w./:=,%@+-]+$/.test(text) ? text : quoted(text));

const quoted = (text: string): string => (/["$`!\\]/.test(text) ? `'${text.replaceAll("'", "'\\''")}'` : `"${text}"`);

/** A path for a message, in which an empty path must be visible. */
export const namedPath = (file: string): string => (file === '' ? '""' : file);

const asEscape = (character: string): string => `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`;

/**
 * Makes text from a file or the command line safe to print. Control characters, which could move the cursor or colour the
 * terminal, become \u escapes; so do characters that change the writing direction. Newlines and tabs stay.
 */
export function visible(text: string): string {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: control characters are what this looks for
  return text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, asEscape);
}

/** The same, on one line. */
export function visibleLine(text: string): string {
  return visible(text).replace(/[\n\t]/g, asEscape);
}

let waiting = '';

/** Adds a line for stderr, which is written with the messages of the command once it is done. */
export function notice(line: string): void {
  waiting += line;
}

/** The lines since the last call. */
export function takeNotices(): string {
  const lines = waiting;
  waiting = '';
  return lines;
}

/** ` (did you mean X?)`, or an empty text if no candidate is close. */
export function didYouMean(word: string, candidates: readonly string[]): string {
  const best = closestName(word, candidates);
  return best === null ? '' : ` (did you mean ${best}?)`;
}

/** The version of the package. */
export function readVersion(): string {
  return JSON.parse(readFileSync(new URL('../../../package.json', import.meta.url), 'utf8')).version;
}
