import { compile, DEFAULT_ACCURACY, simulate } from '../engine/index.ts';
import { type Level, resolveLevel } from '../schema/index.ts';
import { hashRandomSet, layoutOf, RANDOM_SET_HASH, RANDOM_SET_SIZE, randomLevel } from '../tests/scenes/random-set/index.ts';
import { SLIPS, slipped } from '../tests/scenes/slips.ts';
import {
  hashStyledSet,
  STYLED_SET_HASH,
  STYLED_SET_SIZE,
  STYLES,
  styledLevel,
  styleOf,
} from '../tests/scenes/styled-set/index.ts';
import { decideAll, type Effort, refuteSome, type Stratum, tell } from './decide/index.ts';
import {
  accuracy,
  atMost,
  define,
  type NamedFile,
  type NamedLevel,
  number,
  numbers,
  oneOf,
  originalFiles,
  packFiles,
  text,
  words,
} from './harness/index.ts';

/** The strata of the random and the styled set. */
const STRATA: readonly Stratum[] = [
  ['all', () => true],
  ['not over at once', ({ level }) => goesOn(level)],
  ['5 to 30 novae', ({ level: { novae } }) => novae.length >= 5 && novae.length <= 30],
  ['31 to 60 novae', ({ level: { novae } }) => novae.length > 30 && novae.length <= 60],
  ['61 to 90 novae', ({ level: { novae } }) => novae.length > 60 && novae.length <= 90],
  ['91 to 120 novae', ({ level: { novae } }) => novae.length > 90],
  ['1 to 3 asteroids', ({ level: { asteroids } }) => asteroids.length <= 3],
  ['4 to 8 asteroids', ({ level: { asteroids } }) => asteroids.length > 3 && asteroids.length <= 8],
  ['9 to 15 asteroids', ({ level: { asteroids } }) => asteroids.length > 8],
  ['aliens', ({ level: { aliens } }) => aliens.length > 0],
  ['no aliens', ({ level: { aliens } }) => aliens.length === 0],
  ['repulsors', ({ level: { repulsors } }) => repulsors.length > 0],
  ['hot asteroids', ({ level: { asteroids } }) => asteroids.some(({ hot }) => hot)],
  ['recoil', ({ level: { recoil } }) => recoil],
  ['starts at rest', ({ level: { astronaut } }) => astronaut.vx === 0 && astronaut.vy === 0],
  ['starts moving', ({ level: { astronaut } }) => astronaut.vx !== 0 || astronaut.vy !== 0],
  ['under 500,000 px2', ({ level }) => areaOf(level) < 500_000],
  ['500,000 px2 and more', ({ level }) => areaOf(level) >= 500_000],
];

/** Whether she survives the first tick, with the gun held or not. */
function goesOn(level: Level): boolean {
  const { asteroids, astronaut, range } = level;
  const inRange = asteroids.some(({ x, y }) => (x - astronaut.x) ** 2 + (y - astronaut.y) ** 2 <= range ** 2);
  const scene = compile(level);
  return inRange && [[], [[0, 60]] as const].some((holds) => simulate(scene, holds, { maxTime: 1 / 60 }).outcome === 'timeout');
}

/** Area of the bounding box of all objects, px². */
function areaOf({ astronaut, blackHole, asteroids, novae }: Level): number {
  const all = [astronaut, blackHole, ...asteroids, ...novae];
  const span = (values: number[]) => Math.max(...values) - Math.min(...values);
  return span(all.map(({ x }) => x)) * span(all.map(({ y }) => y));
}

/**
 * The levels of a frozen set with these numbers.
 * @throws {Error} if the set has changed: then figures cannot be compared
 */
function frozen(name: string, made: string, hash: string, level: (seed: number) => NamedFile['file'], seeds: readonly number[]) {
  if (made !== hash) throw new Error(`the ${name} set has changed: expected ${hash}, found ${made}`);
  return seeds.map((seed) => ({ name: String(seed), level: resolveLevel(level(seed)) }));
}

