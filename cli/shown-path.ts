/** A path as it can be typed into a shell. */
export const shellPath = (file: string): string => (/^[\w./\\:-]+$/.test(file) ? file : JSON.stringify(file));
