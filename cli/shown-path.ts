/** A path as it can be typed into a shell. */
export const shellPath = (file: string): string => (/^[\w./\\:-]+$/.test(file) ? file : JSON.stringify(file));

/** A path within a message, where an empty one would not be seen. */
export const namedPath = (file: string): string => (file === '' ? '""' : file);
