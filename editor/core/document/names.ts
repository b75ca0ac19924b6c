import { objectName } from '../../../schema/index.ts';
import { marksOf } from './marks.ts';
import type { FoundObject } from './objects.ts';

/** With a capital letter at the beginning: `Black hole`. */
export const titled = (words: string): string => `${words.charAt(0).toUpperCase()}${words.slice(1)}`;

/** `Hot asteroid 3`; the number is the position in its list, from 1. */
export const nameOf = ({ kind, index, object }: FoundObject): string => titled(objectName(kind, index, object));

/** The name that the user has given it, else what `nameOf` says. */
export const ownNameOf = (found: FoundObject): string => marksOf(found).name ?? nameOf(found);
