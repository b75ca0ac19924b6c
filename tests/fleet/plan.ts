import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fallThrough, gq } from '../cli/gq.ts';

/** Writes `plan.json` with so many shards of one level. */
export async function planOf(directory: string, shards: number): Promise<void> {
  writeFileSync(join(directory, 'a.level.json'), fallThrough());
  const { code, stderr } = await gq(['plan', 'a.level.json', '--shards', `${shards}`, '--force'], { cwd: directory });
  if (code !== 0) throw new Error(stderr);
}
