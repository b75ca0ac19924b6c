import type { Command } from 'commander';

/** What a command leaves behind. It writes nothing itself, so that nothing partial is ever written. */
export interface CommandResult {
  /** For stdout: the report, whole. */
  readonly output?: string | Uint8Array;
  /** For stderr: what a person should know beside the report. */
  readonly messages?: string;
  /** 0 done, and every level is completable; 1 at least one level is not, or is invalid; 2 it could not be done. */
  readonly exitCode: 0 | 1 | 2;
}

/** The face of a file in commands/. */
export interface CommandModule {
  /** Declares arguments, options and help, and hands the result of the work to `finish`. */
  declare(command: Command, finish: (result: CommandResult) => void): void;
}
