import type { Command } from 'commander';

/** The result of a command. Commands do not write to stdout themselves, so that no partial report is ever written. */
export interface CommandResult {
  /** The whole report, for stdout. */
  readonly output?: string | Uint8Array;
  /** Messages for people besides the report, for stderr. */
  readonly messages?: string;
  /** 0: done, and every level is completable; 1: at least one level is not, or is invalid; 2: the command could not be done. */
  readonly exitCode: 0 | 1 | 2;
}

/** The interface of a module in commands/. */
export interface CommandModule {
  /** Declares arguments, options, help and the action, which passes its result to `finish`. */
  declare(command: Command, finish: (result: CommandResult) => void): void;
}
