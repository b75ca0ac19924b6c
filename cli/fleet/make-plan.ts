import { createHash } from 'node:crypto';
import { type Batch, type Contents, entriesOf, packFormat, readBytes, readSet } from '../io/index.ts';
import { Failure, hearSignals, namedPath } from '../terminal/index.ts';
import { type Balanced, balance, type Costs } from './balance.ts';
import { assignedOf, contentHash, entryHash, SetDigest, ShardDigest, shardOf } from './digest.ts';
import { contentsOf, type JobName } from './job.ts';
import { type Code, ownCode, PLAN_VERSION, type Plan, sealed } from './plan.ts';
import { setPaths } from './set-paths.ts';

/** What to plan. */
export interface Order extends Pick<Plan, 'paths' | 'ignore' | 'settings' | 'report'> {
  readonly job: JobName;
  readonly shards: number;
  /** What levels have cost; null: the rule alone decides. */
  readonly costs: Costs | null;
}

/** A plan, and what its shards are expected to cost. */
export interface MadePlan {
  readonly plan: Plan;
  readonly balanced: Balanced | null;
}

/** Levels that are read at a time. */
const LIMITS = { entries: 256, bytes: 1024 * 1024 };

/** Errors that are listed. */
const MOST_ERRORS = 10;

/** ms between two looks at signals */
const SLICE = 20;

/**
 * Reads a set and splits it.
 * @throws Failure if a part of it can't be read, or is there twice
 */
export async function makePlan(order: Order, onProgress: (levels: number) => void, code: Code = ownCode()): Promise<MadePlan> {
  const contents = contentsOf(order.job);
  const paths = await setPaths(order.paths, order.ignore, contents);
  const balanced = order.costs === null ? null : await balance(entriesIn(paths, contents, onProgress), order.costs, order.shards);
  const assigned = balanced?.assigned ?? Array.from({ length: order.shards }, () => []);
  const rule = { shards: order.shards, assigned: assignedOf(assigned) };
  const set = new SetDigest();
  const shards = Array.from({ length: order.shards }, () => new ShardDigest());
  const packs = new PackDigests();
  for await (const { name, content, source } of entriesIn(paths, contents, onProgress)) {
    const bytes = contentHash(content);
    const hash = entryHash(bytes, name);
    shards[shardOf(bytes, rule)].add(set.entries, hash);
    set.add(hash);
    packs.add(source, bytes);
  }
  packs.end();
  const levels = set.entries;
  const { size, blocks } = set.end();
  const { job, ignore, settings, report } = order;
  const plan = sealed({
    gq: 'plan',
    version: PLAN_VERSION,
    ...code,
    job,
    paths: [...order.paths],
    ignore,
    settings,
    report,
    levels,
    block: size,
    blocks: [...blocks],
    shards: shards.map((shard, i) => ({
      levels: shard.entries,
      hash: shard.end(),
      ...(assigned[i].length > 0 && { assigned: [...assigned[i]] }),
    })),
  });
  return { plan, balanced };
}

/** A level that could be read, and where it is from. */
interface ReadEntry {
  readonly name: string;
  readonly content: Uint8Array;
  readonly source: Batch['source'];
}

/** @throws Failure with the files that can't be read */
async function* entriesIn(
  paths: readonly string[],
  contents: Contents,
  onProgress: (levels: number) => void,
): AsyncGenerator<ReadEntry> {
  const unreadable: string[] = [];
  let listened = performance.now();
  for await (const batch of readSet(paths, contents, LIMITS)) {
    for (const { name, content } of entriesOf(batch, contents, readBytes)) {
      if (content instanceof Uint8Array) yield { name, content, source: batch.source };
      else unreadable.push(content.message);
    }
    if (performance.now() - listened < SLICE) continue;
    onProgress(batch.first);
    await hearSignals();
    listened = performance.now();
  }
  if (unreadable.length === 0) return;
  const more = unreadable.length > MOST_ERRORS ? `\nand ${unreadable.length - MOST_ERRORS} more` : '';
  throw new Failure(`nothing was planned: files can't be read:\n${unreadable.slice(0, MOST_ERRORS).join('\n')}${more}`);
}

/** Notices when two packs have the same content: one of them is a copy that would count twice. */
class PackDigests {
  private readonly seen = new Map<string, string>();
  private pack: string | null = null;
  private hash = createHash('sha256');

  add(source: Batch['source'], bytes: Buffer): void {
    const pack = 'pack' in source ? source.pack : null;
    if (pack !== this.pack) this.end();
    this.pack = pack;
    if (pack !== null) this.hash.update(bytes);
  }

  /** @throws Failure if the pack has the same levels as another */
  end(): void {
    if (this.pack === null) return;
    const digest = this.hash.digest('hex');
    const other = this.seen.get(digest);
    if (other !== undefined && packFormat(other) !== null) {
      throw new Failure(
        `${namedPath(this.pack)} has the same content as ${namedPath(other)}: expected each level once; leave one of the two out`,
      );
    }
    this.seen.set(digest, this.pack);
    this.hash = createHash('sha256');
    this.pack = null;
  }
}
