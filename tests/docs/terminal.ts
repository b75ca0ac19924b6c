import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';
import { constants, runInThisContext } from 'node:vm';
import { gqInTerminal } from '../cli/gq.ts';
import { PROJECT } from './page.ts';

// Node's own import: the test runner's would transform every file again
const nativeImport = runInThisContext('(url) => import(url)', {
  importModuleDynamically: constants.USE_MAIN_CONTEXT_DEFAULT_LOADER,
});

/** Built modules, which are loaded as they are. */
const built = (path: string) => nativeImport(pathToFileURL(join(PROJECT, 'dist', path)).href);

/** Splits a command line at blanks, but not within quotes, and leaves out a comment. */
export function wordsOf(command: string): string[] {
  const words = command.match(/#.*$|"[^"]*"|'[^']*'|\S+/g) ?? [];
  return words.filter((word) => !word.startsWith('#')).map((word) => word.replace(/^(["'])(.*)\1$/, '$2'));
}

/** A reader's terminal in a folder of its own, with the shipped levels and the package in it. */
export interface Terminal {
  write(path: string, content: string): void;
  /** Runs one line as it stands in a page and returns what a terminal shows. */
  run(line: string): Promise<string>;
  close(): void;
}

export function openTerminal(): Terminal {
  const directory = mkdtempSync(join(tmpdir(), 'gq-docs-'));
  mkdirSync(join(directory, 'node_modules'));
  const link = (from: string, to: string) => symlinkSync(join(PROJECT, from), join(directory, to), 'junction');
  link('levels', 'levels');
  link('.', 'node_modules/gravity-quest-toolkit');
  link('node_modules/@types', 'node_modules/@types');
  let code = 0;

  async function perform(words: readonly string[]): Promise<string> {
    const [program, ...args] = words;
    if (program === 'npx' && args[0] === 'gq') {
      const ended = await gqInTerminal(args.slice(1), directory);
      code = ended.code ?? -1;
      return ended.shown;
    }
    if (program === 'node') {
      const ended = spawnSync(process.execPath, args, { cwd: directory, encoding: 'utf8' });
      code = ended.status ?? -1;
      return ended.stdout + ended.stderr;
    }
    if (program === 'cat') return readFileSync(join(directory, args[0]), 'utf8');
    if (program === 'mkdir') mkdirSync(join(directory, args[0]), { recursive: true });
    else if (program === 'echo' && args[0] === '$?') return `${code}\n`;
    else throw new Error(`pages show npx gq, node, cat, mkdir and echo $? alone, not: ${words.join(' ')}`);
    return '';
  }

  return {
    write(path, content) {
      mkdirSync(dirname(join(directory, path)), { recursive: true });
      writeFileSync(join(directory, path), content);
    },
    async run(line) {
      const [command, ...filters] = line.split(' | ');
      let output = (await perform(wordsOf(command))).trimEnd();
      for (const filter of filters) {
        const found = /^(head|tail) -n (\d+)$/.exec(filter.trim());
        if (found === null) throw new Error(`pages pipe into head -n N or tail -n N alone, not: ${filter}`);
        const lines = output.split('\n');
        const count = Number(found[2]);
        output = (found[1] === 'head' ? lines.slice(0, count) : lines.slice(-count)).join('\n');
      }
      return output.trimEnd();
    },
    close: () => rmSync(directory, { recursive: true, force: true }),
  };
}

/** Names and options of the commands, as the built command line declares them. */
export interface Commands {
  readonly names: ReadonlySet<string>;
  optionsOf(name: string): ReadonlySet<string>;
  readonly allOptions: ReadonlySet<string>;
  /** What is wrong with the arguments of a command, or null. Nothing is run. */
  problemOf(args: readonly string[]): string | null;
}

export async function readCommands(): Promise<Commands> {
  const { Command } = await import('commander');
  const { COMMANDS } = await built('cli/commands/index.js');
  const commands = new Map<string, InstanceType<typeof Command>>();
  for (const { name, load } of COMMANDS) {
    const command = new Command(name).exitOverride().configureOutput({ outputError: () => {} });
    (await load()).declare(command, () => {});
    commands.set(name, command);
  }
  const general = ['-h', '--help', '-V', '--version'];
  const flagsOf = (command: InstanceType<typeof Command>) =>
    command.options.flatMap(({ short, long }) => [short, long].filter((flag) => flag != null));
  const options = new Map([...commands].map(([name, command]) => [name, new Set([...flagsOf(command), ...general])]));
  return {
    names: new Set([...commands.keys(), 'help']),
    optionsOf: (name) => options.get(name) ?? new Set(general),
    allOptions: new Set([...options.values()].flatMap((flags) => [...flags])),
    problemOf([name, ...args]) {
      if (general.includes(name) || name === 'help' || args.includes('--help')) return null;
      const command = commands.get(name);
      if (command === undefined) return `there is no command ${name}`;
      try {
        const { unknown } = command.parseOptions(args);
        return unknown.length > 0 ? `gq ${name} has no ${unknown.join(' ')}` : null;
      } catch (error) {
        return error instanceof Error ? error.message : String(error);
      }
    },
  };
}
