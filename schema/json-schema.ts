import * as z from 'zod';
import { configSchema } from './config/index.ts';
import { levelSchema } from './level-schema.ts';

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

const text = (schema: object): string => `${JSON.stringify(schema, null, 2)}\n`;