/** Copies of levels with one slip of a designer each. */
const slips = (sources: readonly NamedFile[], seed: number): NamedLevel[] =>
  sources.flatMap(({ name, file }, i) =>
    SLIPS.map((slip) => ({ name: `${name}: ${slip}`, level: resolveLevel(slipped(file, slip, i + 1000 * seed)) })),
  );

const OPTIONS = {
  set: oneOf(['random', 'styled', 'slips'] as const, 'random', 'the levels'),
  from: number(0, 'the first level of the random or the styled set'),
  levels: number(null, 'how many of that set; all when left out'),
  seeds: numbers(null, 'some levels of that set'),
  originals: text("a file of the original game's levels that get slips, too"),
  recoil: oneOf(['on', 'off'] as const, 'on', 'whether these have recoil'),
  seed: number(0, 'of the slips'),
  only: words('levels whose names contain one of these'),
  accuracy: accuracy(DEFAULT_ACCURACY),
  budget: number(5_000_000, 'ticks of search and proofs for a level'),
  refute: number(0, 'levels proved impossible that are searched afterwards'),
  refuteSeconds: number(60, 'processor time for each of these'),
  jobs: number(1, 'threads'),
};

export const bench = define({
  what: 'how many of 2,000 random levels are solved or proved impossible, of 300 styled ones, or of copies of the shipped ones with a slip; over 15 minutes',
  options: OPTIONS,
  claims: {
    random: atMost(0.03, 'random levels undecided, share'),
    styled: atMost(0.05, 'styled levels undecided, share'),
    slips: atMost(0.01, 'levels with a slip undecided, share'),
    wrong: atMost(0, 'proofs refuted or not verified'),
  },
  async run({
    set,
    from,
    levels: count,
    seeds,
    originals,
    recoil,
    seed,
    only,
    accuracy: name,
    budget,
    refute,
    refuteSeconds,
    jobs,
  }) {
    const size = set === 'styled' ? STYLED_SET_SIZE : RANDOM_SET_SIZE;
    const chosen = seeds ?? Array.from({ length: Math.min(count ?? size, size - from) }, (_, i) => from + i);
    const sources = [...packFiles(), ...(originals === null ? [] : originalFiles(originals, recoil === 'on'))];
    const made = {
      random: () => frozen('random', hashRandomSet(), RANDOM_SET_HASH, randomLevel, chosen),
      styled: () => frozen('styled', hashStyledSet(), STYLED_SET_HASH, styledLevel, chosen),
      slips: () => slips(sources, seed),
    }[set]();
    const levels = made.filter((level) => only === null || only.some((part) => level.name.includes(part)));
    const strata: Record<typeof set, readonly Stratum[]> = {
      random: [
        ...STRATA,
        ...(['scattered', 'chained'] as const).map((one): Stratum => [one, (l) => layoutOf(Number(l.name)) === one]),
      ],
      styled: [...STRATA, ...STYLES.map((style): Stratum => [style, (l) => styleOf(Number(l.name)) === style])],
      slips: [
        ['all', () => true],
        ...SLIPS.map((slip): Stratum => [slip, (l) => l.name.endsWith(`: ${slip}`)]),
        ['recoil', ({ level }) => level.recoil],
        ['starts moving', ({ level: { astronaut } }) => astronaut.vx !== 0 || astronaut.vy !== 0],
      ],
    };
    const effort: Effort = { accuracy: name, budget, refuteMs: 0 };
    const decided = await decideAll(levels, effort, jobs);
    const harder = { ...effort, refuteMs: 1000 * refuteSeconds };
    const decisions = refute > 0 ? await refuteSome(levels, decided, refute, harder, jobs) : decided;
    const { undecided, wrong, ...told } = tell(levels, decisions, strata[set]);
    const what = set === 'slips' ? `Copies of ${sources.length} levels with one slip each` : `The ${set} set`;
    return {
      ...told,
      title: `${what}: decided at ${name} with ${budget} ticks a level`,
      measured: { random: null, styled: null, slips: null, [set]: undecided, wrong },
    };
  },
});
