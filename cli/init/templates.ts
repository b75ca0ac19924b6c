import { readFileSync } from 'node:fs';

const ROOT = new URL('../../../', import.meta.url);

/** A ready-made file of the package, in its folder `templates`. */
export const readTemplate = (name: string): string => readFileSync(new URL(`templates/${name}`, ROOT), 'utf8');

/** A level of the package. */
export const readShippedLevel = (name: string): string => readFileSync(new URL(`levels/${name}`, ROOT), 'utf8');
