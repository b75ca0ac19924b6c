import type { MeasuredLevel } from '../../../difficulty/index.ts';
import type { Json } from '../../job.ts';

/** What is recorded of a measured level: all but its file, which a record has beside it. */
export const recordOf = ({ file: _, ...rest }: MeasuredLevel): Json => rest as unknown as Json;

export const levelOf = (file: string, result: Json): MeasuredLevel => ({ file, ...result }) as unknown as MeasuredLevel;
