import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));
const PRELOADED = new URL('../../bench/usage.mjs', import.meta.url).href;

/** What a process has used. */
export interface Usage {
  /** s of wall time and of processor time */
  readonly seconds: number;
  readonly processor: number;
  /** MB */
  readonly memory: number;
}

/**
 * Runs the built `gq` in a folder, and measures what it uses.
 * @param codes the exit codes that are expected
 * @throws {Error} if it ends with another one
 */
export function runGq(folder: string, codes: readonly number[], args: readonly string[]): Usage {
  const usage = join(folder, 'usage.json');
  const start = performance.now();
  const { status, stderr } = spawnSync(process.execPath, ['--import', PRELOADED, GQ, ...args], {
    cwd: folder,
    encoding: 'utf8',
    env: { ...process.env, GQ_USAGE: usage },
    maxBuffer: 2 ** 30,
  });
  const seconds = (performance.now() - start) / 1000;
  if (status === null || !codes.includes(status)) {
    throw new Error(`gq ${args.join(' ')}: expected exit code ${codes.join(' or ')}, found ${status}: ${stderr}`);
  }
  const { maxRSS, userCPUTime, systemCPUTime } = JSON.parse(readFileSync(usage, 'utf8'));
  return { seconds, processor: (userCPUTime + systemCPUTime) / 1e6, memory: maxRSS / 1024 };
}
