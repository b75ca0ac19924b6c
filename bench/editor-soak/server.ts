import { type ChildProcess, spawn } from 'node:child_process';
import { watch } from 'node:fs';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

const MAIN = fileURLToPath(new URL('../../cli/main.js', import.meta.url));

/** Time after which no save comes any more, ms. */
const LONGEST_SAVE = 1000;

/** A `gq edit` that can be killed. */
export interface KillableServer {
  readonly address: string;
  readonly port: number;
  kill(): Promise<void>;
  /** Kills it as soon as a file of a folder is put in place, or after a while if none is. */
  killOnChange(folder: string, name: string): Promise<void>;
}

export interface ServerOptions {
  readonly folder: string;
  /** Port; 0 for any. */
  readonly port: number;
  /** Number of the user it runs as; undefined for the user who starts it. */
  readonly user: number | undefined;
  /**
   * Whether the disk has no room for more than one KiB. The kernel's limit for the size of files is used: it writes what fits
   * and refuses the rest.
   */
  readonly isFull: boolean;
}

export async function startServer({ folder, port, user, isFull }: ServerOptions): Promise<KillableServer> {
  const edit = [process.execPath, MAIN, 'edit', folder, '--port', String(port)];
  const [command, ...args] = isFull ? ['bash', '-c', 'ulimit -f 1 && exec "$@"', '--', ...edit] : edit;
  const child: ChildProcess = spawn(command, args, {
    stdio: ['ignore', 'pipe', 'ignore'],
    ...(user === undefined ? {} : { uid: user, gid: user }),
  });
  const ended = new Promise<number | null>((resolve) => child.on('exit', resolve));
  const address = await new Promise<string>((resolve, reject) => {
    let said = '';
    child.stdout?.on('data', (data: Buffer) => {
      said += data.toString();
      const found = /http:\S+#token=\S+/.exec(said);
      if (found !== null) resolve(found[0]);
    });
    void ended.then((code) => reject(new Error(`gq edit ended with ${code}`)));
  });
  const kill = async () => {
    child.kill('SIGKILL');
    await ended;
  };
  return {
    address,
    port: Number(new URL(address).port),
    kill,
    async killOnChange(folder, name) {
      const watcher = watch(folder, (_, changed) => {
        if (changed === name) child.kill('SIGKILL');
      });
      const timer = setTimeout(() => child.kill('SIGKILL'), LONGEST_SAVE);
      await ended;
      clearTimeout(timer);
      watcher.close();
    },
  };
}
