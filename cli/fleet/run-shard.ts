import { lstatSync } from 'node:fs';
import { type Batch, entriesOf, makeFolders, readBytes, readSet, sizeOf } from '../io/index.ts';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';
import { assignedOf, DIGEST, SetDigest, ShardDigest } from './digest.ts';
import { contentsOf } from './job.ts';
import { jobOf } from './jobs/index.ts';
import type { Plan } from './plan.ts';
import { headerOf, inspect, ResultWriter, resultPath } from './result.ts';
import { setPaths } from './set-paths.ts';
import { type Asked, sharedText, workInThreads } from './threads.ts';
import type { Common, Done } from './worker.ts';

/** What has become of a shard. */
export type ShardOutcome =
  | { readonly status: 'written' | 'already there'; readonly path: string; readonly levels: number }
  /** Another process has written a result meanwhile that differs. */
  | { readonly status: 'differs'; readonly path: string; readonly kept: string }
  | { readonly status: 'stopped' };

/** Levels that a thread gets at once: searches take long, so few. */
export const limitsFor = (isLong: boolean) => ({ entries: isLong ? 8 : 64, bytes: 256 * 1024 });

/** Results of one shard that differ at most; more of them would be the same trouble once more. */
const MOST_DIFFERING = 100;

/**
 * Does a shard, unless its result is there already.
 * @param isLong whether a level may take seconds
 * @throws Failure if the set is not that of the plan, or the result can't be written
 */
export async function runShard(
  plan: Plan,
  shard: number,
  folder: string,
  {
    jobs,
    isLong,
    stopping,
    onProgress,
  }: {
    readonly jobs: number;
    readonly isLong: boolean;
    readonly stopping: AbortSignal;
    readonly onProgress: (done: number) => void;
  },
): Promise<ShardOutcome> {
  const path = resultPath(folder, shard);
  tryTo(folder, () => makeFolders(folder));
  const before = whatIsThere(path, plan, shard);
  if (before?.state === 'complete') return { status: 'already there', path, levels: before.levels };
  const { job } = plan;
  await jobOf(job).expectInputs?.(plan.settings);
  const contents = contentsOf(job);
  const paths = await setPaths(plan.paths, plan.ignore, contents);
  const common: Common = {
    job,
    contents,
    settings: sharedText(plan.settings),
    rule: { shards: plan.shards.length, assigned: assignedOf(plan.shards.map(({ assigned = [] }) => assigned)) },
    shard,
  };
  const comparison = new Comparison(plan);
  const own = new ShardDigest();
  const out = tryTo(path, () => new ResultWriter(path, headerOf(plan, shard)));
  try {
    const take = (done: Done, { tag: batch }: Asked<Batch>): void => {
      if (done.unreadable.length > 0) throw new Failure(`${done.unreadable.join('\n')}\nthe set is no longer that of the plan`);
      const hashes = Buffer.from(done.hashes.buffer, done.hashes.byteOffset, done.hashes.length);
      comparison.add(batch, hashes);
      for (const i of done.own) own.add(batch.first + i, hashes.subarray(DIGEST * i, DIGEST * (i + 1)));
      tryTo(path, () => {
        for (const line of done.lines) out.add(line);
      });
      onProgress(own.entries);
    };
    await workInThreads(tasksOf(readSet(paths, contents, limitsFor(isLong)), common), jobs, stopping, take);
    if (stopping.aborted) return { status: 'stopped' };
    comparison.end();
    const levels = own.entries;
    if (own.end() !== plan.shards[shard].hash)
      throw new Error(`the rule of the plan gives shard ${shard} other levels than gq plan did`);
    const records = tryTo(path, () => out.end());
    // a damaged one is replaced; a good one that another process has written meanwhile is not
    const isDamaged = before?.state === 'damaged' && whatIsThere(path, plan, shard)?.state === 'damaged';
    if (tryTo(path, () => out.place(path, isDamaged))) return { status: 'written', path, levels };
    const other = whatIsThere(path, plan, shard);
    if (other?.state === 'complete' && other.records === records) return { status: 'already there', path, levels };
    for (let k = 1; k <= MOST_DIFFERING; k++) {
      const kept = path.replace(/\.ndjson$/, `.differs-${k}.ndjson`);
      if (tryTo(kept, () => out.place(kept))) return { status: 'differs', path, kept };
    }
    throw new Failure(
      `${namedPath(path)}: another result of this shard is there, and ${MOST_DIFFERING} that differ: move them away`,
    );
  } finally {
    out.discard();
  }
}

