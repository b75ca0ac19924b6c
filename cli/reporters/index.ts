export {
  chooseReports,
  type Destination,
  expectReportFiles,
  forceReportsOption,
  reporterOption,
  reportFormatOption,
} from './destinations.ts';
export { pathInWorkspace } from './paths.ts';
export { placesOf } from './places.ts';
export { reportCheck } from './report-check.ts';
export { type Places, REPORTER_NAMES, type ReporterName } from './reporter.ts';
export { type Annotation, workflowCommands } from './workflow-command.ts';
