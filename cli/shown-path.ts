import process from 'node:process';

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
