import * as z from 'zod';
import { LONGEST_RUN, MOST_WORK, SHORTEST_RUN, VERDICTS } from '../basics/index.ts';
import { block, inline } from '../json/index.ts';
import { rulesSchema } from '../level-schema.ts';

/** The version of the lock file that this toolkit reads and writes. */
export const LOCK_VERSION = 1;

/** The usual name of a lock file. */
export const LOCK_NAME = 'gq.lock.json';

const count = z.int().min(0);

/** The zod schema of what was agreed on for one level. */
export const lockEntrySchema = z
  .strictObject({
    verdict: z.enum(VERDICTS).describe('The verdict on the level.'),
    accuracy: z.string().min(1).max(100).describe('The accuracy at which it was checked.'),
    maxTime: z
      .number()
      .min(SHORTEST_RUN)
      .max(LONGEST_RUN)
      .optional()
      .describe('The longest that a run could last, s; 60 when left out.'),
    maxWork: z
      .int()
      .min(1)
      .max(MOST_WORK)
      .optional()
      .describe('The most work that it could cost, pieces of motion; that of gq check without --max-work when left out.'),
    outcome: z.enum(['completed', 'collided', 'lost', 'timeout']).optional().describe('How the shown run ends.'),
    tick: count.optional().describe('The tick of 1/60 s in which it ends.'),
    minerals: count.optional().describe('How many minerals it collects.'),
    mineralCount: count.optional().describe('How many minerals the level has.'),
    certifiedTicks: count
      .optional()
      .describe('By how many ticks all its presses and releases may move; left out if it does not complete the level.'),
    rules: rulesSchema.optional().describe('The rules that have another value than in the original game.'),
    hash: z.string().min(1).max(100).optional().describe('The hash of the run: covers its motion bit for bit.'),
  })
  .describe('What was agreed on for a level.');

/** The zod schema of a lock file. */
export const lockSchema = z.strictObject({
  $schema: z.string().optional().describe('Where the JSON Schema of this file is.'),
  version: z.literal(LOCK_VERSION).describe('The version of the format.'),
  levels: z.record(z.string(), lockEntrySchema).describe('By path of the level file, from the folder of the lock, with /.'),
});

/** What was agreed on for one level. */
export type LockEntry = z.infer<typeof lockEntrySchema>;

/** A lock file: the results that were agreed on. */
export type Lock = z.infer<typeof lockSchema>;

const KEYS_IN_ORDER = Object.keys(lockEntrySchema.shape) as readonly (keyof LockEntry)[];

/** What was agreed on for a level, on one line. */
const formatEntry = (entry: LockEntry): string => inline(Object.fromEntries(KEYS_IN_ORDER.map((key) => [key, entry[key]])));

/**
 * The canonical text of a lock file: a line for each level, sorted by path, so that versions merge line by line.
 *
 * @param lock - the lock
 * @returns its text
 */
export function formatLock({ $schema, levels }: Lock): string {
  const paths = Object.keys(levels).sort((a, b) => (a < b ? -1 : a > b ? 1 : 0));
  const entries = paths.map((path) => `${JSON.stringify(path)}: ${formatEntry(levels[path])}`);
  const rows = [
    ...($schema === undefined ? [] : [`"$schema": ${JSON.stringify($schema)}`]),
    `"version": ${LOCK_VERSION}`,
    `"levels": ${block('{', entries, '}', '  ')}`,
  ];
  return `${block('{', rows, '}', '')}\n`;
}
