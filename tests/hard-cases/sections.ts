import { CASE_SECONDS, type HardCase, hardFamilies } from './cases.ts';
import { type EffectCase, effectFamilies } from './effect-cases.ts';

/** A case as docs/hard-cases.md lists it. */
export type PageCase = Pick<EffectCase, 'name' | 'why' | 'level' | 'holds' | 'maxTime'>;

/** A section of docs/hard-cases.md. */
export interface Section {
  readonly title: string;
  /** Part of the name of the picture's file. */
  readonly slug: string;
  /** What is hard, what a naive engine does, what this one does. */
  readonly about: readonly [hard: string, naive: string, ours: string];
  readonly cases: readonly PageCase[];
  /** The name of the case that is drawn. */
  readonly drawn: string;
}

const timed = (cases: readonly HardCase[]): PageCase[] => cases.map((c) => ({ ...c, maxTime: c.maxTime ?? CASE_SECONDS }));

/** The page, section by section. */
export function sections(): Section[] {
  const known = hardFamilies();
  const effects = effectFamilies();
  return [
    {
      title: 'Falls through the centre',
      slug: 'falls',
      about: [
        'From rest she falls straight through the centre of the asteroid, where the direction of the pull jumps.',
        'A step across the centre pulls in the old direction for too long, and each pass adds to the error.',
        'On a line through the centre the motion is a sum of exponentials, and the pass is an event: exact, without small steps.',
      ],
      cases: timed(known.falls),
      drawn: 'fall 249.9',
    },
    {
      title: 'Close passes',
      slug: 'near-radial',
      about: [
        'The closer she passes the centre, the faster the pull turns round: in far less than a tick.',
        'A step of a tick sees the pull on one side only, and she leaves in another direction.',
        'A Taylor series is only as long as its convergence allows: steps shrink near the centre and grow again behind it.',
      ],
      cases: timed([...known.nearRadials, ...known.scaled]),
      drawn: 'near-radial 0.1',
    },
    {
      title: 'Ties',
      slug: 'ties',
      about: [
        'Two asteroids are equally near, so that the rules of preference decide, and not the last digit.',
        'What compares rounded distances takes the one or the other by chance; the naive engine here has the rules, and only its steps are off.',
        'Where distances are equal as far as rounding can tell, cold asteroids come before hot ones, then the order of the file.',
      ],
      cases: timed(known.ties),
      drawn: 'bisector glide',
    },
    {
      title: 'Grazes',
      slug: 'grazes',
      about: [
        'A contact is missed, or happens, by a thousandth to a billionth of a pixel, at any speed.',
        'Tests once a frame skip what she touches between two frames, if it is thin or only clipped and she is fast; drifting slowly, the naive engine is right.',
        'Contacts are guards along the whole way of the turning box, with a step that cannot jump over one.',
      ],
      cases: timed([...known.grazes, ...known.fast]),
      drawn: '990 px/s, radius 0.5, -0.02',
    },
    {
      title: 'Simultaneous events',
      slug: 'simultaneous',
      about: [
        'Two things happen in the same instant, or a billionth of a second apart.',
        'Within a frame all is at once, and a fixed order decides what only came later.',
        'Events have times, and only for one instant there is an order: a hazard wins over the black hole.',
      ],
      cases: timed(known.simultaneous),
      drawn: 'black hole before nova by 0.000001 s',
    },
    {
      title: 'Fields',
      slug: 'fields',
      about: [
        'A field replaces the pull at once, and where the gun pulls her in and the push drives her out, she slides on the rim.',
        'On the rim, which both forces drive her to, the naive engine does not slide, and ends far away.',
        'Rims are crossed at their very time, and she slides by the convex combination of both forces.',
      ],
      cases: timed(known.fields),
      drawn: 'slides along a rim',
    },
    {
      title: 'Aliens',
      slug: 'aliens',
      about: [
        'A chaser is pulled to where she is, so that an error of her way is one of its way, too; a touch is a matter of less than a pixel.',
        'The naive engine has her caught where she escapes, and the other way round.',
        'Chasers move on series of their own, and waking, sleeping, touching and exploding are events.',
      ],
      cases: [...timed(known.aliens), ...effects.chases],
      drawn: 'just escapes',
    },
    {
      title: 'Starts',
      slug: 'starts',
      about: [
        'At the start something has no direction, is exactly on a limit, or is over before it begins.',
        'What divides by the distance has no direction there; the naive engine here has a rule for that, and only its steps are off.',
        'What is the case at time 0 is decided before anything moves.',
      ],
      cases: timed(known.starts),
      drawn: 'recoil on a line',
    },
    {
      title: 'Speed limit',
      slug: 'speed-limit',
      about: [
        'An axis is held at the limit while the force drives it further, and free again in the instant in which it does not.',
        'A velocity that is a little off reaches it earlier or later, and the way turns by that.',
        'Reaching the limit and coming off it are events of each axis.',
      ],
      cases: [...timed(known.limits), ...effects.speedLimit],
      drawn: 'both axes reach the limit at once',
    },
    {
      title: 'Holds',
      slug: 'holds',
      about: [
        'Holds of no length, of one tick, or one after the other.',
        'A step of Euler moves her by the velocity at its end, which is too far after each press.',
        'A press is an event at the start of its tick; holds that touch are one.',
      ],
      cases: timed(known.holds),
      drawn: 'single ticks',
    },
    {
      title: 'Winds',
      slug: 'winds',
      about: [
        'Winds begin and end at their rims, add up, and can be as strong as the pull.',
        'What is off at a rim is another place, another velocity, and sometimes another side of it for good.',
        'Rims are events; between them wind and pull are one series.',
      ],
      cases: effects.winds,
      drawn: 'a rim crossed once',
    },
    {
      title: 'Wormholes',
      slug: 'wormholes',
      about: [
        'A jump changes target, field and wind in one instant, and a mouth that she comes out in must not take her again.',
        'A mouth is clipped or missed by less than the error, and then she is somewhere else altogether.',
        'The jump is an event at the rim, and what is the case at the exit is decided anew there.',
      ],
      cases: effects.wormholes,
      drawn: 'a mouth clipped',
    },
    {
      title: 'Recoil',
      slug: 'recoil',
      about: [
        'The target is drawn towards her and keeps its velocity: both fall about each other, and the range and the centre move.',
        'A step moves the target by where she was at its start, in `fast`, too, which is off by pixels where the target is light.',
        'The series is that of both, in a frame that moves with the target.',
      ],
      cases: effects.recoil,
      drawn: 'released and caught again',
    },
    {
      title: 'Rules of a level',
      slug: 'rules',
      about: [
        'A level may have a pull of 1 or 1000, a box of 1 px or 200, a range of 2.',
        'Steps that are short enough for the game are too long for these.',
        'No step and no bound rests on the numbers of the game.',
      ],
      cases: effects.rules,
      drawn: 'a push of 1000',
    },
    {
      title: 'Mixtures',
      slug: 'mixtures',
      about: [
        'Three effects or more act on one another.',
        'Each adds its error to those of the others.',
        'Each effect has its own events, and all share one motion.',
      ],
      cases: effects.mixtures,
      drawn: 'everything',
    },
  ];
}
