import * as z from 'zod';
import { PACK_LIMITS, PACK_VERSION, type PackFile } from './pack.ts';

/** Some visible characters on one line. */
const name = z
  .string()
  .max(PACK_LIMITS.name)
  .regex(/^(?=.*\S)[^\p{Cc}\p{Zl}\p{Zp}]*$/su);

const id = z
  .string()
  .min(1)
  .max(PACK_LIMITS.id)
  .describe('Path of a level below the folder, with slashes, without .level.json: "07-slingshot", "world-2/01-start".');

const levelEntrySchema = z
  .strictObject({
    level: id,
    introduces: z
      .array(z.string().min(1).max(PACK_LIMITS.id))
      .min(1)
      .max(PACK_LIMITS.introduces)
      .optional()
      .describe('The effects that players are meant to meet here for the first time, by the names that gq inspect gives.'),
  })
  .describe('A level, and what it is for.');

const chapterEntrySchema = z
  .strictObject({ chapter: name.describe('The heading of the levels that follow, up to the next chapter.') })
  .describe('The beginning of a chapter.');

/** The zod schema of a pack file. */
export const packSchema = z
  .strictObject({
    $schema: z.string().optional().describe('Where the JSON Schema of this file is, for editors.'),
    version: z.literal(PACK_VERSION).describe('The version of the format.'),
    name: name.describe('The name of the pack: the title of the page that gq build makes.'),
    levels: z
      .array(z.union([id, levelEntrySchema, chapterEntrySchema]))
      .max(PACK_LIMITS.entries)
      .describe('The levels in the order in which they are played, and the headings of chapters between them.'),
  })
  .describe(
    'The order of the levels of a folder. Keys that begin with x- are yours: they are kept and not checked.',
  ) satisfies z.ZodType<PackFile>;
