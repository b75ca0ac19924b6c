export {
  chooseReports,
  type Destination,
  expectReportFiles,
  forceReportsOption,
  reporterOption,
  reportFormatOption,
} from './destinations.ts';
export { pathInWorkspace, placesOf, type Places, REPORTER_NAMES, type ReporterName } from './reporter.ts';
export { reportCheck } from './report-check.ts';
export { type Annotation, workflowCommands } from './workflow-command.ts';
