import * as z from 'zod';
import { configSchema } from './config/index.ts';
import { levelSchema } from './level-schema.ts';
import { lockSchema } from './lock/index.ts';
import { packSchema } from './pack/index.ts';
import { REPORT_SCHEMAS, type ReportName } from './reports/index.ts';

/**
 * The JSON Schema (draft 2020-12) of a level file, for editors and other tools. Keys that begin with x- are allowed in every
 * object.
 *
 * @returns a new JSON object
 */
export const levelJsonSchema = (): object => withExtensions(levelSchema);

/**
 * The JSON Schema (draft 2020-12) of `gq.config.json`, for editors and other tools. Keys that begin with x- are allowed in every
 * object.
 *
 * @returns a new JSON object
 */
export const configJsonSchema = (): object => withExtensions(configSchema);

/**
 * The JSON Schema (draft 2020-12) of a pack file, for editors and other tools. Keys that begin with x- are allowed in every
 * object.
 *
 * @returns a new JSON object
 */
export const packJsonSchema = (): object => withExtensions(packSchema);

/**
 * The JSON Schema (draft 2020-12) of a lock file, for editors and other tools.
 *
 * @returns a new JSON object
 */
export const lockJsonSchema = (): object => z.toJSONSchema(lockSchema, { target: 'draft-2020-12' });

/**
 * The JSON Schema (draft 2020-12) of what a command prints with `--format json`. It allows keys that a later version of the
 * toolkit may add.
 *
 * @param name the name of the command
 * @returns a new JSON object
 */
export function reportJsonSchema(name: ReportName): object {
  const { $schema, ...rest } = z.toJSONSchema(REPORT_SCHEMAS[name] as z.ZodType, {
    target: 'draft-2020-12',
    override: ({ jsonSchema }) => {
      if (jsonSchema.additionalProperties === false) delete jsonSchema.additionalProperties;
    },
  });
  return { $schema, title: `What gq ${name} prints with --format json.`, ...rest };
}

const withExtensions = (schema: z.core.$ZodType): object =>
  z.toJSONSchema(schema, {
    target: 'draft-2020-12',
    override: ({ jsonSchema }) => {
      if (jsonSchema.type === 'object') jsonSchema.patternProperties = { '^x-': {} };
    },
  });

/**
 * The text of `level.schema.json`.
 *
 * @returns the JSON Schema, indented by two spaces
 */
export const formatLevelJsonSchema = (): string => text(levelJsonSchema());

/**
 * The text of `config.schema.json`.
 *
 * @returns the JSON Schema, indented by two spaces
 */
export const formatConfigJsonSchema = (): string => text(configJsonSchema());

/**
 * The text of `pack.schema.json`.
 *
 * @returns the JSON Schema, indented by two spaces
 */
export const formatPackJsonSchema = (): string => text(packJsonSchema());

/**
 * The text of `lock.schema.json`.
 *
 * @returns the JSON Schema, indented by two spaces
 */
export const formatLockJsonSchema = (): string => text(lockJsonSchema());

/**
 * The text of `reports/NAME.schema.json`.
 *
 * @param name the name of the command
 * @returns the JSON Schema, indented by two spaces
 */
export function formatReportJsonSchema(name: ReportName): string {
  return text(reportJsonSchema(name));
}

const text = (schema: object): string => `${JSON.stringify(schema, null, 2)}\n`;
