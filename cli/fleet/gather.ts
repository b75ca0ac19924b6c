import { readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { Failure, hearSignals, namedPath, systemReason } from '../terminal/index.ts';
import type { Json } from './job.ts';
import { LineReader } from './line-reader.ts';
import type { Plan } from './plan.ts';
import { headerOf, inspect, RESULT_FILE, recordOfLine, resultName } from './result.ts';

/** The results of a plan that were found. */
export interface Gathered {
  /** The result of each shard; null: it is missing. */
  readonly results: readonly (string | null)[];
  readonly missing: readonly number[];
  /** What was found besides good results, for people: damaged ones, copies. */
  readonly notes: readonly string[];
  /** Results that contradict each other or the plan: why. */
  readonly conflicts: readonly string[];
  /** Depends on every result, so that nobody who writes one knows it before. */
  readonly seed: string;
}

/**
 * Finds the results of a plan in folders, and reads each to its end.
 * @throws Failure if a folder can't be read, or has a result of another plan
 */
export async function gather(plan: Plan, folders: readonly string[]): Promise<Gathered> {
  const results: (string | null)[] = plan.shards.map(() => null);
  const records = new Map<number, string>();
  const sums: string[] = [];
  const notes: string[] = [];
  const conflicts: string[] = [];
  const foreign: string[] = [];
  for (const path of resultsIn(folders)) {
    const shard = shardOfName(basename(path));
    if (shard >= plan.shards.length) {
      foreign.push(`${namedPath(path)}: the plan has shards 0 to ${plan.shards.length - 1} only`);
      continue;
    }
    const found = tryTo(path, () => inspect(path, headerOf(plan, shard)));
    await hearSignals();
    if (found.state === 'foreign') foreign.push(`${namedPath(path)}: ${found.why}`);
    else if (found.state === 'damaged') notes.push(`${namedPath(path)}: not counted: ${found.why}`);
    else if (found.set !== plan.shards[shard].hash)
      conflicts.push(`${namedPath(path)}: it has other levels than shard ${shard} of the plan`);
    else if (results[shard] === null) {
      results[shard] = path;
      records.set(shard, found.records);
      sums.push(`${shard} ${found.records}`);
    } else if (records.get(shard) === found.records) notes.push(`${namedPath(path)}: the same as ${namedPath(results[shard])}`);
    else conflicts.push(firstDifference(results[shard], path));
  }
  if (foreign.length > 0) {
    throw new Failure(
      `nothing was merged: expected results of this plan alone:\n${foreign.map((line) => `  ${line}\n`).join('')}merge them with their own plan, or move them away`,
    );
  }
  const missing = results.flatMap((path, shard) => (path === null ? [shard] : []));
  return { results, missing, notes, conflicts, seed: sums.sort().join('\n') };
}

/** The shard in the name of a result. */
const shardOfName = (name: string): number => Number(RESULT_FILE.exec(name)![1]);

/** The results in folders, good or not. @throws Failure if a folder can't be read */
export function resultsIn(folders: readonly string[]): string[] {
  return folders.flatMap((folder) => {
    const names = tryTo(folder, () => readdirSync(folder)).filter((name) => RESULT_FILE.test(name));
    // a result before those that differ from it
    const rank = (name: string): string => `${name === resultName(shardOfName(name)) ? 0 : 1} ${name}`;
    return names.sort((a, b) => (rank(a) < rank(b) ? -1 : 1)).map((name) => join(folder, name));
  });
}

/** Says which level two results judge differently. */
function firstDifference(a: string, b: string): string {
  const readers = [new LineReader(a), new LineReader(b)];
  const next = () => readers.map((reader) => reader.next());
  next();
  for (let [x, y] = next(); x !== null && y !== null; [x, y] = next()) {
    const [left, right] = [recordOfLine(x), recordOfLine(y)];
    if (left.result === undefined || right.result === undefined) break;
    if (JSON.stringify(left.result) === JSON.stringify(right.result)) continue;
    const { place, one, other } = differenceOf('', left.result, right.result);
    return `${namedPath(a)} and ${namedPath(b)} differ at ${namedPath(left.file)}: ${place} is ${one} in one, ${other} in the other`;
  }
  return `${namedPath(a)} and ${namedPath(b)} differ`;
}

/** The first place at which two values differ, and what is there. */
function differenceOf(
  place: string,
  a: unknown,
  b: unknown,
): { readonly place: string; readonly one: string; readonly other: string } {
  const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null;
  if (isObject(a) && isObject(b)) {
    const key = Object.keys({ ...a, ...b }).find((name) => JSON.stringify(a[name]) !== JSON.stringify(b[name]));
    if (key !== undefined) return differenceOf(place === '' ? key : `${place}.${key}`, a[key], b[key]);
  }
  const short = (value: unknown): string => (JSON.stringify(value) ?? 'missing').slice(0, 80);
  return { place, one: short(a), other: short(b) };
}

function tryTo<T>(path: string, work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Failure(`${namedPath(path)}: can't be read: ${systemReason(error)}`);
  }
}
