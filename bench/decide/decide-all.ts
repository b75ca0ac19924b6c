import { Worker } from 'node:worker_threads';
import type { NamedLevel } from '../harness/index.ts';
import type { Decision, Effort } from './decide.ts';

/** Divides levels among workers. The decisions are in the order of the levels. */
export async function decideAll(levels: readonly NamedLevel[], effort: Effort, jobs: number): Promise<Decision[]> {
  const decisions = new Map<string, Decision>();
  await Promise.all(
    Array.from({ length: jobs }, (_, job) => {
      const share = levels.filter((_level, i) => i % jobs === job);
      const worker = new Worker(new URL('./worker.js', import.meta.url), { workerData: { levels: share, effort } });
      return new Promise<void>((resolve, reject) => {
        worker.on('message', (decision: Decision | null) => {
          if (decision === null) return void worker.terminate().then(() => resolve());
          decisions.set(decision.name, decision);
          if (process.stderr.isTTY) process.stderr.write(`\r${decisions.size} of ${levels.length} `);
        });
        worker.on('error', reject);
      });
    }),
  );
  return levels.flatMap(({ name }) => decisions.get(name) ?? []);
}

/**
 * Searches some of the levels proved impossible.
 * @returns all decisions, with those of the sample made anew
 */
export async function refuteSome(
  levels: readonly NamedLevel[],
  decisions: readonly Decision[],
  count: number,
  effort: Effort,
  jobs: number,
): Promise<Decision[]> {
  const impossible = new Set(decisions.filter(({ verdict }) => verdict === 'impossible').map(({ name }) => name));
  const proved = levels.filter(({ name }) => impossible.has(name));
  // every n-th, so that the sample spans the set
  const step = Math.max(1, proved.length / count);
  const sample = Array.from({ length: Math.min(count, proved.length) }, (_, i) => proved[Math.floor(i * step)]);
  const again = new Map((await decideAll(sample, effort, jobs)).map((decision) => [decision.name, decision]));
  return decisions.map((decision) => again.get(decision.name) ?? decision);
}
