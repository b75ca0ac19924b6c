import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

/** Writes `plan.json` with so many shards. */
export async function planOf(directory: string, shards: number): Promise<void> {
  writeFileSync(join(directory, 'plan.json'), JSON.stringify({ for: 'check', shards }));
}
