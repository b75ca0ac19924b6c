import {
  EDIT_ERRORS,
  type EditErrorCode,
  type ErrorResponse,
  type Problem,
  type ReadResponse,
  type RefusedLevel,
} from '../../schema/index.ts';
import { systemReason } from '../io/index.ts';

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
