import { statSync } from 'node:fs';
import { basename, dirname, join, resolve, sep } from 'node:path';
import process from 'node:process';
import type { CommandResult } from '../command.ts';
import { CONFIG_NAME, configFolders } from '../config/index.ts';
import { writeResultFiles } from '../io/index.ts';
import { catchSignals, Failure, systemReason, visible } from '../terminal/index.ts';

export { Memory } from './memory.ts';

/** ms without a change after which a round begins: editors write a file in several steps */
const QUIET = 80;
/** ms after which a round begins although changes go on */
const LONGEST_WAIT = 1000;

const CLEAR_SCREEN = '\u001b[2J\u001b[3J\u001b[H';

/** What is watched, and what is done in a round. */
interface Watching {
  readonly paths: readonly string[];
  /** Single files besides the paths whose changes matter. */
  readonly files: readonly string[];
  /** Does a round; null: it has nothing new to say. */
  readonly round: () => Promise<CommandResult | null>;
  /** Called before a round that is to begin from nothing. */
  readonly forget: () => void;
}

/**
 * Does a round at first and after changes, until a person ends it.
 * @returns the exit code of the last round, when it was ended by the key q
 * @throws Failure of the first round; those of later ones are only printed, since the next change may mend them
 */
export async function watchAndRepeat({ paths, files, round, forget }: Watching): Promise<CommandResult> {
  // from here on the event loop is free most of the time
  catchSignals();
  const changes = new Changes();
  const watcher = await startWatcher(watchedPaths(paths, files), changes);
  const keys = listenToKeys(changes, forget);
  let exitCode: CommandResult['exitCode'] = 0;
  try {
    for (let isFirst = true; ; isFirst = false) {
      exitCode = (await tryRound(round, isFirst)) ?? exitCode;
      // a signal has ended the check of this round, and with it the watch
      if (exitCode > 2) return { exitCode };
      await changes.next();
      if (changes.isOver) return { exitCode };
    }
  } finally {
    keys();
    await watcher();
  }
}

async function tryRound(round: Watching['round'], isFirst: boolean): Promise<CommandResult['exitCode'] | null> {
  try {
    const result = await round();
    return result === null ? null : await print(result);
  } catch (error) {
    if (isFirst || !(error instanceof Failure)) throw error;
    return print({ messages: `error: ${visible(error.message)}\n`, exitCode: 2 });
  }
}

async function print({ output = '', messages = '', files = [], exitCode }: CommandResult): Promise<CommandResult['exitCode']> {
  // what is appended, as the summary of a job on GitHub, is for one report and not for one a round
  const written = await writeResultFiles(files.filter(({ mode }) => mode === 'replace'));
  const isScreen = process.stdout.isTTY === true && process.env.TERM !== 'dumb';
  if (isScreen) process.stdout.write(CLEAR_SCREEN);
  // only a report of packs is in pieces, and packs are not watched
  if (typeof output === 'string' && output !== '') process.stdout.write(output);
  const all = [...written.messages.map((text) => `${text}\n`), messages].join('');
  const isOver = exitCode > 2;
  const prompt = isOver ? '' : `watching for changes${process.stdin.isTTY ? ': a checks all again, q ends' : ''}\n`;
  process.stderr.write(all + prompt);
  return written.failed ? 2 : exitCode;
}

/** Changes that wait for a round. */
class Changes {
  isOver = false;
  private isPending = false;
  private wake: () => void = () => {};
  private timer: NodeJS.Timeout | null = null;
  private since = 0;

  /** A change has come: a burst of them is one round. */
  add(): void {
    const now = performance.now();
    if (this.timer === null) this.since = now;
    else clearTimeout(this.timer);
    this.timer = setTimeout(() => this.begin(), Math.max(0, Math.min(QUIET, this.since + LONGEST_WAIT - now)));
  }

  /** Begins a round as soon as the current one has ended. */
  begin(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    this.isPending = true;
    this.wake();
  }

  end(): void {
    this.isOver = true;
    this.begin();
  }

  /** Waits for the next round. */
  async next(): Promise<void> {
    while (!this.isPending)
      await new Promise<void>((done) => {
        this.wake = done;
      });
    this.isPending = false;
  }
}

