import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { Failure, systemReason } from '../failure.ts';
import { statOrError } from '../files.ts';
import { readRegularFile } from '../regular-file.ts';
import { namedPath } from '../shown-path.ts';
import type { Costs } from './balance.ts';
import { LineReader } from './line-reader.ts';
import { RESULT_FILE } from './result.ts';

/** ms of a level at most: about a year. Sums of such times stay exact enough. */
const LONGEST = 3e10;

/** Bytes of a report at most: larger sets have results of shards. */
const LARGEST = 256 * 1024 * 1024;

const RECORD = /^\{"n":\d+,"file":("(?:[^"\\]|\\.)*"),"sha256":"[0-9a-f]{64}","ms":([-+.e\d]+),/;

/**
 * Reads what levels have cost.
 * @param path a directory with results of shards, or a report of `gq check --format json`
 * @throws Failure if it has no costs
 */
export function readCosts(path: string): Costs {
  const stats = statOrError(path);
  if (stats instanceof Error) throw new Failure(`--costs ${namedPath(path)}: ${systemReason(stats)}`);
  const costs = stats.isDirectory() ? costsOfResults(path) : costsOfReport(path);
  const odd = [...costs].find(([, ms]) => !(ms >= 0 && ms <= LONGEST));
  if (odd !== undefined) {
    throw new Failure(
      `--costs ${namedPath(path)}: expected times from 0 to ${LONGEST} ms, found ${odd[1]} for ${namedPath(odd[0])}: it was changed by hand`,
    );
  }
  if ([...costs.values()].some((ms) => ms > 0)) return costs;
  throw new Failure(
    `--costs ${namedPath(path)}: it has no times: expected a directory with results of shards, or what gq check --format json has printed`,
  );
}

function costsOfResults(folder: string): Map<string, number> {
  const costs = new Map<string, number>();
  for (const name of readdirSync(folder).sort()) {
    if (!RESULT_FILE.test(name)) continue;
    const path = join(folder, name);
    try {
      addCostsOf(path, costs);
    } catch (error) {
      throw new Failure(`--costs ${namedPath(path)}: can't be read: ${systemReason(error)}`);
    }
  }
  return costs;
}

function addCostsOf(result: string, costs: Map<string, number>): void {
  const reader = new LineReader(result);
  for (let line = reader.next(); line !== null; line = reader.next()) {
    const record = RECORD.exec(line.toString('utf8', 0, 2048));
    if (record !== null) costs.set(JSON.parse(record[1]), Number(record[2]));
  }
}

function costsOfReport(path: string): Map<string, number> {
  let report: unknown;
  try {
    report = JSON.parse(Buffer.from(readRegularFile(path, LARGEST)).toString());
  } catch (error) {
    throw new Failure(`--costs ${namedPath(path)}: can't be read: ${systemReason(error)}`);
  }
  const { levels } = (report ?? {}) as { readonly levels?: unknown };
  const costs = new Map<string, number>();
  for (const level of Array.isArray(levels) ? levels : []) {
    const { file, ms } = (level ?? {}) as { readonly file?: unknown; readonly ms?: unknown };
    if (typeof file === 'string' && typeof ms === 'number') costs.set(file, ms);
  }
  return costs;
}
