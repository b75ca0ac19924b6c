import type { Command } from 'commander';

/** The result of a command. Commands do not write reports themselves, so that no partial report is ever written. */
export interface CommandResult {
  /** The whole report, for stdout; in pieces if it may be too large for memory. */
  readonly output?: string | Uint8Array | Iterable<string>;
  /** Reports for files. All of them are written before anything is printed. */
  readonly files?: readonly ResultFile[];
  /** Messages for people besides the report, for stderr. */
  readonly messages?: string;
  /**
   * 0: done, and every level is completable; 1: at least one level is not, or is invalid; 2: the command could not be done;
   * 3: results contradict each other; 129: git takes it for the failure of a merge driver; 130 and 143: a signal came, and what was done until then is reported.
   */
  readonly exitCode: 0 | 1 | 2 | 3 | 129 | 130 | 143;
  /** Removes what the pieces of the output are made of. Called once everything is written, or when a signal ends the process. */
  readonly end?: () => void;
}

/** A file that belongs to the result of a command. */
export interface ResultFile {
  readonly path: string;
  readonly content: string | Uint8Array | Iterable<string>;
  /**
   * `replace`: the file becomes this, and missing folders are made; a failure ends the command with 2.
   * `append`: the content is added to an existing file; a failure is only a message, since nothing else depends on it.
   */
  readonly mode: 'replace' | 'append';
}

/** The words around a command's arguments and options in its help. */
export interface CommandHelp {
  readonly description: string;
  /** What follows the options: what is meant, exit codes, examples. */
  readonly more: string;
}

/** The interface of a module in commands/. */
export interface CommandModule {
  readonly help: CommandHelp;
  /** Declares arguments, options and the action, which passes its result to `finish`. */
  declare(command: Command, finish: (result: CommandResult) => void): void;
}
