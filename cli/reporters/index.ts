export * from './destinations.ts';
export { reportCheck } from './report-check.ts';
export { type Places, pathInWorkspace, placesOf, REPORTER_NAMES, type ReporterName } from './reporter.ts';
export { type Annotation, workflowCommands } from './workflow-command.ts';
