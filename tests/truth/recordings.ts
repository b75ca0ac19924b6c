import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** Where the recordings of the original are: `GQ_TRUTH`, or `../shared/truth` beside the project. They are not part of it. */
export const truthFolder = process.env.GQ_TRUTH ?? join(root, '..', 'shared', 'truth');

export const hasTruth = existsSync(join(truthFolder, 'arcade')) && existsSync(join(truthFolder, 'original-levels.json'));

/** What a person is told who has no recordings. */
export const NO_TRUTH = 'no recordings of the original at ../shared/truth: name their folder in GQ_TRUTH';

/** frame, x, y, vx, vy, angle, nearest asteroid, minerals, and [x, y, alive] of each alien where the level has any */
export type RecordedRow = [number, number, number, number, number, number, number, number, [number, number, 0 | 1 | boolean][]?];

export interface RecordedRun {
  readonly name: string;
  readonly holds: readonly [number, number][];
  readonly outcome: 'completed' | 'collided' | 'lost' | 'timeout';
  readonly with: string | null;
  readonly frame: number;
  readonly minerals: number;
  readonly nearest: readonly [frame: number, asteroid: number][];
  readonly rows: readonly RecordedRow[];
}

export interface Recording {
  readonly level: number;
  readonly runs: readonly RecordedRun[];
}

/** What the original did, level by level. */
export function arcadeRecordings(): Recording[] {
  const folder = join(truthFolder, 'arcade');
  return readdirSync(folder)
    .filter((file) => file.endsWith('.json.gz'))
    .sort()
    .map((file) => JSON.parse(gunzipSync(readFileSync(join(folder, file))).toString('utf8')));
}

/** The text of the original's levels. */
export const originalLevels = (): string => readFileSync(join(truthFolder, 'original-levels.json'), 'utf8');
