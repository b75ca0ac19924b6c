import { compile, simulate } from '../engine/index.ts';
import { type Level, resolveLevel } from '../schema/index.ts';
import { hashRandomSet, layoutOf, RANDOM_SET_HASH, RANDOM_SET_SIZE, randomLevel } from '../tests/scenes/random-set/index.ts';
import { askedEffort, decideAll, refuteSome, type Stratum, tell } from './decide/index.ts';
import { optionValue } from './harness.ts';
import { hashStyledSet, STYLED_SET_HASH, STYLED_SET_SIZE, STYLES, styledLevel, styleOf } from './styled-set/index.ts';

/** The strata of either set. */
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

const SETS = {
  random: {
    size: RANDOM_SET_SIZE,
    hash: RANDOM_SET_HASH,
    hashNow: hashRandomSet,
    level: randomLevel,
    goal: 0.97,
    strata: (['scattered', 'chained'] as const).map(
      (layout): Stratum => [layout, ({ name }) => layoutOf(Number(name)) === layout],
    ),
  },
  styled: {
    size: STYLED_SET_SIZE,
    hash: STYLED_SET_HASH,
    hashNow: hashStyledSet,
    level: styledLevel,
    goal: 0.95,
    strata: STYLES.map((style): Stratum => [style, ({ name }) => styleOf(Number(name)) === style]),
  },
};

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

const named = optionValue('--set') ?? 'random';
if (!(named in SETS)) throw new RangeError(`--set: expected random or styled, found ${named}`);
const set = SETS[named as keyof typeof SETS];
const from = Number(optionValue('--from') ?? 0);
const count = Number(optionValue('--levels') ?? set.size);
const seeds =
  optionValue('--seeds')?.split(',').map(Number) ?? Array.from({ length: Math.min(count, set.size - from) }, (_, i) => from + i);
const { effort, refute, refuteEffort, jobs } = askedEffort(5_000_000);

const hash = set.hashNow();
if (hash !== set.hash) throw new Error(`the ${named} set has changed: expected ${set.hash}, found ${hash}`);
const levels = seeds.map((seed) => ({ name: String(seed), level: resolveLevel(set.level(seed)) }));
const decisions = await decideAll(levels, effort, jobs);
tell(levels, refute > 0 ? await refuteSome(levels, decisions, refute, refuteEffort, jobs) : decisions, {
  title: `The ${named} set: decided at ${effort.accuracy} with ${effort.budget} ticks a level`,
  strata: [...STRATA, ...set.strata],
  goal: set.goal,
});
