import { type ChildProcess, type SpawnOptions, spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

/** The folder of the project, from a source and from what is compiled into dist/. */
export const PROJECT = projectFolder();
export const GQ = join(PROJECT, 'dist/gq/main.js');

function projectFolder(): string {
  let folder = dirname(fileURLToPath(import.meta.url));
  while (!existsSync(join(folder, 'package.json'))) folder = dirname(folder);
  return folder;
}

/** Does work in a new folder, and removes it. */
export async function inFolder<T>(name: string, work: (folder: string) => T | Promise<T>): Promise<T> {
  const folder = mkdtempSync(join(tmpdir(), `gq-bench-${name}-`));
  try {
    return await work(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** What a process said, and what it used. */
export interface Ended {
  readonly stdout: string;
  readonly stderr: string;
  /** null: killed */
  readonly status: number | null;
  /** s of wall time and of processor time of all threads */
  readonly seconds: number;
  readonly processor: number;
  /** most memory, MB */
  readonly memory: number;
}

/**
 * Runs the built `gq` in a folder, and measures what it uses.
 * @param limit ms after which it is killed; never when left out
 */
export function tryGq(folder: string, args: readonly string[], limit?: number): Ended {
  const usage = join(folder, 'usage.json');
  rmSync(usage, { force: true });
  const start = performance.now();
  const { status, stdout, stderr } = spawnSync(process.execPath, ['--import', join(PROJECT, 'bench/usage.mjs'), GQ, ...args], {
    cwd: folder,
    encoding: 'utf8',
    env: { ...process.env, GQ_USAGE: usage },
    maxBuffer: 2 ** 30,
    timeout: limit,
    killSignal: 'SIGKILL',
  });
  const seconds = (performance.now() - start) / 1000;
  if (!existsSync(usage))
    return { stdout, stderr, status: null, seconds, processor: Number.POSITIVE_INFINITY, memory: Number.NaN };
  const { maxRSS, userCPUTime, systemCPUTime } = JSON.parse(readFileSync(usage, 'utf8'));
  return { stdout, stderr, status, seconds, processor: (userCPUTime + systemCPUTime) / 1e6, memory: maxRSS / 1024 };
}

/**
 * The same of a command that must do what it is asked.
 * @throws {Error} if it does not end with 0
 */
export function runGq(folder: string, ...args: readonly string[]): Ended {
  const ended = tryGq(folder, args);
  if (ended.status === 0) return ended;
  throw new Error(`gq ${args.join(' ')}: expected exit code 0, found ${ended.status}: ${ended.stderr.slice(0, 2000)}`);
}

/** Starts a process and waits until it has said something that matches. */
export async function started(
  command: readonly string[],
  said: RegExp,
  from: 'stdout' | 'stderr',
  options: SpawnOptions,
): Promise<{ child: ChildProcess; found: string; ended: Promise<number | null> }> {
  const [first, ...args] = command;
  const child = spawn(first, args, options);
  const ended = new Promise<number | null>((resolve) => child.on('exit', resolve));
  const found = await new Promise<string>((resolve, reject) => {
    let all = '';
    child[from]?.on('data', (data: Buffer) => {
      all += data.toString();
      const match = said.exec(all);
      if (match !== null) resolve(match[0]);
    });
    void ended.then((code) => reject(new Error(`${first} ended with ${code}: ${all}`)));
  });
  return { child, found, ended };
}

/** What `gq edit` says: its address with the token. */
export const ADDRESS = /http:\S+#token=\S+/;
