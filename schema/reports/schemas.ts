import * as z from 'zod';
import {
  checkReportSchema,
  difficultyReportSchema,
  generateReportSchema,
  simulateReportSchema,
  solveReportSchema,
  solveSetReportSchema,
} from './check.ts';
import { diffReportSchema } from './diff.ts';
import {
  accuracyReportSchema,
  buildReportSchema,
  explainReportSchema,
  exportReportSchema,
  fixReportSchema,
  fmtReportSchema,
  importReportSchema,
  initReportSchema,
  inspectReportSchema,
  tuneReportSchema,
  verifyReportSchema,
} from './others.ts';

/** The zod schema of what each command prints with `--format json`, by the name of the command. */
export const REPORT_SCHEMAS = {
  check: checkReportSchema,
  simulate: simulateReportSchema,
  solve: z.union([solveReportSchema, solveSetReportSchema]),
  fix: fixReportSchema,
  difficulty: difficultyReportSchema,
  tune: tuneReportSchema,
  generate: generateReportSchema,
  accuracy: accuracyReportSchema,
  inspect: inspectReportSchema,
  explain: explainReportSchema,
  fmt: fmtReportSchema,
  import: importReportSchema,
  export: exportReportSchema,
  init: initReportSchema,
  build: buildReportSchema,
  diff: diffReportSchema,
  verify: verifyReportSchema,
} as const satisfies Readonly<Record<string, z.ZodType>>;

/** The name of a command that prints a report as JSON. */
export type ReportName = keyof typeof REPORT_SCHEMAS;

/**
 * The JSON Schema (draft 2020-12) of what a command prints with `--format json`. It allows keys that a later version of the
 * toolkit may add.
 *
 * @param name the name of the command
 * @returns a new JSON object
 */
export function reportJsonSchema(name: ReportName): object {
  const schema: z.ZodType = REPORT_SCHEMAS[name];
  const title = `What gq ${name} prints with --format json.`;
  const json = z.toJSONSchema(schema, {
    target: 'draft-2020-12',
    override: ({ jsonSchema }) => {
      if (jsonSchema.additionalProperties === false) delete jsonSchema.additionalProperties;
    },
  });
  const { $schema, ...rest } = json;
  return { $schema, title, ...rest };
}

/**
 * The text of `reports/NAME.schema.json`.
 *
 * @param name the name of the command
 * @returns the JSON Schema, indented by two spaces
 */
export function formatReportJsonSchema(name: ReportName): string {
  return `${JSON.stringify(reportJsonSchema(name), null, 2)}\n`;
}
