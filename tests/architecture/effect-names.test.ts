import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { KINDS, LISTED_KINDS } from '../../schema/index.ts';
import { ROOMS } from './rooms.ts';

// What an effect is and does stands in few files: a change of it, or another one like it, touches no others.

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const sources = Object.keys(ROOMS).flatMap((room) =>
  readdirSync(join(root, room), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && /\.(tsx?|json)$/.test(entry.name))
    .map((entry) => relative(root, join(entry.parentPath, entry.name)).split(sep).join('/')),
);

/** The files of all rooms that name an effect, or its kind of object: as a word, or as a part of one that begins or goes on with a capital. */
function filesThatName(kind: string): string[] {
  const [first, rest] = [kind[0], kind.slice(1)];
  const named = new RegExp(`(?<![A-Za-z])${kind}s?(?![a-z])|${first.toUpperCase()}${rest}s?(?![a-z])`);
  return sources.filter((path) => named.test(readFileSync(join(root, path), 'utf8'))).sort();
}

/** Where a kind of object and its effect may be named: its own files, and a line or two in the tables. */
const mayName = (kind: string): string[] => [
  `editor/canvas/kinds/${kind}.ts`,
  'editor/canvas/kinds/index.ts',
  'engine/effects/index.ts',
  'engine/effects/order.ts',
  'engine/effects/parts.ts',
  'engine/light/index.ts',
  'game/light/index.ts',
  'phaser/drawing/drawings.ts',
  `phaser/drawing/${kind}.ts`,
  `picture/kinds/${kind}.ts`,
  'picture/kinds/index.ts',
  'schema/basics/kinds.ts',
  'schema/level.schema.json',
  'solver/generate/placed/index.ts',
  `solver/generate/placed/${kind}.ts`,
];

/** A way to prove that follows an effect, or keeps out of it, and its check: they understand it by name, or refuse it. */
const PROOFS = /^solver\/(proofs|verify)\//;

// The kinds that the original game does not have: each was added after the tables were there.
describe.each(LISTED_KINDS.filter((kind) => KINDS[kind].original === null))('%s', (kind) => {
  it('is named by its own files, the tables and the proofs that know it, and by no other', () => {
    const files = filesThatName(kind);
    const own = `engine/effects/${kind}s/`;
    expect(files.filter((path) => !path.startsWith(own) && !PROOFS.test(path))).toEqual(mayName(kind).sort());
    expect(files.filter((path) => path.startsWith(own)).length).toBeGreaterThan(3);
  });
});
