import type { Command, Option } from 'commander';

/** What an option or an argument takes. */
export type Taken =
  | { readonly what: 'values'; readonly values: readonly string[] }
  | { readonly what: 'levels' | 'files' | 'folders' | 'runs' | 'anything' };

/** An option, for completion. */
export interface OptionWords {
  /** As it is written: `-f`, `--format`. */
  readonly flags: readonly string[];
  readonly about: string;
  /** null: it takes no value. */
  readonly takes: Taken | null;
  /** Whether its value may be left out: then only `--option=VALUE` gives one for sure. */
  readonly isOptional: boolean;
}

/** A command, for completion. */
export interface CommandWords {
  readonly name: string;
  readonly about: string;
  readonly options: readonly OptionWords[];
  /** null: it has no arguments. */
  readonly argument: Taken | null;
}

/** Values that no declaration has. */
export interface ExtraValues {
  /** The codes that `gq explain` knows. */
  readonly codes: readonly string[];
  /** The names of reporters. */
  readonly reporters: readonly string[];
}

/** What can be completed, from the declared commands of a program. */
export function wordsOf(program: Command, extra: ExtraValues): CommandWords[] {
  const commands = program.commands.map((command) => commandWords(command, extra));
  const names = commands.map(({ name }) => name);
  return [
    ...commands,
    { name: 'help', about: 'show help for a command', options: [], argument: { what: 'values', values: names } },
  ];
}

function commandWords(command: Command, extra: ExtraValues): CommandWords {
  const help: OptionWords = { flags: ['-h', '--help'], about: 'show help', takes: null, isOptional: false };
  const [argument] = command.registeredArguments;
  const options = command.options.filter(({ hidden }) => !hidden).map((option) => optionWords(option, extra));
  return {
    name: command.name(),
    about: command.summary(),
    options: [...options, help],
    argument: argument === undefined ? null : taken(argument.name(), argument.argChoices, extra),
  };
}

function optionWords(option: Option, extra: ExtraValues): OptionWords {
  const flags = [option.short, option.long].filter((flag) => flag !== undefined && flag !== null);
  const value = /[<[](.+)[>\]]$/.exec(option.flags)?.[1];
  return {
    flags,
    about: option.description,
    takes: value === undefined ? null : taken(value, option.argChoices, extra),
    // commander takes the brackets in <name[=file]> for this, too
    isOptional: option.optional && !option.required,
  };
}

/** What a value is, from its name in the declaration. */
function taken(name: string, choices: readonly string[] | undefined, { codes, reporters }: ExtraValues): Taken {
  if (choices !== undefined) return { what: 'values', values: choices };
  const word = name.replace(/\.\.\.$/, '');
  // `any|all|n`: n is a number
  if (/^\w+(\|\w+)+$/.test(word)) return { what: 'values', values: word.split('|').filter((value) => value.length > 1) };
  switch (word) {
    case 'code':
      return { what: 'values', values: codes };
    case 'name[=file]':
      return { what: 'values', values: reporters };
    case 'name':
      return { what: 'runs' };
    case 'path':
    case 'level':
      return { what: 'levels' };
    case 'dir':
      return { what: 'folders' };
    case 'file':
    case 'file[:tick]':
    case 'words':
      return { what: 'files' };
    default:
      return { what: 'anything' };
  }
}
