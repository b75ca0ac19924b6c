export { type AccuracyReport, accuracyJson } from './report.ts';
export { accuracyPretty, brief } from './table.ts';
