import * as z from 'zod';
import { levelSchema } from './level.ts';

/**
 * The JSON Schema (draft 2020-12) of a level file, for editors and other tools. Keys that begin with x- are allowed in every
 * object.
 *
 * @returns a new JSON object
 */
export function levelJsonSchema(): object {
  return z.toJSONSchema(levelSchema, {
    target: 'draft-2020-12',
    override: ({ jsonSchema }) => {
      if (jsonSchema.type === 'object') jsonSchema.patternProperties = { '^x-': {} };
    },
  });
}

/**
 * The text of `level.schema.json`.
 *
 * @returns the JSON Schema, indented by two spaces
 */
export function formatLevelJsonSchema(): string {
  return `${JSON.stringify(levelJsonSchema(), null, 2)}\n`;
}
