import process from 'node:process';
import type { Command } from 'commander';
import type { CommandResult } from '../command.ts';
import { DEFAULT_PORT, type EditServer, openBrowser, PAGE, startServer } from '../edit/index.ts';
import { folderRules } from '../folder-rules.ts';
import { wholeNumberOption } from '../options.ts';
import { catchSignals } from '../signals.ts';
import { visible } from '../visible.ts';

interface EditOptions {
  readonly port?: number;
  readonly open?: true;
}

export function declare(command: Command, _finish: (result: CommandResult) => void): void {
  command
    .description('Edit the levels of a folder in the browser. The run and its verdict follow every change at once.')
    .argument('[dir]', 'folder of level files', 'levels')
    .option(
      '--port <n>',
      `port on 127.0.0.1; 0 for any free port (default: the last one used for this folder, else ${DEFAULT_PORT} or the next free one)`,
      wholeNumberOption('a port', 0, 65535),
    )
    .option('--open', 'open the browser')
    .addHelpText(
      'after',
      `
Prints an address that works until the command ends (Ctrl-C). Anybody who has the address can change the levels in the folder;
nobody else can. As in other commands, levels are played under the rules of gq.config.json; the page follows changes to that file.
Changes are saved as they are made, each file completely or not at all. Deleted levels are kept in DIR/.gq-trash.

Exit code: 130 on Ctrl-C; 2 when it could not start: the folder does not exist, the port is taken, or gq.config.json is
not valid.

Examples:
  $ gq edit
  $ gq edit levels --open
  $ gq edit my-levels --port 8080`,
    )
    .action(edit);
}

/** Runs until a signal ends it. */
async function edit(folder: string, options: EditOptions): Promise<void> {
  const print = (text: string): void => void process.stderr.write(visible(text));
  const onCrash = (error: unknown): void => {
    const stack = error instanceof Error ? error.stack : String(error);
    print(`gq edit continues, but this is a bug in gq; please report it:\n${stack}\n`);
  };
  // the server leaves the event loop free except for short moments, and finishes a file that it is writing
  catchSignals();
  // an invalid configuration is an error at the start; later the page reports it
  folderRules();
  const server = await startServer({ folder, port: options.port ?? null, configFrom: process.cwd(), page: PAGE, onCrash });
  // unlike the reports of other commands, the address is needed before the command ends
  process.stdout.write(announcement(folder, server, options));
  if (options.open) {
    openBrowser(server.address, (why) =>
      print(`the browser could not be opened (${why}): open the address above in a browser\n`),
    );
  }
  await new Promise<never>(() => {});
}

function announcement(folder: string, { address, port, portBefore }: EditServer, options: EditOptions): string {
  const notes: string[] = [];
  const usual = portBefore ?? DEFAULT_PORT;
  const isOther = options.port === undefined && port !== usual;
  if (isOther) notes.push(`Port ${usual} is taken, perhaps by another gq edit; this one uses ${port}.`);
  if (portBefore !== null && portBefore !== port && options.port !== 0) {
    const old = `http://127.0.0.1:${portBefore}/`;
    notes.push(
      `If a page could not save its changes last time, the browser keeps them under ${old}: gq edit --port ${portBefore} finds them.`,
    );
  }
  const note = notes.length === 0 ? '' : `${notes.join(' ')}\n`;
  return `${note}Editing ${visible(folder)} at\n  ${address}\nCtrl-C ends it.\n`;
}
