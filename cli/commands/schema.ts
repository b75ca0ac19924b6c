import type { Command } from 'commander';
import { formatLevelJsonSchema } from '../../schema/index.ts';
import type { CommandResult } from '../command.ts';

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .description('Print the JSON Schema of a level file.')
    .addHelpText(
      'after',
      `
Text editors use it to complete and check level files that name it in "$schema".

Examples:
  $ gq schema > level.schema.json`,
    )
    .action(() => finish({ output: formatLevelJsonSchema(), exitCode: 0 }));
}
