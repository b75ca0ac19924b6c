import { createHash } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { create } from 'tar';
import { fallThrough, gq, makeFiles } from '../cli/gq.ts';

/** A set of levels, each another, most of them completable. */
export const levelTexts = (count: number): string[] =>
  Array.from({ length: count }, (_, i) => {
    const level = { name: `Level ${i}`, blackHole: { x: 170 + (i % 60), y: 0 } };
    if (i % 7 === 5) return fallThrough({ ...level, runs: [] });
    if (i % 11 === 8) return fallThrough({ ...level, name: i });
    return fallThrough(level);
  });

/** A set in a directory of its own: the first levels as files, then NDJSON, the last in an archive. */
export interface TestSet {
  readonly directory: string;
  /** What a command is given. */
  readonly paths: readonly string[];
  /** The names of the levels in reports, in the order of the set. */
  readonly names: readonly string[];
  readonly texts: readonly string[];
  remove(): void;
}

export async function makeSet(texts: readonly string[]): Promise<TestSet> {
  const third = Math.ceil(texts.length / 3);
  const place = makeFiles({});
  const { directory } = place;
  const put = (name: string, content: string | Uint8Array): void => {
    mkdirSync(dirname(join(directory, name)), { recursive: true });
    writeFileSync(join(directory, name), content);
  };
  const names: string[] = [];
  const paths: string[] = [];
  const label = (i: number): string => String(i).padStart(4, '0');
  for (const [i, text] of texts.entries()) {
    if (i < third) {
      put(`levels/${label(i)}.level.json`, text);
      names.push(`levels/${label(i)}.level.json`);
    } else if (i < 2 * third) names.push(i % 2 === 0 ? `lines.ndjson.gz#${i - third + 1}` : `lines.ndjson.gz#id-${i}`);
    else {
      put(`inside/${label(i)}.level.json`, text);
      names.push(`files.tar#inside/${label(i)}.level.json`);
    }
  }
  if (third > 0) paths.push('levels');
  if (texts.length > third) {
    const lines = texts
      .slice(third, 2 * third)
      .map((text, i) => ((i + third) % 2 === 0 ? text : `{"id": "id-${i + third}", "level": ${text}}`));
    put('lines.ndjson.gz', gzipSync(`${lines.join('\n')}\n`));
    paths.push('lines.ndjson.gz');
  }
  if (texts.length > 2 * third) {
    const inside = readdirSync(join(directory, 'inside')).sort();
    await create(
      { cwd: directory, file: join(directory, 'files.tar') },
      inside.map((name) => `inside/${name}`),
    );
    paths.push('files.tar');
  }
  return { directory, paths, names, texts, remove: place.remove };
}

/** The shard of a level, by the rule as it is documented. */
export const shardOfText = (text: string, shards: number): number =>
  Number.parseInt(createHash('sha256').update(text).digest('hex').slice(0, 8), 16) % shards;

export interface Result {
  readonly code: number | null;
  readonly stdout: string;
  readonly stderr: string;
}

/** Plans a set. */
export async function planSet(set: TestSet, shards: number, ...options: readonly string[]): Promise<void> {
  const { code, stderr } = await gq(['plan', ...set.paths, '--shards', `${shards}`, '--force', ...options], {
    cwd: set.directory,
  });
  if (code !== 0) throw new Error(stderr);
}

export const runShard = (set: TestSet, shard: number | string, out = 'out'): Promise<Result> =>
  gq(['check', '--plan', 'plan.json', '--shard', `${shard}`, '--out', out], { cwd: set.directory });

export const merge = (set: TestSet, ...options: readonly string[]): Promise<Result> =>
  gq(['merge', 'out', '--plan', 'plan.json', ...options], { cwd: set.directory });

/** Plans, does and merges a set. @returns the merge */
export async function doAll(
  set: TestSet,
  shards: number,
  order: readonly number[],
  ...options: readonly string[]
): Promise<Result> {
  await planSet(set, shards);
  for (const shard of order) {
    const { code, stderr } = await runShard(set, shard);
    if (code !== 0) throw new Error(stderr);
  }
  return merge(set, '--format', 'json', ...options);
}

export interface RecordLine {
  n: number;
  file: string;
  sha256: string;
  ms: number;
  result: Record<string, unknown>;
}

/** The lines of a result: header, records, trailer. */
export const resultLines = (set: TestSet, shard: number): string[] =>
  readFileSync(join(set.directory, 'out', `shard-${shard}.ndjson`), 'utf8')
    .split('\n')
    .slice(0, -1);

const withoutTime = (line: string): string => line.replace(/,"ms":[-+.e\d]+,"result":/, ',"result":');

/** Writes a result with a correct checksum, as a liar does. */
export function writeResult(set: TestSet, shard: number, lines: readonly string[], name = `shard-${shard}.ndjson`): void {
  const body = lines.map((line) => `${line}\n`).join('');
  const records = createHash('sha256');
  for (const line of lines.slice(1)) records.update(`${withoutTime(line)}\n`);
  const trailer = {
    gq: 'end',
    levels: lines.length - 1,
    records: records.digest('hex'),
    sha256: createHash('sha256').update(body).digest('hex'),
  };
  writeFileSync(join(set.directory, 'out', name), `${body}${JSON.stringify(trailer)}\n`);
}
