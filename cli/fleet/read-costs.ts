import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { readRegularFile, statOrError } from '../io/index.ts';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';
import { Costs } from './balance.ts';
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
  if (!costs.areAllZero) return costs;
  throw new Failure(
    `--costs ${namedPath(path)}: it has no times: expected a directory with results of shards, or what gq check --format json has printed`,
  );
}

/** @throws Failure if it is no time */
function add(costs: Costs, file: string, ms: number, path: string): void {
  if (!(ms >= 0 && ms <= LONGEST)) {
    throw new Failure(
      `--costs ${namedPath(path)}: expected times from 0 to ${LONGEST} ms, found ${ms} for ${namedPath(file)}: it was changed by hand`,
    );
  }
  costs.set(file, ms);
}

function costsOfResults(folder: string): Costs {
  const costs = new Costs();
  for (const name of readdirSync(folder).sort()) {
    if (!RESULT_FILE.test(name)) continue;
    const path = join(folder, name);
    try {
      addCostsOf(path, costs);
    } catch (error) {
      if (error instanceof Failure) throw error;
      throw new Failure(`--costs ${namedPath(path)}: can't be read: ${systemReason(error)}`);
    }
  }
  return costs;
}

function addCostsOf(result: string, costs: Costs): void {
  const reader = new LineReader(result);
  for (let line = reader.next(); line !== null; line = reader.next()) {
    const record = RECORD.exec(line.toString('utf8', 0, 2048));
    if (record !== null) add(costs, JSON.parse(record[1]), Number(record[2]), result);
  }
}

function costsOfReport(path: string): Costs {
  let report: unknown;
  try {
    report = JSON.parse(Buffer.from(readRegularFile(path, LARGEST)).toString());
  } catch (error) {
    throw new Failure(`--costs ${namedPath(path)}: can't be read: ${systemReason(error)}`);
  }
  const { levels } = (report ?? {}) as { readonly levels?: unknown };
  const costs = new Costs();
  for (const level of Array.isArray(levels) ? levels : []) {
    const { file, ms } = (level ?? {}) as { readonly file?: unknown; readonly ms?: unknown };
    if (typeof file === 'string' && typeof ms === 'number') add(costs, file, ms, path);
  }
  return costs;
}
