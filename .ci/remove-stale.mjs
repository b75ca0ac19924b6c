import { existsSync, readdirSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';
import process from 'node:process';

// node .ci/remove-stale.mjs [PROJECT]
// Removes from dist what the compiler has made of sources that are no longer there: it never deletes, and a package made in an
// old clone would contain it. `npm pack` runs it.

const PROJECT = resolve(process.argv[2] ?? join(import.meta.dirname, '..'));

/** Folders of dist in which every module is made of a source of the same name. */
const ROOMS = ['schema', 'engine', 'game', 'phaser', 'solver', 'check', 'picture', 'review', 'cli'];

for (const room of ROOMS) {
  const built = join(PROJECT, 'dist', room);
  if (!existsSync(built)) continue;
  for (const file of readdirSync(built, { recursive: true })) {
    const made = /^(.*?)(?:\.d\.ts|\.js|\.js\.map)$/.exec(file);
    if (made === null || ['.ts', '.tsx'].some((end) => existsSync(join(PROJECT, room, `${made[1]}${end}`)))) continue;
    rmSync(join(built, file));
  }
}
