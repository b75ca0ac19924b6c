import { realpathSync } from 'node:fs';
import { dirname } from 'node:path';
import {
  EDIT_ERRORS,
  type EditErrorCode,
  type ErrorResponse,
  type LevelEntry,
  type Problem,
  type ReadResponse,
  type RefusedLevel,
  readLevel,
} from '../../schema/index.ts';
import { systemReason } from '../terminal/index.ts';

interface Details {
  readonly problems?: Problem[];
  readonly current?: ReadResponse | null;
  readonly levels?: RefusedLevel[];
  readonly files?: ErrorResponse['error']['files'];
}

/** Thrown when a request is refused; nothing has changed on the disk. */
export class Refusal extends Error {
  override readonly name = 'Refusal';
  readonly code: EditErrorCode;
  readonly hint: string;
  readonly details: Details;

  constructor(code: EditErrorCode, message: string, hint: string, details: Details = {}) {
    super(message);
    this.code = code;
    this.hint = hint;
    this.details = details;
  }
}

export const statusOf = (refusal: Refusal): number => EDIT_ERRORS[refusal.code];

export const bodyOf = ({ code, message, hint, details }: Refusal): ErrorResponse => ({
  error: { code, message, hint, ...details },
});

const FULL = new Set(['ENOSPC', 'EDQUOT', 'EFBIG']);
const FORBIDDEN = new Set(['EACCES', 'EPERM', 'EROFS']);

/** A system error during a change as a refusal for the page. A `Refusal` is returned unchanged. */
export function refusalOf(error: unknown, file: string): Refusal {
  if (error instanceof Refusal) return error;
  const code = (error as NodeJS.ErrnoException | null)?.code ?? '';
  const message = `${file}: can't be written: ${systemReason(error)}`;
  if (FULL.has(code)) return new Refusal('disk-full', message, 'Make room on the disk, then save again; the file is unchanged.');
  if (FORBIDDEN.has(code)) {
    return new Refusal(
      'not-writable',
      message,
      'Allow writing to the file and to its folder, then save again; the file is unchanged.',
    );
  }
  if (code === 'ENOENT')
    return new Refusal('unknown-folder', message, 'If the folder was moved or removed, put it back, then save again.');
  return new Refusal('failed', message, 'The file is unchanged. Try again; if it fails again, look at the folder and the disk.');
}

/** Refuses a path whose folder is, or is reached through, a link: it may lead anywhere. */
export function refuseWayOut(path: string): void {
  const folder = dirname(path);
  try {
    if (realpathSync(folder) === folder) return;
  } catch (error) {
    throw refusalOf(error, path);
  }
  throw new Refusal(
    'unknown-folder',
    `${folder} is now reached through a link, which the editor doesn't follow`,
    'Start gq edit again.',
  );
}

/** Refuses a content that is not a valid level. */
export function refuseInvalid(content: Uint8Array): void {
  const read = readLevel(content);
  if (read.ok) return;
  const { problems } = read;
  const many = problems.length === 1 ? 'a problem' : `${problems.length} problems`;
  const message = `the text is not a valid level: it has ${many}`;
  throw new Refusal('invalid-level', message, 'Fix the problems, then save again; the file is unchanged.', { problems });
}

/** Refuses a file that is not writable. */
export function refuseReadOnly({ file, readOnly }: LevelEntry): void {
  if (readOnly === null) return;
  throw new Refusal('not-writable', `${file}: ${readOnly}`, 'Allow writing to it, or save under another name.');
}

export function badName(name: string): Refusal {
  const hint = 'Use at most 80 letters a-z, digits, spaces, _ and -, begin with a letter or digit, and leave out .level.json.';
  return new Refusal('bad-name', `${quoted(name)} is not a name that a level file can have on every system`, hint);
}

export const unknownLevel = (id: string, where: string): Refusal =>
  new Refusal(
    'unknown-level',
    `there is no level ${quoted(id)} ${where}`,
    'It may have been renamed or removed: load the list again.',
  );

export const unknownFolder = (folder: string, shown: string): Refusal =>
  new Refusal(
    'unknown-folder',
    `there is no folder ${quoted(folder)} in ${shown}`,
    'Create the folder first, or choose another one.',
  );

export const nameTaken = (file: string): Refusal => new Refusal('name-taken', `${file} already exists`, 'Choose another name.');

export const alreadyThere = (file: string, current: ReadResponse | null): Refusal =>
  current === null
    ? nameTaken(file)
    : new Refusal('conflict', `${file} already exists`, 'Choose another name, or open the existing level.', { current });

/** Quotes a text from a request and shortens it for a message. */
function quoted(text: string): string {
  return JSON.stringify(text.length > 80 ? `${text.slice(0, 80)}…` : text);
}