async function* tasksOf(batches: AsyncIterable<Batch>, common: Common): AsyncGenerator<Asked<Batch>> {
  for await (const batch of batches) yield { task: { batch, common }, tag: batch };
}

/** @throws Failure if something else has the name of the result, or one that was changed */
function whatIsThere(path: string, plan: Plan, shard: number) {
  let found: ReturnType<typeof inspect>;
  try {
    found = inspect(path, headerOf(plan, shard));
  } catch (error) {
    const isAbsent = (error as NodeJS.ErrnoException).code === 'ENOENT';
    if (isAbsent && lstatSync(path, { throwIfNoEntry: false }) === undefined) return null;
    if (isAbsent) throw new Failure(`${namedPath(path)}: it is a broken link: expected a result or nothing; move it away`);
    throw new Failure(`${namedPath(path)}: what is there can't be read: ${systemReason(error)}`);
  }
  if (found.state === 'complete' && found.set !== plan.shards[shard].hash) {
    throw new Failure(
      `${namedPath(path)}: the result that is there has other levels than shard ${shard} of the plan, so it was changed; nothing was overwritten: move it away`,
    );
  }
  if (found.state !== 'foreign') return found;
  throw new Failure(
    `${namedPath(path)}: a file is there that is no result of this shard: ${found.why}; nothing was overwritten: choose another --out, or move it away`,
  );
}

function tryTo<T>(path: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`${namedPath(path)}: can't be written: ${systemReason(error)}; the shard has no result`);
  }
}

/** Compares a set with that of a plan while it is read. */
class Comparison {
  private readonly digest: SetDigest;
  /** The batches from the block under way on, to name its levels. */
  private recent: Batch[] = [];

  constructor(private readonly plan: Plan) {
    this.digest = new SetDigest(plan.block, (hash, index) => {
      if (plan.blocks[index] !== hash.toString('hex', 0, 16)) throw this.differs(index);
    });
  }

  /** @throws Failure if the plan has other levels at this place */
  add(batch: Batch, hashes: Buffer): void {
    const begin = this.digest.entries - (this.digest.entries % this.plan.block);
    this.recent = this.recent.filter(({ first, ...rest }) => first + sizeOf({ first, ...rest }) > begin);
    this.recent.push(batch);
    for (let at = 0; at < hashes.length; at += DIGEST) this.digest.add(hashes.subarray(at, at + DIGEST));
  }

  /** @throws Failure if the plan has more levels */
  end(): void {
    this.digest.end();
    const { entries } = this.digest;
    if (entries !== this.plan.levels) throw new Failure(this.words(`it has ${entries}, ${this.plan.levels} were planned`));
  }

  private differs(index: number): Failure {
    const { block, levels, paths, job } = this.plan;
    const from = index * block;
    if (from >= levels) return new Failure(this.words(`it has more than the ${levels} that were planned`));
    const contents = contentsOf(job);
    const names = this.recent
      .flatMap((batch) => [...entriesOf(batch, contents, readBytes)].map(({ name }, i) => ({ name, n: batch.first + i })))
      .filter(({ n }) => n >= from && n < from + block)
      .map(({ name }) => namedPath(name));
    const which = names.length <= 1 ? names[0] : `${names[0]} to ${names[names.length - 1]}`;
    const count = Math.min(block, levels - from);
    const what = count === 1 ? `level ${from + 1} of ${levels}` : `levels ${from + 1} to ${from + count} of ${levels}`;
    return new Failure(
      this.words(
        `${what} (${which}) ${count === 1 ? 'is' : 'are'} not as planned; the set is ${paths.map(namedPath).join(', ')}`,
      ),
    );
  }

  private words(what: string): string {
    return `the set is no longer that of the plan: ${what}: a level has changed, is missing or is new; restore it, or make the plan anew with gq plan`;
  }
}
