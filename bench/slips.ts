import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { importOriginal, type LevelFile, readLevel, resolveLevel } from '../schema/index.ts';
import { askedEffort, decideAll, refuteSome, tell } from './decide/index.ts';
import { optionValue } from './harness.ts';
import { SLIPS, slipped } from './slips/slip.ts';

const SHIPPED = fileURLToPath(new URL('../../levels/', import.meta.url));

/** The level files of a folder by name. */
function shipped(): [name: string, level: LevelFile][] {
  const files = readdirSync(SHIPPED).filter((file) => file.endsWith('.level.json'));
  return files.sort().map((file) => {
    const read = readLevel(readFileSync(join(SHIPPED, file)));
    if (!read.ok) throw new Error(`expected a valid level in ${file}: ${read.problems[0].message}`);
    return [file.replace('.level.json', ''), read.document.file];
  });
}

/** The level files in a file of the original game, with recoil as there. */
function originals(file: string): [name: string, level: LevelFile][] {
  const imported = importOriginal(readFileSync(file), { recoil: optionValue('--recoil') !== 'off' });
  if (!imported.ok) throw new Error(`expected the original's levels in ${file}: ${imported.problems[0].message}`);
  return imported.levels.map(({ slug, file: level }) => [slug, level]);
}

const original = optionValue('--originals');
const sources = [...shipped(), ...(original === null ? [] : originals(original))];
const only = optionValue('--only')?.split(',');
const seed = Number(optionValue('--seed') ?? 0);
const levels = sources
  .flatMap(([source, level], i) =>
    SLIPS.map((slip) => ({ name: `${source}: ${slip}`, level: resolveLevel(slipped(level, slip, i + 1000 * seed)) })),
  )
  .filter(({ name }) => only === undefined || only.some((part) => name.includes(part)));

const { effort, refute, refuteEffort, jobs } = askedEffort(5_000_000);
const decisions = await decideAll(levels, effort, jobs);
tell(levels, refute > 0 ? await refuteSome(levels, decisions, refute, refuteEffort, jobs) : decisions, {
  title: `Copies of ${sources.length} levels with one slip each: decided at ${effort.accuracy} with ${effort.budget} ticks a level`,
  strata: [
    ['all', () => true],
    ...SLIPS.map((slip) => [slip, ({ name }: { name: string }) => name.endsWith(`: ${slip}`)] as const),
    ['recoil', ({ level }) => level.recoil],
    ['starts moving', ({ level: { astronaut } }) => astronaut.vx !== 0 || astronaut.vy !== 0],
  ],
  goal: 0.99,
});