async function startWatcher({ roots, matters }: WatchedPaths, changes: Changes): Promise<() => Promise<void>> {
  const { watch } = await import('chokidar');
  const top = new Set(roots);
  const watcher = watch([...roots], { ignored: (path) => !top.has(resolve(path)) && !matters(path), ignoreInitial: true });
  watcher.on('all', (_, path) => {
    if (!top.has(resolve(path))) changes.add();
  });
  let isSaid = false;
  watcher.on('error', (error) => {
    if (!isSaid)
      process.stderr.write(`warning: changes may be missed, because a folder can't be watched: ${systemReason(error)}\n`);
    isSaid = true;
  });
  // a change after this is an event, so the first round misses nothing
  await new Promise<void>((done) => void watcher.once('ready', done));
  return () => watcher.close();
}

/** Listens to the keys q, a and Ctrl-C, on a terminal only. @returns a function that stops it */
function listenToKeys(changes: Changes, forget: () => void): () => void {
  const { stdin } = process;
  if (!stdin.isTTY) return () => {};
  const hear = (bytes: Buffer): void => {
    for (const key of bytes.toString()) {
      if (key === 'q') changes.end();
      else if (key === 'a') {
        forget();
        changes.begin();
      }
      // raw mode leaves these to the program
      else if (key === '\u0003') process.kill(process.pid, 'SIGINT');
    }
  };
  const restore = (): void => void stdin.setRawMode(false);
  stdin.setRawMode(true);
  process.on('exit', restore);
  stdin.on('data', hear);
  return () => {
    stdin.off('data', hear);
    restore();
    process.off('exit', restore);
    stdin.pause();
  };
}

/** What is watched: folders with all below them, and single files. */
interface WatchedPaths {
  /** The folders at which watching begins. They contain what is watched, so that it may vanish and come back. */
  readonly roots: readonly string[];
  /** Whether changes of a path, or below it, matter. */
  matters(path: string): boolean;
}

const isFolder = (path: string): boolean => statSync(path, { throwIfNoEntry: false })?.isDirectory() === true;

/** What of the paths of a check may change its reports. @param files single files besides, such as the lock */
export function watchedPaths(paths: readonly string[], files: readonly string[]): WatchedPaths {
  const folders: string[] = [];
  const single = [...files, ...configFolders('.').map((folder) => join(folder, CONFIG_NAME))].map((path) => resolve(path));
  for (const path of paths) {
    if (isFolder(path)) folders.push(resolve(path));
    else if (/[*?]/.test(path) && statSync(path, { throwIfNoEntry: false }) === undefined)
      folders.push(resolve(fixedFolder(path)));
    else single.push(resolve(path));
  }
  const wanted = [...folders, ...single];
  return {
    // the folder around each, as far as none contains another
    roots: withoutInner(wanted.map((path) => nearestFolder(dirname(path)))),
    matters(path) {
      const full = resolve(path);
      if (single.includes(full)) return true;
      // the way to what is wanted
      if (wanted.some((one) => full === one || one.startsWith(withSeparator(full)))) return true;
      return folders.some((folder) => full.startsWith(withSeparator(folder)) && !isHidden(full.slice(folder.length + 1)));
    },
  };
}

const withSeparator = (folder: string): string => (folder.endsWith(sep) ? folder : folder + sep);

const isHidden = (inner: string): boolean => inner.split(sep).some((name) => name.startsWith('.') || name === 'node_modules');

function fixedFolder(pattern: string): string {
  const fixed = pattern.slice(0, pattern.search(/[*?]/));
  return basename(fixed) === fixed && !/[\\/]$/.test(fixed) ? '.' : dirname(`${fixed}x`);
}

/** A folder that exists: this one, or the nearest around it. */
const nearestFolder = (folder: string): string =>
  isFolder(folder) || dirname(folder) === folder ? folder : nearestFolder(dirname(folder));

function withoutInner(folders: readonly string[]): string[] {
  const all = [...new Set(folders)];
  return all.filter((folder) => !all.some((other) => other !== folder && folder.startsWith(withSeparator(other))));
}
