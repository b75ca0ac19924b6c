import { basename } from 'node:path';

/** The name of a level file without its ending. */
export const nameOfFile = (file: string): string => basename(file).replace(/(\.level)?\.json$/, '');
