// The schemas of reports, as `--format json` writes them.
export { VERDICTS, type Verdict, runReportSchema, simulateReportSchema, type SimulateReport, type RunReport, softlockReportSchema, type SoftlockReport, checkReportSchema, type LevelReport, type CheckReport, robustnessReportSchema, type RobustnessReport, solveReportSchema, solveSetReportSchema, type SolveSetReport, type SolveReport, type SolutionReport, type RunFoundReport, difficultyReportSchema, type DifficultyReport, generateReportSchema, type GenerateReport } from './check.ts';
export { type DiffReport, diffReportSchema } from './diff.ts';
export { type FitReport, type ForecastReport, fitReportSchema, forecastReportSchema } from './forecast.ts';
export { inspectReportSchema, type InspectReport, accuracyReportSchema, type AccuracyReport, explainReportSchema, type ExplainReport, fmtReportSchema, type FmtReport, importReportSchema, type ImportReport, exportReportSchema, type ExportReport, initReportSchema, type InitReport, buildReportSchema, type BuildReport, type FixReport, fixReportSchema, type TuneReport, tuneReportSchema, type VerifyReport, verifyReportSchema } from './others.ts';
export { type TermsReport, termsReportSchema } from './parts.ts';
export { formatReportJsonSchema, REPORT_SCHEMAS, type ReportName, reportJsonSchema } from './schemas.ts';
