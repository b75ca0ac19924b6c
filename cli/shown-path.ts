/** A path quoted for a shell. */
export const shellPath = (file: string): string => (/^[\w./\\:-]+$/.test(file) ? file : JSON.stringify(file));

/** A path for a message, in which an empty path must be visible. */
export const namedPath = (file: string): string => (file === '' ? '""' : file);
