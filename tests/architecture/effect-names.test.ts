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
function filesThatName(kind: string, many = `${kind}s`): string[] {
  const forms = [kind, many].map((word) => `(?<![A-Za-z])${word}(?![a-z])|${word[0].toUpperCase()}${word.slice(1)}(?![a-z])`);
  const named = new RegExp(forms.join('|'));
  return sources.filter((path) => named.test(readFileSync(join(root, path), 'utf8'))).sort();
}

/** Where a kind of object and its effect may be named: its own files, and a line or two in the tables. */
const mayName = (kind: string): string[] => [
  'editor/canvas/kinds.ts',
  'engine/effects/index.ts',
  'engine/effects/order.ts',
  'engine/effects/parts.ts',
  'engine/light/index.ts',
  'game/light/index.ts',
  'phaser/drawing/textures.ts',
  `phaser/drawing/${kind}.ts`,
  `picture/kinds/${kind}.ts`,
  'picture/kinds/index.ts',
  'schema/basics/kinds.ts',
  'schema/level.schema.json',
  'solver/make/generate/placed.ts',
];

/** A way to prove that follows an effect, or keeps out of it, and its check: they understand it by name, or refuse it. */
// a witness of the game knows all of it: proofs, their checker, and the references with 32 digits
const PROOFS = /^(solver\/(prove|verify)|engine\/work-precision\/reference)\//;

// The kinds that the original game does not have: each was added after the tables were there.
describe.each(LISTED_KINDS.filter((kind) => KINDS[kind].original === null))('%s', (kind) => {
  it('is named by its own files, the tables and the proofs that know it, and by no other', () => {
    const files = filesThatName(kind);
    const own = `engine/effects/${kind}s/`;
    expect(files.filter((path) => !path.startsWith(own) && !PROOFS.test(path))).toEqual(mayName(kind).sort());
    expect(files.filter((path) => path.startsWith(own)).length).toBeGreaterThan(0);
  });
});

/**
 * The kinds of the original game stood in the code before the tables did. How many files still name each, outside its own files,
 * the tables, and the proofs: what every other file knows of them by name. The numbers only come down. Before kinds were parts
 * they were 37, 101, 76, 232 and 45.
 *
 * What is left: names that the package publishes (`Scene`, `Run`, `Simulation`, `Trajectory`, skins, colours); the frames of the
 * original game, which examine novae, hot asteroids and minerals in its order; the importer; themes of generated levels; words for
 * people; and minerals, which are what runs are counted and searched by.
 */
const STILL = {
  repulsor: { own: ['engine/effects/repulsor/', 'engine/warnings/repulsor-'], elsewhere: 15 },
  alien: { own: ['engine/effects/aliens/'], elsewhere: 59 },
  nova: { own: ['engine/effects/hazards/'], many: 'novae', elsewhere: 52 },
  mineral: { own: ['engine/effects/minerals/', 'engine/warnings/minerals'], elsewhere: 186 },
  hot: { own: ['engine/effects/hazards/'], elsewhere: 34 },
} as const;

describe.each(Object.entries(STILL))('%s, of the original game', (kind, { elsewhere, own, ...forms }) => {
  it(`is named in at most ${elsewhere} files besides its own, the tables and the proofs`, () => {
    const tables = [...mayName(kind), 'engine/warnings/index.ts'];
    const isOwn = (path: string) => own.some((folder) => path.startsWith(folder)) || tables.includes(path);
    const named = filesThatName(kind, 'many' in forms ? forms.many : undefined);
    const found = named.filter((path) => !isOwn(path) && !PROOFS.test(path) && !path.endsWith('.schema.json'));
    expect(found.length, found.join('\n')).toBeLessThanOrEqual(elsewhere);
    expect(named.some((path) => path.startsWith(own[0]))).toBe(true);
  });
});
