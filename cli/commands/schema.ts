import { Argument, type Command } from 'commander';
import {
  formatConfigJsonSchema,
  formatLevelJsonSchema,
  formatLockJsonSchema,
  formatPackJsonSchema,
  formatReportJsonSchema,
  REPORT_SCHEMAS,
  type ReportName,
} from '../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { didYouMean, Failure } from '../terminal/index.ts';

interface PrintedSchema {
  readonly about: string;
  /** The text of the schema, with the line end. */
  readonly print: () => string;
}

const REPORTS = Object.keys(REPORT_SCHEMAS) as ReportName[];

/** The JSON Schemas that can be printed, by name. */
const SCHEMAS: Readonly<Record<string, PrintedSchema>> = {
  level: { about: 'a level file', print: formatLevelJsonSchema },
  config: { about: 'gq.config.json', print: formatConfigJsonSchema },
  pack: { about: 'pack.json, the order of the levels of a folder', print: formatPackJsonSchema },
  lock: { about: 'the file of gq check --lock', print: formatLockJsonSchema },
  ...Object.fromEntries(
    REPORTS.map((name) => [
      name,
      { about: `what gq ${name} prints with --format json`, print: () => formatReportJsonSchema(name) },
    ]),
  ),
};

const NAMES = Object.keys(SCHEMAS);

const WIDTH = Math.max(...NAMES.map((name) => name.length));
const LIST = Object.entries(SCHEMAS).map(([name, { about }]) => `  ${name.padEnd(WIDTH)}  ${about}`);

export const help: CommandHelp = {
  description: 'Print the JSON Schema of a level file, of another file, or of a report.',
  more: `
Names:
${LIST.join('\n')}

Text editors use it to complete and check level files and gq.config.json that name it in "$schema".

Examples:
  $ gq schema > level.schema.json
  $ gq schema config > config.schema.json
  $ gq schema check > check-report.schema.json`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .addArgument(new Argument('[name]', 'what to print the schema of').default('level'))
    .action((name: string) => finish({ output: schemaOf(name).print(), exitCode: 0 }));
}

function schemaOf(name: string): PrintedSchema {
  if (Object.hasOwn(SCHEMAS, name)) return SCHEMAS[name];
  throw new Failure(`there is no schema ${JSON.stringify(name)}${didYouMean(name, NAMES)}: expected ${NAMES.join(', ')}`);
}
