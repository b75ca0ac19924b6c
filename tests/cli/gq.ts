import { type ChildProcess, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

/** The command line as it is shipped; `npm test` builds it first. */
export const MAIN = fileURLToPath(new URL('../../dist/cli/main.js', import.meta.url));

export interface Ended {
  readonly code: number | null;
  readonly signal: NodeJS.Signals | null;
  readonly stdout: string;
  readonly stderr: string;
}

export interface SpawnOptions {
  readonly cwd?: string;
  readonly env?: NodeJS.ProcessEnv;
  /** Called with the running process. */
  readonly during?: (child: ChildProcess) => void;
}

/** ms: only what hangs takes so long, however busy the machine */
const TOO_LONG = 120_000;

/** Runs gq to its end; one that hangs is killed, and ends with a signal. */
export function gq(args: readonly string[], { cwd, env, during }: SpawnOptions = {}): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const { FORCE_COLOR: _, ...quiet } = process.env;
    const child = spawn(process.execPath, [MAIN, ...args], { cwd, env: { ...quiet, NO_COLOR: '1', ...env } });
    const stdout: Buffer[] = [];
    const stderr: Buffer[] = [];
    child.stdout.on('data', (data: Buffer) => stdout.push(data));
    child.stderr.on('data', (data: Buffer) => stderr.push(data));
    const killer = setTimeout(() => child.kill('SIGKILL'), TOO_LONG);
    child.on('error', reject);
    child.on('close', (code, signal) => {
      clearTimeout(killer);
      resolve({ code, signal, stdout: Buffer.concat(stdout).toString(), stderr: Buffer.concat(stderr).toString() });
    });
    during?.(child);
  });
}

/** A directory of its own for a test, and what it holds: file names and contents. */
export function makeFiles(files: Readonly<Record<string, string | Uint8Array>>): { directory: string; remove: () => void } {
  const directory = mkdtempSync(join(tmpdir(), 'gq-'));
  for (const [name, content] of Object.entries(files)) {
    mkdirSync(dirname(join(directory, name)), { recursive: true });
    writeFileSync(join(directory, name), content);
  }
  return { directory, remove: () => rmSync(directory, { recursive: true, force: true }) };
}

/** Falls from rest straight through a cold asteroid into the black hole behind it while the gun is held. */
export function fallThrough(changes: Readonly<Record<string, unknown>> = {}): string {
  return JSON.stringify({
    version: 1,
    name: 'Straight through',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 170, y: 0 },
    asteroids: [{ x: 100, y: 0, radius: 16 }],
    runs: [{ name: 'hold', holds: [[0, 600]] }],
    ...changes,
  });
}
