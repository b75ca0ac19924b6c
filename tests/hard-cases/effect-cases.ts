import type { Outcome } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { type PlainLevel, plainLevel } from '../engine/plain-level.ts';

/** A hard case without a closed form: the references with 32 digits know how it goes. */
export interface EffectCase {
  readonly name: string;
  readonly why: string;
  readonly level: Level;
  readonly holds: readonly Hold[];
  /** s */
  readonly maxTime: number;
  /**
   * The factor by which the case multiplies a small error of the start that leaves what happens as it is, rounded up: places and
   * times, px and s per px and px/s.
   */
  readonly sensitivity: number;
  /** How `fast` ends it where that is not the truth. */
  readonly fast?: Outcome;
}

interface Options extends Partial<Pick<EffectCase, 'holds' | 'maxTime' | 'fast'>> {
  readonly sensitivity: number;
}

/** The duration of a case unless it says otherwise, s. */
const SECONDS = 10;

const RANGE = 250;

function effectCase(name: string, why: string, parts: PlainLevel, options: Options): EffectCase {
  const maxTime = options.maxTime ?? SECONDS;
  // where she drifts, no range ends the run
  const isHeld = parts.asteroids !== undefined;
  const level = plainLevel(isHeld ? { range: RANGE, ...parts } : parts);
  return { holds: isHeld ? [[0, 60 * maxTime]] : [], ...options, name, why, level, maxTime };
}

const rock = (x: number, y: number, radius = 16, hot = false) => ({ x, y, radius, hot });
const disc = (x: number, y: number, radius: number) => ({ x, y, radius });
const wind = (x: number, y: number, radius: number, ax: number, ay: number) => ({ x, y, radius, ax, ay });
const wormhole = (x: number, y: number, toX: number, toY: number, radius: number) => ({ x, y, toX, toY, radius });

