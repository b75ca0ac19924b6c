import * as z from 'zod';
import {
  ACCURACY_NAMES,
  ADJUSTABLE_CODES,
  type AdjustableCode,
  type ConfiguredSeverity,
  LONGEST_RUN,
  MOST_WORK,
  REPORTER_NAMES,
  SEVERITIES,
  SHORTEST_RUN,
} from '../basics/index.ts';
import { rulesSchema } from '../level-schema.ts';

/** The severity of problems, by their codes; codes that are left out keep their own. */
export type SeverityMap = { readonly [code in AdjustableCode]?: ConfiguredSeverity };

/** A path longer than this is a mistake. */
const LONGEST_PATH = 1000;

const path = z.string().min(1).max(LONGEST_PATH);
const paths = z.array(path).min(1).max(1000);
const patterns = z.array(path).max(1000);
const reporter = z
  .string()
  .regex(new RegExp(`^(?:${REPORTER_NAMES.join('|')})(?:=.+)?$`, 's'))
  .max(LONGEST_PATH);

const severity = z
  .strictObject(
    Object.fromEntries(
      ADJUSTABLE_CODES.map((code) => [
        code,
        z.enum(SEVERITIES).optional().describe(`How severe ${code} is; gq explain ${code} says what it means.`),
      ]),
    ) as { [code in AdjustableCode]: z.ZodOptional<z.ZodEnum<{ error: 'error'; warning: 'warning'; off: 'off' }>> },
  )
  .describe('How severe problems are. A level that cannot be completed stays red whatever is set here.');

/** The zod schema of `gq.config.json`. Every key may be left out. */
export const configSchema = z
  .strictObject({
    $schema: z.string().optional().describe('Where the JSON Schema of this file is, for editors.'),
    levels: z
      .union([path, paths])
      .optional()
      .describe(
        'Level files, directories or patterns that commands work on when none are given, relative to this file; "levels" when left out.',
      ),
    ignore: z
      .union([path, patterns])
      .optional()
      .describe(
        'Patterns of files and directories that are left out when a directory or a pattern is searched, relative to this file, as in .gitignore.',
      ),
    accuracy: z.enum(ACCURACY_NAMES).optional().describe('How exactly to simulate: the default of --accuracy.'),
    maxTime: z
      .number()
      .min(SHORTEST_RUN)
      .max(LONGEST_RUN)
      .optional()
      .describe('Simulated time after which a run is a timeout, s: the default of --max-time.'),
    maxWork: z
      .int()
      .min(1)
      .max(MOST_WORK)
      .optional()
      .describe('The most work that one level may cost, in pieces of motion: the default of --max-work.'),
    requireSlack: z
      .int()
      .min(0)
      .max(60)
      .optional()
      .describe(
        'Ticks by which all presses and releases of a run may be off: the default of gq check --require-slack; 0 requires nothing.',
      ),
    severity: severity.optional(),
    maxWarnings: z
      .int()
      .min(0)
      .max(1_000_000)
      .optional()
      .describe('More warnings than this fail gq check: the default of --max-warnings.'),
    reporters: z
      .array(z.union([z.enum(REPORTER_NAMES), reporter]))
      .min(1)
      .max(20)
      .optional()
      .describe('Reports of gq check, each NAME for stdout or NAME=FILE, relative to this file: the default of --reporter.'),
    lock: path.optional().describe('The file with the agreed results, relative to this file: the default of gq check --lock.'),
    cache: z
      .union([z.boolean(), path])
      .optional()
      .describe('Whether gq check keeps its results for the next time, or the directory for them, relative to this file.'),
    rules: rulesSchema.optional(),
  })
  .describe('The configuration of gq. Keys that begin with x- are yours: they are not checked.');

/** The content of `gq.config.json`. */
export type ConfigFile = z.infer<typeof configSchema>;

const { shape } = configSchema;

/** The schema that the value of a key is checked against: of a choice of types, the one that it is meant to have. */
export function schemaOf(key: keyof typeof shape, value: unknown): z.core.$ZodType {
  const isList = Array.isArray(value);
  switch (key) {
    case 'levels':
      return isList ? paths : path;
    case 'ignore':
      return isList ? patterns : path;
    case 'reporters':
      return z.array(reporter).min(1).max(20);
    case 'cache':
      return typeof value === 'string' ? path : z.boolean();
    default:
      return shape[key];
  }
}
