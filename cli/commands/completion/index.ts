import { Argument, type Command } from 'commander';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { REPORTER_NAMES } from '../../reporters/index.ts';
import { EXPLAINED_CODES } from '../explain.ts';
import { bashScript, fishScript, zshScript } from './shells.ts';
import { wordsOf } from './words.ts';

const SCRIPTS = { bash: bashScript, zsh: zshScript, fish: fishScript };

export const help: CommandHelp = {
  description: 'Print a script that completes commands, options, values, level files and names of runs in a shell.',
  more: `
The script needs no other program and does not start gq, so it completes at once. Print it again after an update of gq.

Examples:
  $ gq completion bash >> ~/.bashrc
  $ gq completion zsh > "\${fpath[1]}/_gq"
  $ gq completion fish > ~/.config/fish/completions/gq.fish`,
};

/** Declares the command; all other commands of the program must be declared before it runs. */
export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .addArgument(new Argument('<shell>', 'the shell').choices(Object.keys(SCRIPTS)))
    .action((shell: keyof typeof SCRIPTS) => {
      const words = wordsOf(command.parent!, { codes: EXPLAINED_CODES, reporters: REPORTER_NAMES });
      finish({ output: SCRIPTS[shell](words), exitCode: 0 });
    });
}
