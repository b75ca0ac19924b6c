import { watch } from 'node:fs';
import process from 'node:process';
import { ADDRESS, GQ, started } from '../harness/index.ts';

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
  const edit = [process.execPath, GQ, 'edit', folder, '--port', String(port)];
  const [command, ...args] = isFull ? ['bash', '-c', 'ulimit -f 1 && exec "$@"', '--', ...edit] : edit;
  const {
    child,
    found: address,
    ended,
  } = await started([command, ...args], ADDRESS, 'stdout', {
    stdio: ['ignore', 'pipe', 'ignore'],
    ...(user === undefined ? {} : { uid: user, gid: user }),
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
