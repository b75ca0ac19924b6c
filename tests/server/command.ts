import { type ChildProcess, spawn } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { MAIN } from '../cli/gq.ts';

export interface RunningEdit {
  readonly child: ChildProcess;
  readonly port: number;
  readonly address: string;
  /** All output so far. */
  readonly said: () => { stdout: string; stderr: string };
  readonly ended: Promise<{ code: number | null; signal: NodeJS.Signals | null }>;
  /** Sends a signal and waits for the end. */
  end(signal: NodeJS.Signals): Promise<{ code: number | null; signal: NodeJS.Signals | null }>;
}

export interface GqEditOptions {
  readonly cwd: string;
  readonly env?: NodeJS.ProcessEnv;
  /** The largest size of a file, KiB. */
  readonly maxFileSize?: number;
  /** The id of the user it runs as; only root may choose. */
  readonly user?: number;
}

/** Starts the built `gq edit` and waits until it prints its address; rejects with its output if it ends before. */
export function gqEdit(args: readonly string[], { cwd, env, maxFileSize, user }: GqEditOptions): Promise<RunningEdit> {
  const [command, all] =
    maxFileSize === undefined
      ? [process.execPath, [MAIN, 'edit', ...args]]
      : ['bash', ['-c', `ulimit -f ${maxFileSize} && exec "$@"`, '--', process.execPath, MAIN, 'edit', ...args]];
  const child = spawn(command, all, {
    cwd,
    // servers remember their ports, which must not happen in the home of the user who runs the tests
    env: { XDG_STATE_HOME: join(tmpdir(), 'gq-test-state'), ...process.env, ...env },
    stdio: ['ignore', 'pipe', 'pipe'],
    ...(user === undefined ? {} : { uid: user, gid: user }),
  });
  const said = { stdout: '', stderr: '' };
  const ended = new Promise<{ code: number | null; signal: NodeJS.Signals | null }>((resolve) => {
    child.on('close', (code, signal) => resolve({ code, signal }));
  });
  const end = (signal: NodeJS.Signals): typeof ended => {
    child.kill(signal);
    return ended;
  };
  return new Promise((resolve, reject) => {
    child.on('error', reject);
    void ended.then(({ code }) =>
      reject(Object.assign(new Error(`gq edit ended with ${code}: ${said.stderr}`), { code, ...said })),
    );
    child.stderr.on('data', (data: Buffer) => {
      said.stderr += data.toString();
    });
    child.stdout.on('data', (data: Buffer) => {
      said.stdout += data.toString();
      const address = /http:\/\/127\.0\.0\.1:(\d+)\/#token=\S+/.exec(said.stdout);
      if (address !== null) resolve({ child, port: Number(address[1]), address: address[0], said: () => said, ended, end });
    });
  });
}
