import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import type * as Engine from '../../engine/index.ts';
import { createPlayer, type Player } from '../../game/index.ts';
import { committedTable } from '../browsers/hash-table.ts';
import { hashedRuns } from '../browsers/scenes.ts';
import { isDeep, someOf } from '../depth.ts';
import { byEsbuild, byVite, run, zipped } from './bundle.ts';

const LIGHT = './game/light/index.ts';
const PARTS = ['aliens', 'recoil', 'repulsors', 'winds', 'wormholes'];

/**
 * What a page may load, gzipped bytes. The comments are what esbuild and Vite make of it today. docs/library.md has this table.
 */
const LIMITS = [
  // 67 and 49 bytes
  { what: 'one constant', source: "export { TICK } from './engine/index.ts';", most: 1000 },
  // 8.2 and 8.0 kB: with the scan, the shape and the tables that the reader of the schema has, too
  { what: '`readLevel`', source: "export { readLevel } from './game/index.ts';", most: 8400 },
  // 32.0 and 31.3 kB
  {
    what: 'a player of no other part',
    source: `import { composePlayer } from '${LIGHT}'; export const createPlayer = composePlayer();`,
    most: 32_900,
  },
  // 45.3 and 44.2 kB
  {
    what: 'a player of every part that the shipped levels call for',
    source: `import { composePlayer, ${PARTS.join(', ')} } from '${LIGHT}'; export const createPlayer = composePlayer([${PARTS.join(', ')}]);`,
    most: 46_400,
  },
  // 40.1 and 39.1 kB
  {
    what: '`readLevel` and a player of no other part',
    source: `import { composePlayer } from '${LIGHT}';
      export { readLevel } from '${LIGHT}';
      export const createPlayer = composePlayer();`,
    most: 41_000,
  },
  // 53.4 and 52.0 kB
  {
    what: '`readLevel` and a player of every part that the shipped levels call for',
    source: `import { composePlayer, ${PARTS.join(', ')} } from '${LIGHT}';
      export { readLevel } from '${LIGHT}';
      export const createPlayer = composePlayer([${PARTS.join(', ')}]);`,
    most: 54_500,
  },
  // 69.2 and 67.4 kB
  {
    what: '`readLevel` and `createPlayer` of `gravity-quest-toolkit/game`',
    source: "export { createPlayer, readLevel } from './game/index.ts';",
    most: 70_500,
  },
];

const SHIPPED = hashedRuns().filter(({ name }) => name.includes('.level.json: '));

const partsOf = ({ level }: (typeof SHIPPED)[number]): string =>
  PARTS.filter((part) => (part === 'recoil' ? level.recoil : (level[part as keyof typeof level] as unknown[]).length > 0)).join();

/** Runs of the shipped levels; in the quick set the first for each combination of parts, as one of them misses what is left out. */
const TRIED = isDeep ? SHIPPED : SHIPPED.filter((one, i) => SHIPPED.findIndex((other) => partsOf(other) === partsOf(one)) === i);

const BUNDLERS = [
  ['esbuild', byEsbuild],
  ['Vite', byVite],
] as const;

describe.each(someOf(BUNDLERS, 1))('bundled by %s', (_, bundle) => {
  test.each(LIMITS)('$what weighs at most $most bytes, gzipped, without zod', async ({ source, most }) => {
    const bundled = await bundle(source);
    expect(bundled.files.length).toBeGreaterThan(0);
    expect(bundled.files.filter((file) => file.includes('zod'))).toEqual([]);
    const bytes = zipped(bundled);
    expect(bytes).toBeLessThanOrEqual(most);
    // a limit that is far away finds nothing
    if (most > 1000) expect(bytes).toBeGreaterThan(0.9 * most);
  });

  test('what a level does not call for is not in the program that plays it', async () => {
    const { files } = await bundle(`import { composePlayer } from '${LIGHT}'; export const createPlayer = composePlayer();`);
    const others = ['aliens/aliens', 'repulsor/repulsor', 'repulsor/slide', 'winds/index', 'wormholes/index'];
    const absent = [...others.map((file) => `engine/effects/${file}.ts`), 'engine/motion/followers.ts', 'engine/box-index.ts'];
    expect(absent.filter((file) => !existsSync(new URL(`../../${file}`, import.meta.url)))).toEqual([]);
    expect(files.filter((file) => absent.includes(file))).toEqual([]);
  });

  test('the engine gives the committed hashes: leaving out what is not used leaves out nothing that is', async () => {
    const { compile, simulate, ACCURACIES } = (await run(
      await bundle("export { ACCURACIES, compile, simulate } from './engine/index.ts';"),
    )) as unknown as typeof Engine;
    const table = committedTable();
    const accuracies = Object.keys(ACCURACIES) as Engine.AccuracyName[];
    for (const { name, level, holds } of TRIED) {
      const hashes = accuracies.map((accuracy) => [accuracy, simulate(compile(level, accuracy), holds).hash]);
      expect([name, Object.fromEntries(hashes)]).toEqual([name, table[name]]);
    }
  });

  test('a light player gives the hashes of the complete one', async () => {
    const source = `import { composePlayer, ${PARTS.join(', ')} } from '${LIGHT}'; export const createLight = composePlayer([${PARTS.join(', ')}]);`;
    const { createLight } = (await run(await bundle(source))) as unknown as { createLight: typeof createPlayer };
    const hashOf = (player: Player) => {
      while (player.ending === null) player.advance(100);
      return player.hash;
    };
    for (const { name, level, holds: replay } of TRIED) {
      expect([name, hashOf(createLight(level, { replay }))]).toEqual([name, hashOf(createPlayer(level, { replay }))]);
    }
  });
});

test('nothing that the engine or the game imports is zod, used or not', async () => {
  const { files } = await byEsbuild("export * from './engine/index.ts'; export * from './game/index.ts';");
  expect(files.filter((file) => file.includes('node_modules')).map((file) => file.split('/')[1])).toEqual(
    expect.not.arrayContaining(['zod']),
  );
});

test('docs/library.md has these limits', () => {
  const page = readFileSync(new URL('../../docs/library.md', import.meta.url), 'utf8');
  const rows = LIMITS.map(({ what, most }) => [what, `${most / 1000} kB`]);
  const widths = [0, 1].map((i) => Math.max(...[['in a bundle', 'at most'], ...rows].map((row) => row[i].length)));
  const line = (cells: readonly string[]) => `| ${cells.map((cell, i) => cell.padEnd(widths[i])).join(' | ')} |`;
  const table = [line(['in a bundle', 'at most']), line(widths.map((width) => '-'.repeat(width))), ...rows.map(line)];
  expect(page).toContain(table.join('\n'));
});
