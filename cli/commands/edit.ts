import process from 'node:process';
import type { Command } from 'commander';
import { placeFragment } from '../../schema/index.ts';
import { GAME } from '../build/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../config/index.ts';
import { wholeNumberOption } from '../options/index.ts';
import { DEFAULT_PORT, type EditServer, openBrowser, openedPlace, PAGE, startServer } from '../serve/index.ts';
import { catchSignals, visible } from '../terminal/index.ts';

interface EditOptions extends ConfigOptions {
  readonly port?: number;
  /** true: the browser is opened, but at no place */
  readonly open?: true | string;
  readonly run?: string;
}

export const help: CommandHelp = {
  description: 'Edit the levels of a folder in the browser. The run and its verdict follow every change at once.',
  more: `
Prints an address that works until the command ends (Ctrl-C). Anybody who has the address can change the levels in the folder;
nobody else can. As in other commands, levels are played under the rules of gq.config.json; the page follows changes to that file.
Changes are saved as they are made, each file completely or not at all. Deleted levels are kept in DIR/.gq-trash.

Exit code: 130 on Ctrl-C; 2 when it could not start: the folder does not exist, the port is taken, or gq.config.json is
not valid.

Examples:
  $ gq edit
  $ gq edit levels --open
  $ gq edit --open levels/07-slingshot.level.json:412   where the run is after 412 ticks
  $ gq edit my-levels --port 8080`,
};

export function declare(command: Command, _finish: (result: CommandResult) => void): void {
  addConfigOptions(command)
    .argument('[dir]', 'folder of level files (default: "levels", or the folder of the file to open)')
    .option(
      '--port <n>',
      `port on 127.0.0.1; 0 for any free port (default: the last one used for this folder, else ${DEFAULT_PORT} or the next free one)`,
      wholeNumberOption('a port', 0, 65535),
    )
    .option('--open [file[:tick]]', 'open the browser: at a level, and at a tick of its run')
    .option('--run <name>', 'with --open FILE: the run to show (default: the first)')
    .action(edit);
}

/** Runs until a signal ends it. */
async function edit(dir: string | undefined, options: EditOptions): Promise<void> {
  const print = (text: string): void => void process.stderr.write(visible(text));
  const onCrash = (error: unknown): void => {
    const stack = error instanceof Error ? error.stack : String(error);
    print(`gq edit continues, but this is a bug in gq; please report it:\n${stack}\n`);
  };
  // the server leaves the event loop free except for short moments, and finishes a file that it is writing
  catchSignals();
  const wanted = typeof options.open === 'string' ? options.open : undefined;
  const { folder, place } = openedPlace(dir, wanted, options.run);
  // an invalid configuration is an error at the start; later the page reports it
  await readConfiguration(options);
  const { port = null, config } = options;
  const server = await startServer({ folder, port, configFrom: process.cwd(), config, page: PAGE, game: GAME, onCrash });
  const fragment = place === null ? '' : placeFragment(place);
  const address = fragment === '' ? server.address : `${server.address}&${fragment}`;
  // unlike the reports of other commands, the address is needed before the command ends
  process.stdout.write(announcement(folder, { ...server, address }, options, fragment));
  if (options.open) {
    openBrowser(address, (why) => print(`the browser could not be opened (${why}): open the address above in a browser\n`));
  }
  await new Promise<never>(() => {});
}

function announcement(
  folder: string,
  { address, port, portBefore, keyProblem }: EditServer,
  options: EditOptions,
  fragment: string,
): string {
  const notes: string[] = [];
  const usual = portBefore ?? DEFAULT_PORT;
  const isOther = options.port === undefined && port !== usual;
  if (isOther) notes.push(`Port ${usual} is taken, perhaps by another gq edit; this one uses ${port}.`);
  if (isOther && fragment !== '')
    notes.push(`If that one edits the same folder, its page goes to the same place with #${fragment} at the end of its address.`);
  if (portBefore !== null && portBefore !== port && options.port !== 0) {
    const old = `http://127.0.0.1:${portBefore}/`;
    notes.push(
      `If a page could not save its changes last time, the browser keeps them under ${old}: gq edit --port ${portBefore} finds them.`,
    );
  }
  if (keyProblem !== null)
    notes.push(
      `The key of this folder can't be kept (${visible(keyProblem)}): after a restart, open the new address in each tab of the editor.`,
    );
  const note = notes.length === 0 ? '' : `${notes.join(' ')}\n`;
  return `${note}Editing ${visible(folder)} at\n  ${address}\nCtrl-C ends it.\n`;
}
