export { chooseReports, expectReportFiles, reporterOption, reportFormatOption } from './destinations.ts';
export { reportCheck } from './report-check.ts';
export { REPORTER_NAMES } from './reporter.ts';
