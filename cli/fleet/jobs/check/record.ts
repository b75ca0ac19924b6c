import type { CheckedLevel } from '../../../check/index.ts';
import type { Json } from '../../job.ts';

/** What is recorded of a checked level: all but its file and the time that it took, which a record has beside it. */
export const recordOf = ({ file: _, ms: __, ...rest }: CheckedLevel): Json => rest as unknown as Json;

export const levelOf = (file: string, ms: number, result: Json): CheckedLevel =>
  ({ file, ...result, ms }) as unknown as CheckedLevel;