const speedLimit = (): EffectCase[] => [
  effectCase(
    'both axes reach the limit at once',
    'a wind drives both axes to the limit in the same instant, then the gun takes one back',
    {
      rules: { speedLimit: 60 },
      range: 400,
      astronaut: { vx: 20, vy: 20 },
      asteroids: [rock(250, 60)],
      winds: [wind(80, 80, 200, 20, 20)],
      blackHole: disc(428, 343, 10),
    },
    { holds: [[150, 600]], sensitivity: 10 },
  ),
  effectCase(
    'released at the limit, in a wind, with recoil',
    'she is let go while an axis is at the limit: the wind frees it, and her target drifts on',
    {
      recoil: true,
      rules: { speedLimit: 60 },
      range: 600,
      asteroids: [rock(200, 30, 4)],
      winds: [wind(0, 0, 600, 5, -10)],
      novae: [disc(356, -47, 5)],
    },
    {
      holds: [
        [0, 150],
        [240, 400],
      ],
      sensitivity: 10,
    },
  ),
  effectCase(
    'starts at the limit',
    'the pull first drives an axis that is at the limit from the start, then brakes it',
    {
      rules: { speedLimit: 50 },
      astronaut: { vx: 50 },
      asteroids: [rock(30, 80)],
      novae: [disc(83, 114, 10)],
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'both axes start at the limit',
    'one axis is freed at once, the other one held until she has passed the asteroid',
    {
      rules: { speedLimit: 40 },
      astronaut: { vx: 40, vy: -40 },
      asteroids: [rock(60, 80)],
      blackHole: disc(153, -25, 10),
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'the limit in a field',
    'pushed to the limit by a field, then pulled through it again',
    {
      rules: { speedLimit: 30 },
      astronaut: { x: 10, y: 20 },
      asteroids: [rock(200, 0)],
      repulsors: [disc(0, 0, 100)],
      blackHole: disc(152, 166, 10),
    },
    { holds: [[200, 600]], sensitivity: 20 },
  ),
  effectCase(
    'a limit of 10',
    'she is at the limit most of the time, along one axis or both',
    {
      rules: { speedLimit: 10 },
      astronaut: { vx: 10, vy: -10 },
      asteroids: [rock(30, 40)],
      blackHole: disc(25, 64, 5),
    },
    { maxTime: 12, sensitivity: 10 },
  ),
];

const winds = (): EffectCase[] => [
  effectCase(
    'two winds that cancel',
    'where they overlap nothing is left of either, and each rim is crossed while she is pulled',
    {
      astronaut: { vx: 50 },
      asteroids: [rock(150, 120)],
      winds: [wind(100, 10, 60, 30, 40), wind(160, 10, 60, -30, -40)],
      blackHole: disc(293, 156, 10),
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'as strong as the pull',
    'at one place in the wind it cancels the pull, and near it little is left of either',
    {
      range: 200,
      astronaut: { vx: 31, vy: 7 },
      asteroids: [rock(160, -80)],
      winds: [wind(100, 0, 50, -11.7, 15.6)],
      novae: [disc(230, -114, 5)],
    },
    { sensitivity: 20 },
  ),
  effectCase(
    'blown against the pull',
    'she enters a wind that throws her out again: what is off at the rim grows 400 times',
    {
      range: 400,
      astronaut: { y: 30, vx: 40 },
      asteroids: [rock(0, 200)],
      winds: [wind(0, 160, 100, 0, -100)],
      novae: [disc(-20, 10, 5)],
    },
    { sensitivity: 500 },
  ),
  effectCase(
    'a rim grazed from within',
    'her swing cuts a wind by a seventh of a pixel, which throws her out at once',
    { range: 400, astronaut: { vx: 40 }, asteroids: [rock(60, 80)], winds: [wind(114, 159, 10, 100, 0)] },
    { sensitivity: 100 },
  ),
  effectCase(
    'a rim crossed once',
    'her orbit dips into a wind by a fortieth of a pixel and is thrown out: with a small error it hangs on the rim',
    { astronaut: { vy: 30 }, asteroids: [rock(100, 0)], winds: [wind(145, -41, 40, 100, 0)] },
    { sensitivity: 20 },
  ),
  effectCase(
    'a rim at the tick of the press',
    'she enters the wind in the very instant in which the gun begins to pull',
    {
      astronaut: { vx: 100 },
      asteroids: [rock(100, 90)],
      winds: [wind(200, 0, 100, 0, 60)],
      novae: [disc(246, 146, 5)],
    },
    { holds: [[60, 200]], maxTime: 8, sensitivity: 10 },
  ),
];

const wormholes = (): EffectCase[] => [
  effectCase(
    'two wormholes with one exit',
    'she comes out in the mouth of another wormhole, which must not take her',
    {
      range: 400,
      astronaut: { vx: 90 },
      asteroids: [rock(300, 90)],
      wormholes: [wormhole(100, 0, 400, 0, 20), wormhole(200, 200, 400, 0, 20)],
      blackHole: disc(633, 44, 10),
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'the exit lies on a rim',
    'she comes out on the rim of another mouth, moves into it, and must not be taken',
    {
      range: 400,
      astronaut: { vx: 90 },
      asteroids: [rock(300, 100)],
      wormholes: [wormhole(100, 0, 300, 0, 10), wormhole(310, 0, 100, 200, 20)],
      blackHole: disc(538, 75, 10),
    },
    { sensitivity: 20 },
  ),
  effectCase(
    'into a field, to another target',
    'the jump changes at once what pulls, what pushes and where her box points',
    {
      range: 400,
      astronaut: { vx: 60 },
      asteroids: [rock(60, 120), rock(420, 100)],
      repulsors: [disc(400, 0, 50)],
      wormholes: [wormhole(90, 20, 400, 10, 24)],
      novae: [disc(477, 103, 5)],
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'a mouth clipped',
    'her swing clips the rim of a mouth: a fifth of a pixel farther out, and she stays where she is',
    { range: 400, astronaut: { vx: 40 }, asteroids: [rock(60, 80)], wormholes: [wormhole(114, 159, 314, 159, 10)] },
    { sensitivity: 100 },
  ),
  effectCase(
    'a mouth missed',
    'her orbit passes the rim of a mouth by a tenth of a pixel',
    { astronaut: { vy: 30 }, asteroids: [rock(100, 0)], wormholes: [wormhole(192, 43, 392, 43, 40)] },
    { sensitivity: 10 },
  ),
  effectCase(
    'shuttles between two mouths',
    'she falls to and fro through both mouths and the centre, and what is off grows 350 times',
    { range: 400, asteroids: [rock(100, 0)], wormholes: [wormhole(150, 0, 50, 0, 10)] },
    { sensitivity: 400 },
  ),
  effectCase(
    'arrives touching a nova',
    'the side of her box touches it in the instant of the jump, and would have left it before the next frame',
    {
      astronaut: { vx: 594, vy: 792 },
      wormholes: [wormhole(300, 400, 1000, 0, 50)],
      novae: [disc(981, -53, 1)],
    },
    { maxTime: 3, sensitivity: 2 },
  ),
];

const recoil = (): EffectCase[] => [
  effectCase(
    'a hot asteroid drawn onto her',
    'she brakes, but what she pulls comes',
    { recoil: true, rules: { recoil: 600 }, astronaut: { vx: -20 }, asteroids: [rock(150, 0, 6, true)] },
    { sensitivity: 10 },
  ),
  effectCase(
    'a hot asteroid drawn past her',
    'it swings about her as she about it, and sweeps her towards a nova',
    {
      recoil: true,
      rules: { recoil: 300 },
      astronaut: { vy: 30 },
      asteroids: [rock(150, 0, 10, true)],
      novae: [disc(119, 83, 5)],
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'two asteroids as near as each other',
    'the first one pulls, is drawn along, and so stays the nearest',
    {
      recoil: true,
      rules: { recoil: 200 },
      astronaut: { vy: 40 },
      asteroids: [rock(-100, 0, 10), rock(100, 0, 10)],
      novae: [disc(-97, 96, 10)],
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'a light asteroid',
    'the asteroid falls faster than she does: a step of the one is wrong about the place of the other',
    {
      recoil: true,
      rules: { recoil: 1000 },
      astronaut: { vy: 40 },
      asteroids: [rock(100, 0, 4)],
      blackHole: disc(36, 114, 5),
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'released and caught again',
    'the asteroid drifts on while she does not pull, and is another one when she does',
    {
      recoil: true,
      rules: { recoil: 500 },
      astronaut: { vy: 40 },
      asteroids: [rock(120, 0, 5)],
      blackHole: disc(224, 169, 5),
    },
    {
      holds: [
        [0, 120],
        [180, 360],
      ],
      sensitivity: 20,
    },
  ),
  effectCase(
    'the range moves along',
    'the asteroid drifts after her a little too slowly: she is lost almost ten seconds after the release',
    { recoil: true, rules: { recoil: 800 }, range: 150, astronaut: { vx: -51 }, asteroids: [rock(100, 0, 10)] },
    { holds: [[0, 60]], maxTime: 15, sensitivity: 50 },
  ),
  effectCase(
    'past a centre that moves',
    'they pass each other so closely that the pull turns round between two ticks',
    {
      recoil: true,
      rules: { recoil: 100 },
      astronaut: { vy: 0.01 },
      asteroids: [rock(100, 0, 10)],
      novae: [disc(82, -22, 5)],
    },
    { sensitivity: 20 },
  ),
];

const chases = (): EffectCase[] => [
  effectCase(
    'caught at last',
    'after nine seconds a chaser only just reaches her',
    { range: 400, astronaut: { vy: 40 }, asteroids: [rock(100, 0)], aliens: [disc(0, -80, 15)] },
    { sensitivity: 10 },
  ),
  effectCase(
    'just escapes',
    'she passes an alien by a quarter of a pixel while both are pulled',
    { range: 400, astronaut: { vx: 20, vy: 30 }, asteroids: [rock(60, 80)], aliens: [disc(120, 0, 10)] },
    { sensitivity: 10 },
  ),
  effectCase(
    'two chasers meet',
    'whether two aliens touch hangs on where she was all the time before',
    { range: 400, astronaut: { vx: 30 }, asteroids: [rock(60, 80)], aliens: [disc(0, 60, 10), disc(-60, 120, 10)] },
    { sensitivity: 10 },
  ),
  effectCase(
    'falls asleep at its sight',
    'it stops dead where she leaves its sight, and lies there when she comes back',
    {
      astronaut: { vx: 60 },
      asteroids: [rock(200, 60)],
      aliens: [disc(0, 130, 25)],
      novae: [disc(319, 199, 10)],
    },
    { holds: [[120, 600]], sensitivity: 10 },
  ),
  effectCase(
    'falls through her orbit',
    'a small alien that is strongly pulled wakes, falls past her and falls asleep, and she passes a nova by a sixth of a pixel',
    {
      rules: { alienPull: 40 },
      astronaut: { vy: 30 },
      asteroids: [rock(30, 0)],
      aliens: [disc(0, 140, 1)],
      novae: [disc(42, -3, 5)],
    },
    { sensitivity: 10 },
  ),
];

const rules = (): EffectCase[] => [
  effectCase(
    'a pull of 1000',
    'up to 6 px of way in each tick',
    { rules: { pull: 1000 }, astronaut: { vy: 60 }, asteroids: [rock(100, 0)], novae: [disc(155, -76, 5)] },
    { maxTime: 5, sensitivity: 20 },
  ),
  effectCase(
    'a pull of 1000, close by',
    'she passes the centre within a pixel, at more than 4 px a tick',
    { rules: { pull: 1000 }, astronaut: { vy: 5 }, asteroids: [rock(40, 0)], novae: [disc(59, -40, 10)] },
    { maxTime: 4, sensitivity: 20 },
  ),
  effectCase(
    'a pull of 1',
    'half a minute of slow orbit, in which a nova is passed by a thirtieth of a pixel',
    { rules: { pull: 1 }, astronaut: { vy: 5 }, asteroids: [rock(30, 40)], novae: [disc(92, 87, 5)] },
    { maxTime: 30, sensitivity: 10 },
  ),
  effectCase(
    'a push of 1000',
    'the push turns her from one direction to another within a tenth of a second',
    {
      rules: { push: 1000 },
      astronaut: { vx: 300, vy: 10 },
      repulsors: [disc(100, 0, 40)],
      blackHole: disc(216, 89, 5),
    },
    { maxTime: 3, sensitivity: 30 },
  ),
  effectCase(
    'a range of 60',
    'she is lost a moment after she would have reached the black hole',
    { range: 60, astronaut: { vy: 35 }, asteroids: [rock(40, 0, 8)], blackHole: disc(-14, 60, 10) },
    { sensitivity: 10 },
  ),
  effectCase(
    'a range of 2',
    'the whole orbit is smaller than her box, which turns with it and sweeps over what is near',
    { range: 2, astronaut: { vy: 2 }, asteroids: [rock(1, 0, 8)], novae: [disc(9, -23, 5)] },
    { maxTime: 4, sensitivity: 20 },
  ),
  effectCase(
    'a box of 1 px',
    'box and nova together are 3 px wide, and she makes 8 px a tick',
    { rules: { boxWidth: 1, boxHeight: 1 }, astronaut: { vx: 500 }, novae: [disc(304, 0, 1)] },
    { maxTime: 2, sensitivity: 2 },
  ),
  effectCase(
    'a box of 200 px',
    'a long, thin box sweeps over a nova as she passes the asteroid, faster than box and nova are wide',
    {
      rules: { boxWidth: 200, boxHeight: 2 },
      range: 300,
      astronaut: { x: -80, vx: 60 },
      asteroids: [rock(0, 8)],
      novae: [disc(-80, 40, 0.5)],
    },
    { maxTime: 4, sensitivity: 10 },
  ),
  effectCase(
    'a sight of 10,000 px',
    'the chaser is awake from the start, comes fast from afar, and only just reaches her',
    {
      rules: { alienSight: 10_000, alienPull: 60 },
      astronaut: { vy: 30 },
      asteroids: [rock(80, 0)],
      aliens: [disc(300, 200, 10)],
    },
    { sensitivity: 10 },
  ),
];

const mixtures = (): EffectCase[] => [
  effectCase(
    'wind, limit, recoil and an alien',
    'the target is drawn through the wind after her, and the limit holds only her',
    {
      recoil: true,
      rules: { speedLimit: 60, recoil: 100 },
      astronaut: { vy: -30 },
      asteroids: [rock(120, 0, 10)],
      winds: [wind(100, 0, 80, 0, 30)],
      aliens: [disc(0, 140, 25)],
      blackHole: disc(209, 133, 10),
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'wind, wormhole and field',
    'blown into a mouth, out of it into a field, and pulled all the time',
    {
      range: 400,
      astronaut: { vx: 70 },
      asteroids: [rock(150, 100)],
      winds: [wind(80, 0, 50, 0, -40)],
      repulsors: [disc(250, 0, 60)],
      wormholes: [wormhole(120, 0, 250, 20, 24)],
      novae: [disc(439, 1, 5)],
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'two targets, recoil and a field',
    'inside the field the gun only draws the asteroids, which decides which of them is the nearest afterwards',
    {
      recoil: true,
      rules: { recoil: 200 },
      astronaut: { vx: 50 },
      asteroids: [rock(60, 80), rock(160, -70, 10)],
      repulsors: [disc(110, 10, 30)],
      blackHole: disc(178, 144, 5),
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'limit, wormhole, recoil and wind',
    'what is off before the jump is off behind it, where the limit holds one axis and not the other',
    {
      recoil: true,
      rules: { speedLimit: 50, recoil: 200 },
      range: 400,
      astronaut: { vy: 40 },
      asteroids: [rock(100, 0, 10)],
      wormholes: [wormhole(60, 60, 150, -60, 20)],
      winds: [wind(100, 0, 200, 5, 5)],
      blackHole: disc(145, 97, 10),
    },
    { sensitivity: 10 },
  ),
  effectCase(
    'everything',
    'limit, recoil, two targets, a field, a wind, a wormhole, a chaser and a mineral',
    {
      recoil: true,
      rules: { speedLimit: 70, recoil: 100, push: 60 },
      range: 400,
      astronaut: { vx: 30, vy: 30 },
      asteroids: [rock(120, 0, 10), rock(-100, 100)],
      repulsors: [disc(60, 30, 20)],
      winds: [wind(150, 60, 60, 20, -20)],
      wormholes: [wormhole(240, 0, -60, 60, 20)],
      aliens: [disc(100, 150, 20)],
      minerals: [disc(200, 40, 7)],
      blackHole: disc(-24, -2, 5),
    },
    { sensitivity: 10 },
  ),
];

/** The hard cases for effects and rules without closed forms, by family. Each call makes a new table. */
export const effectFamilies = () => ({
  speedLimit: speedLimit(),
  winds: winds(),
  wormholes: wormholes(),
  recoil: recoil(),
  chases: chases(),
  rules: rules(),
  mixtures: mixtures(),
});

/** All of them. */
export const effectCases = (): EffectCase[] => Object.values(effectFamilies()).flat();
