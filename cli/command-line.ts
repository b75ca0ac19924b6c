import process from 'node:process';
import { Command, CommanderError } from 'commander';
import type { CommandResult, ResultFile } from './command.ts';
import { COMMANDS } from './commands/index.ts';
import { beginSignals, Failure, leaveSignals, printAll, readVersion, takeNotices, visible } from './terminal/index.ts';

/**
 * Runs one command: parse, work, report.
 * @param args the arguments after `gq`
 * @returns the exit code
 */
export async function runCommandLine(args: readonly string[]): Promise<number> {
  beginSignals();
  const streams = watchStreams();
  try {
    const result = await perform(args);
    const { messages, failed } = await writeFiles(result.files ?? []);
    // from here on a signal ends the process even while a write waits for its reader
    if (result.end === undefined) await leaveSignals();
    const said = takeNotices() + (result.messages ?? '');
    if (said !== '') process.stderr.write(said);
    for (const message of messages) process.stderr.write(`${visible(message)}\n`);
    await writeOutput(result);
    return (failed || streams.isLost()) && result.exitCode < 2 ? 2 : result.exitCode;
  } catch (error) {
    await leaveSignals();
    return reportError(error);
  }
}

async function writeFiles(files: readonly ResultFile[]): Promise<{ messages: string[]; failed: boolean }> {
  if (files.length === 0) return { messages: [], failed: false };
  // help and most reports do without what reads and writes files
  const { writeResultFiles } = await import('./io/index.ts');
  return writeResultFiles(files);
}

async function writeOutput({ output, end }: CommandResult): Promise<void> {
  try {
    if (output === undefined) return;
    if (typeof output === 'string' || output instanceof Uint8Array) {
      if (output.length > 0) process.stdout.write(output);
      return;
    }
    await printAll(output);
  } finally {
    end?.();
  }
}

async function perform(args: readonly string[]): Promise<CommandResult> {
  let result: CommandResult = { exitCode: 0 };
  const asked = args[0] === 'help' ? args[1] : args[0];
  const program = createProgram();
  for (const { name, summary, load } of COMMANDS) {
    const command = program.command(name).summary(summary).description(summary);
    // completion tells of all commands
    if (name !== asked && asked !== 'completion') continue;
    const { help, declare } = await load();
    command.description(help.description).addHelpText('after', help.more);
    declare(command, (r) => {
      result = r;
    });
  }
  await program.parseAsync(args, { from: 'user' });
  return result;
}

function createProgram(): Command {
  const program = new Command('gq');
  program
    .description(
      'Level-design toolkit for Gravity Quest: make levels, check that they can be completed, and measure how hard they are.',
    )
    .version(readVersion(), '-V, --version', 'print the version')
    .helpOption('-h, --help', 'show help')
    .helpCommand('help [command]', 'show help for a command')
    .exitOverride()
    .showHelpAfterError('(gq --help lists the commands; gq COMMAND --help lists the options of a command)')
    .configureOutput({ outputError: (text, write) => write(visible(text)) })
    .addHelpText(
      'after',
      `
Examples:
  $ gq check                          every level under levels/
  $ gq check levels --format github   the same, as annotations of a pull request
  $ gq simulate levels/01-first-pull.level.json  play its first run
  $ gq explain unknown-key            what a problem means

Exit codes: 0 every level is completable, or the command did what was asked; 1 a level is not completable or is invalid;
2 the command failed: bad option, nothing matched, unreadable file; 130 and 143 on SIGINT and SIGTERM.`,
    );
  return program;
}

function reportError(error: unknown): number {
  // commander has already written its message or the help
  if (error instanceof CommanderError) return error.exitCode === 0 ? 0 : 2;
  process.stderr.write(describeError(error));
  return 2;
}

function describeError(error: unknown): string {
  if (error instanceof Failure) return `error: ${visible(error.message)}\n`;
  const stack = error instanceof Error ? (error.stack ?? error.message) : String(error);
  return `gq crashed. This is a bug in gq: please report it, with the level and the command line.\n${visible(stack)}\n`;
}

/** Hears of what can't be written. @returns whether a part of the output is lost so far; later, the exit code changes by itself */
function watchStreams(): { readonly isLost: () => boolean } {
  let isLost = false;
  process.stdout.on('error', (error: NodeJS.ErrnoException) => {
    // the reader has closed the pipe (`gq check | head -1`), which is no error
    if (error.code === 'EPIPE') return;
    process.stderr.write(`error: can't write to standard output: ${error.message}\n`);
    isLost = true;
    process.exitCode = 2;
  });
  // errors of stderr can't be reported anywhere
  process.stderr.on('error', () => {});
  process.on('uncaughtException', (error) => {
    process.stderr.write(describeError(error));
    process.exit(2);
  });
  return { isLost: () => isLost };
}
