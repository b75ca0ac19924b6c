// The schemas of reports, as `--format json` writes them.
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
  cheapestReportSchema,
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

export * from './check.ts';
export { type DiffReport, diffReportSchema } from './diff.ts';
export * from './others.ts';
export { type TermsReport, termsReportSchema } from './parts.ts';
export { type FitReport, type ForecastReport, fitReportSchema, forecastReportSchema } from './players.ts';

/** The zod schema of what each command prints with `--format json`, by the name of the command. */
export const REPORT_SCHEMAS = {
  check: checkReportSchema,
  simulate: simulateReportSchema,
  solve: z.union([solveReportSchema, solveSetReportSchema]),
  fix: fixReportSchema,
  difficulty: difficultyReportSchema,
  tune: tuneReportSchema,
  generate: generateReportSchema,
  accuracy: z.union([accuracyReportSchema, cheapestReportSchema]),
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
