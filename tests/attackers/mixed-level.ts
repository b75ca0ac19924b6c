import { type Level, type OwnRules, RULE_NAMES, RULES, rulesOf } from '../../schema/index.ts';
import { randomScene } from '../scenes/random-scene.ts';
import { seeded } from '../scenes/seeded.ts';
import { windyScene } from '../scenes/windy-scene.ts';
import { ownRules } from './own-rules.ts';
import { levelFor, type Prover } from './styles.ts';
import { withWindsAndWormholes } from './winds-and-wormholes.ts';

/** The styles of levels, those for which sets are followed more often. */
const BASES: readonly (Prover | 'random' | 'windy')[] = [
  'doomed',
  'doomed',
  'flowpipe',
  'flowpipe',
  'orbits',
  'orbits',
  'orbits',
  'line-trap',
  'line-trap',
  'dead-end',
  'enclosed',
  'covered',
  'out-of-range',
  'starts-in-hazard',
  'random',
  'windy',
];

/** Her speed at the start as shares of the speed limit: about where provers stop following her, and about the limit itself. */
const SHARES = [0.05, 0.2, 0.45, 0.499, 0.501, 0.55, 0.6, 0.7, 0.705, 0.709, 0.9, 0.99, 1];

/**
 * A level of any style, from a seed. What the styles keep apart is mixed: rules over the whole range that a level may have, low
 * speed limits and starts close to them, recoil, winds, and wormholes that share an exit.
 */
export function mixedLevel(seed: number): Level {
  const random = seeded(seed * 1619 + 11);
  const chance = (p: number) => random() < p;
  const pick = <T>(...of: readonly T[]): T => of[Math.floor(random() * of.length)];
  const base = pick(...BASES);
  let level = base === 'random' ? randomScene(seed).level : base === 'windy' ? windyScene(seed).level : levelFor(base, random);
  const kind = random();
  if (kind > 0.4) level = { ...level, rules: kind > 0.8 ? anyRules(random) : ownRules(random) };
  if (chance(0.35)) level = withWindsAndWormholes(level, random);
  if (chance(0.15) && level.wormholes.length > 0)
    level = { ...level, wormholes: [...level.wormholes, sharingExit(level, random)] };
  if (chance(0.2)) level = { ...level, winds: [...level.winds, windAbout(level, random)] };
  if (chance(0.25)) level = { ...level, recoil: !level.recoil };
  if (chance(0.4)) level = atSpeed(level, pick(...SHARES), random);
  return level;
}

/** Rules from anywhere within what a level may have: its ends, and everything between on a logarithmic scale. */
function anyRules(random: () => number): OwnRules {
  return Object.fromEntries(
    RULE_NAMES.map((name) => {
      const { least, most, default: usual } = RULES[name];
      const from = Math.max(least, most / 1e4);
      const kind = random();
      return [name, kind < 0.3 ? usual : kind < 0.35 ? least : kind < 0.4 ? most : from * (most / from) ** random()];
    }),
  );
}

/** The level with a start at a share of the speed limit: the start is changed, or the limit of the level. */
function atSpeed(level: Level, share: number, random: () => number): Level {
  const { vx, vy } = level.astronaut;
  const { speedLimit } = rulesOf(level);
  const now = Math.hypot(vx, vy);
  const { least, most } = RULES.speedLimit;
  if (now > 0 && random() < 0.5) {
    const limit = Math.min(most, Math.max(least, now / share));
    return { ...level, rules: { ...level.rules, speedLimit: limit } };
  }
  const turn = 6.2832 * random();
  const [ux, uy] = now > 0 ? [vx / now, vy / now] : [Math.cos(turn), Math.sin(turn)];
  // an axis may not be faster than the limit
  const speed = (share * speedLimit) / Math.max(1, Math.abs(ux), Math.abs(uy));
  return { ...level, astronaut: { ...level.astronaut, vx: speed * ux, vy: speed * uy } };
}

/** A wormhole that ends where one of the level's own does. */
function sharingExit({ wormholes, astronaut }: Level, random: () => number): Level['wormholes'][number] {
  const { toX, toY, radius } = wormholes[Math.floor(random() * wormholes.length)];
  const near = () => 200 * (random() - 0.5);
  return { id: null, x: astronaut.x + near(), y: astronaut.y + near(), toX, toY, radius };
}

/** A wind about the start or beside it. */
function windAbout({ astronaut }: Level, random: () => number): Level['winds'][number] {
  const far = random() < 0.5 ? 0 : 120 * random();
  const turn = 6.2832 * random();
  const strength = () => (random() < 0.3 ? 100 : 30) * (2 * random() - 1);
  return {
    id: null,
    x: astronaut.x + far * Math.cos(turn),
    y: astronaut.y + far * Math.sin(turn),
    radius: 20 + 130 * random(),
    ax: strength(),
    ay: strength(),
  };
}
