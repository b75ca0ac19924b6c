export { type AccuracyReport, accuracyJson } from '../commands/accuracy/report.ts';
export { accuracyPretty, brief } from '../commands/accuracy/table.ts';
