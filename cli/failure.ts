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
