import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../../engine/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import type { Drift, LineEnd } from '../../../solver/prove/index.ts';
import { type Asked, at, BOX, FRAMES, hot, levelWith, nearMisses, ORIGIN, PULL, RANGE, spot, whyNot } from './near-miss.ts';

// She falls along the line through the asteroid; lengths along it are from the start. All lines here are slanted unless it
// matters.

const U = { x: 0.6, y: 0.8 };
/** A place at this distance along the line and beside it. */
const on = (along: number, aside = 0, radius = 16) => at(along * U.x - aside * U.y, along * U.y + aside * U.x, radius);

const nova = (where: number, index = 0): LineEnd => ({ at: where, by: { kind: 'nova', index } });
const start: LineEnd = { at: 0, by: { kind: 'start' } };
const range = (where: number): LineEnd => ({ at: where, by: { kind: 'range' } });
const trap = (back: LineEnd, front: LineEnd, drift: Drift | null = null, target = 0) => ({
  kind: 'line-trap' as const,
  target,
  back,
  front,
  drift,
});

/** How closely the checker holds her to the line, px; it allows for as much at ends and sides. */
const TUBE = 0.01;
const slackOf = (times: number) => [times * TUBE - 1e-6, times * TUBE + 1e-5] as const;

/** One asteroid 60 px along the line, and a nova before its centre: she only ever falls forward. */
const fall = (more: Partial<LevelFile> = {}) =>
  levelWith({ asteroids: [on(60)], novae: [on(50, 0, 32)], blackHole: spot(4000, 0), ...more });
/** She swings through the asteroid between a nova behind the start and one beyond the asteroid. */
const swing = (more: Partial<LevelFile> = {}) =>
  levelWith({ asteroids: [on(60)], novae: [on(-80), on(200)], blackHole: spot(4000, 0), ...more });
const between = trap(nova(-60, 0), nova(180, 1));

describe('line-trap', () => {
  it('holds with a start to fall from, between two novae, and to the end of the range', () => {
    expect(whyNot(fall(), trap(start, nova(20)))).toBeNull();
    expect(whyNot(swing(), between)).toBeNull();
    expect(whyNot(swing(), trap(nova(-60, 0), range(310.1)))).toBeNull();
    expect(whyNot(swing(), trap(range(-190.1), range(310.1)))).toBeNull();
  });

  /** A nova across the line: her box, which extends 16 px to each side of it, overlaps it when she is at `place`. */
  const stops = (aside: number, place: number, of = 0) =>
    whyNot(swing({ novae: [on(-80), on(200), on(150 - of, aside, 20)] }), trap(nova(-60, 0), nova(place, 2)));
  const notStop = 'the hazard at an end of the stretch may not stop her';
  nearMisses({
    'a nova beside the line': { why: (d) => stops(d, 150), truth: 36, safe: 'below', slack: slackOf(1), says: notStop },
    'a nova at the other side': { why: (d) => stops(-d, 150), truth: 36, safe: 'below', slack: slackOf(1), says: notStop },
    'a nova ahead of the end': { why: (d) => stops(0, 150 - d), truth: 30, safe: 'below', slack: slackOf(1), says: notStop },
    'a nova behind the end': { why: (d) => stops(0, 150 + d), truth: 30, safe: 'below', slack: slackOf(1), says: notStop },
    'a nova at a corner': {
      why: (d) => stops(16 + 0.8 * d, 150 + 10 + 0.6 * d),
      truth: 20,
      safe: 'below',
      slack: slackOf(1.4),
      says: notStop,
    },
    'the end of the range ahead': {
      why: (d) => whyNot(swing(), trap(nova(-60, 0), range(d))),
      truth: 60 + RANGE,
      safe: 'above',
      slack: slackOf(1),
      says: 'an end of its stretch is still in range',
    },
    'the end of the range behind': {
      why: (d) => whyNot(swing(), trap(range(-d), nova(180, 1))),
      truth: RANGE - 60,
      safe: 'above',
      slack: slackOf(1),
      says: 'an end of its stretch is still in range',
    },
    'she comes to the centre of the asteroid': {
      why: (d) => whyNot(fall({ novae: [on(60, 0, 40)] }), trap(start, nova(d))),
      truth: 60,
      safe: 'below',
      slack: slackOf(1),
      says: 'she may reach the centre of the asteroid',
    },
    'a black hole beside the line': {
      why: (d) => whyNot(swing({ blackHole: on(100, d, 18) }), between),
      truth: 18 + BOX.halfHeight,
      safe: 'above',
      slack: slackOf(2),
      says: 'she may touch it on the stretch',
    },
    'a black hole at the other side': {
      why: (d) => whyNot(swing({ blackHole: on(100, -d, 18) }), between),
      truth: 18 + BOX.halfHeight,
      safe: 'above',
      slack: slackOf(2),
      says: 'she may touch it on the stretch',
    },
    'a black hole beyond the front': {
      why: (d) => whyNot(swing({ blackHole: on(180 + d, 0, 18) }), between),
      truth: 18 + BOX.halfWidth,
      safe: 'above',
      slack: slackOf(3),
      says: 'she may touch it on the stretch',
    },
    'a black hole beyond the back': {
      why: (d) => whyNot(swing({ blackHole: on(-60 - d, 0, 18) }), between),
      truth: 18 + BOX.halfWidth,
      safe: 'above',
      slack: slackOf(3),
      says: 'she may touch it on the stretch',
    },
    // Upright, as at the start, her long side lies along a vertical line.
    'a black hole above the start': {
      why: (d) => {
        const level = levelWith({ asteroids: [at(60, 0)], novae: [at(50, 0, 32)], blackHole: spot(-5, -d) });
        return whyNot(level, trap(start, nova(20)));
      },
      truth: 18 + 16,
      safe: 'above',
      slack: slackOf(2),
      says: 'she may touch it',
    },
    'a black hole above a start that falls down': {
      why: (d) => {
        const level = levelWith({ asteroids: [at(0, 60)], novae: [at(0, 50, 32)], blackHole: spot(4, -d) });
        return whyNot(level, trap(start, nova(20)));
      },
      truth: 18 + 16,
      safe: 'above',
      slack: slackOf(1),
      says: 'she may touch it at the start',
    },
    'a black hole at the left of a start that falls down': {
      why: (d) => {
        const level = levelWith({
          asteroids: [at(0, 60)],
          novae: [at(0, 50, 32)],
          blackHole: spot(-10 - 0.6 * d, -16 - 0.8 * d),
        });
        return whyNot(level, trap(start, nova(20)));
      },
      truth: 18,
      safe: 'above',
      slack: slackOf(1),
      says: 'she may touch it at the start',
    },
    'a repulsor beside the line': {
      why: (d) => whyNot(swing({ repulsors: [on(100, d, 40)] }), between),
      truth: 40,
      safe: 'above',
      slack: slackOf(1),
      says: 'repulsor 1 may push her on the stretch',
    },
    'a repulsor beyond the front': {
      why: (d) => whyNot(swing({ repulsors: [on(2000, 0, 40), on(180 + d, 0, 40)] }), between),
      truth: 40,
      safe: 'above',
      slack: slackOf(2),
      says: 'repulsor 2 may push her on the stretch',
    },
    'a repulsor beyond the back': {
      why: (d) => whyNot(swing({ repulsors: [on(-60 - 0.6 * d, -0.8 * d, 40)] }), between),
      truth: 40,
      safe: 'above',
      slack: slackOf(1.6),
      says: 'repulsor 1 may push her on the stretch',
    },
    // A tie at 180 px, 120 px from the target, is the end of the stretch.
    'another asteroid as near as the target at the front': {
      why: (d) => whyNot(swing({ asteroids: [on(60), on(180, d)] }), between),
      truth: 120,
      safe: 'above',
      slack: [0.0299, 0.0301],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    'another asteroid as near as the target at the back': {
      why: (d) => whyNot(swing({ asteroids: [on(60), on(-60, -d), on(-4000)] }), between),
      truth: 120,
      safe: 'above',
      slack: [0.0299, 0.0301],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    'another asteroid on the line': {
      why: (d) => whyNot(swing({ asteroids: [on(60), on(180 + d)] }), between),
      truth: 120,
      safe: 'above',
      slack: [0.0299, 0.0402],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
  });

  it('a box upright at the start touches what it does not touch once it is turned', () => {
    // The line is level, so the turned box extends 16 px to each side of it and 10 px along it, just as upright.
    const level = (y: number) => levelWith({ asteroids: [at(0, 60)], novae: [at(0, 50, 32)], blackHole: spot(0, y) });
    // Falling down it would extend 10 px upwards, but upright it extends 16 px.
    expect(whyNot(level(-30), trap(start, nova(20)))).toBe('she may touch it at the start');
    expect(simulate(compile(level(-30)), []).outcome).toBe('completed');
    expect(whyNot(level(-34.02), trap(start, nova(20)))).toBeNull();
  });

  it('refuses what it does not know', () => {
    const rests = 'she is not at rest at the start';
    expect(whyNot(fall({ astronaut: { ...ORIGIN, vx: 0, vy: 1e-9 } }), trap(start, nova(20)))).toBe(rests);
    expect(whyNot(fall({ astronaut: { ...ORIGIN, vx: 1e-9, vy: 0 } }), trap(start, nova(20)))).toBe(rests);
    for (const target of [1, -1, 0.5, '0' as never]) {
      expect(whyNot(fall(), trap(start, nova(20), null, target))).toBe('it names an asteroid that the level does not have');
    }
    const ends = 'its stretch does not contain the start';
    for (const [back, front] of [
      [undefined, nova(20)],
      [start, undefined],
      [nova(1), nova(20)],
      [nova(-1), nova(-0.5)],
      [{ ...start, at: Number.NaN }, nova(20)],
      [start, nova(Number.POSITIVE_INFINITY)],
      [start, nova('20' as never)],
    ] as [LineEnd, LineEnd][]) {
      expect(whyNot(fall(), trap(back, front))).toBe(ends);
    }
    expect(whyNot(fall({ asteroids: [at(0, 0.009)] }), trap(start, nova(20)))).toBe(
      'the asteroid is where she starts: there is no line',
    );
    expect(whyNot(fall(), trap({ ...start, at: -1 }, nova(20)))).toBe('its stretch does not begin at the start');
    for (const by of [undefined, null]) {
      const end = { at: -60, by } as never;
      expect(whyNot(swing(), trap(end, nova(180, 1)))).toBe(
        'at an end of the stretch it names something other than a hazard that stands still',
      );
      expect(whyNot(fall(), trap(start, { at: 20, by } as never))).toBe(
        'at an end of the stretch it names something other than a hazard that stands still',
      );
    }
    expect(whyNot(swing(), trap(nova(-60, 0), start))).toBe(
      'at an end of the stretch it names something other than a hazard that stands still',
    );
  });

  it('an end is a hazard that stands still', () => {
    const none = 'at an end of the stretch it names something other than a hazard that stands still';
    const by = (end: unknown, more: Partial<LevelFile> = {}) =>
      whyNot(swing(more), trap(nova(-60, 0), { at: 180, by: end as never }));
    expect(by({ kind: 'nova', index: 1 })).toBeNull();
    for (const end of [
      undefined,
      null,
      { kind: 'nova', index: 2 },
      { kind: 'start' },
      { kind: 'alien', index: 0 },
      { kind: 'blackHole', index: 0 },
    ])
      expect(by(end, { aliens: [on(200)] })).toBe(none);
    expect(by({ kind: 'asteroid', index: 1 }, { asteroids: [on(60), on(420, 0, 250)] })).toBe(none);
    expect(by({ kind: 'asteroid', index: 1 }, { asteroids: [on(60), { ...on(420, 0, 250), hot: true }] })).toBeNull();
    expect(
      whyNot(
        swing({ minerals: [spot(0, 900)], blackHole: on(200) }),
        trap(nova(-60, 0), { at: 180, by: { kind: 'blackHole', index: 0 } }),
        { about: { kind: 'mineral', index: 0 } },
      ),
    ).toBeNull();
  });

  it('a hot asteroid stops her where she touches it, a cold one does not', () => {
    const end = (where: number): LineEnd => ({ at: where, by: { kind: 'asteroid', index: 0 } });
    const why = (where: number, asteroid: ReturnType<typeof at> = hot(60, 0, 20)) =>
      whyNot(levelWith({ asteroids: [asteroid] }), trap(start, end(where)));
    expect(why(31)).toBeNull();
    expect(why(31, at(60, 0, 20))).toBe('the asteroid at its end is cold');
    expect(why(30.009)).toBe('she may stop before she touches the asteroid');
    expect(why(30.0101)).toBeNull();
    // Another hot one does not stop her there.
    const two = levelWith({ asteroids: [hot(60, 0, 20), hot(400, 0, 20)] });
    expect(whyNot(two, trap(start, { at: 31, by: { kind: 'asteroid', index: 1 } }))).toBe(
      'the hazard at an end of the stretch may not stop her',
    );
  });

  it('in frames she does not jump over half of a hot asteroid', () => {
    const end: LineEnd = { at: 55, by: { kind: 'asteroid', index: 0 } };
    const why = (radius: number) => whyNot(levelWith({ asteroids: [hot(60, 0, radius)] }), trap(start, end), { covers: FRAMES });
    if (why(20) !== null) return expect(why(20)).toContain('frames');
    expect(why(4)).toBe('she may jump over the asteroid');
    return undefined;
  });
});

describe('line-trap with recoil', () => {
  const asked: Asked = { maxTime: 60 };

  /**
   * The drift to one side that cannot be exceeded, as in the argument: her path to the other side times 1 / (mean diameter),
   * plus, of the bound for constant acceleration, the share by which the pull at the far end falls short of the full one.
   */
  const driftBound = (far: number, way: number, radius: number, seconds: number): number => {
    const weakest = PULL * (1 - far / RANGE);
    const mean = (PULL + weakest) / 2;
    return ((PULL - weakest) / (2 * mean)) * ((seconds * seconds) / (4 * radius)) + way / (mean * 2 * radius);
  };

  // She swings between a nova 30 px behind the start and one 50 px beyond the asteroid, which is dragged.
  const level = (radius = 50) =>
    levelWith({ asteroids: [on(20, 0, radius)], novae: [on(-46), on(80)], blackHole: spot(4000, 0), recoil: true });
  const claimed = (drift: Drift | null, radius = 50, to = 64) =>
    whyNot(level(radius), trap(nova(-30, 0), nova(to, 1), drift), asked);
  /** The same rock and back, but beyond the rock nothing stops her before the end of the range. */
  const untilLost = (more: Partial<LevelFile>) =>
    whyNot(
      levelWith({ asteroids: [on(20, 0, 50)], novae: [on(-46)], blackHole: spot(4000, 0), recoil: true, ...more }),
      trap(nova(-30, 0), range(289.011), { back: 19, ahead: 19 }),
      asked,
    );
  const may = 'the asteroid may drift farther than it says';

  it('needs both numbers, and no more than what the time allows', () => {
    expect(claimed(null)).toBe(may);
    expect(claimed({ back: 18.5, ahead: Number.NaN })).toBe(may);
    expect(claimed({ back: '18.5' as never, ahead: 18.5 })).toBe(may);
    expect(claimed({ back: 18.5, ahead: 18.5 })).toBeNull();
    expect(claimed({ back: 0, ahead: 0 })).toBe(may);
    expect(claimed({ back: -5, ahead: 18.5 })).toBe(may);
    expect(claimed({ back: 18.5, ahead: -5 })).toBe(may);
    for (const none of [undefined, {}, { ahead: 18.5 }, { back: 18.5 }, { back: 18.5, ahead: '19' }])
      expect(claimed(none as never)).toBe(may);
    // 1 % more than 3600 / 200 px, which constant acceleration could do, needs nothing else.
    expect(claimed({ back: 18.18, ahead: 18.18 })).toBeNull();
  });

  nearMisses({
    'a drift ahead that may be exceeded': {
      why: (ahead) => claimed({ back: 18.5, ahead }),
      truth: driftBound(64 - 20 + 18.5, 30, 50, 60),
      safe: 'above',
      // 1 % of it, for frames.
      slack: [0.02, 0.035],
      says: may,
      reach: 2,
    },
    'a drift back that may be exceeded': {
      why: (back) => claimed({ back, ahead: 18.5 }),
      truth: driftBound(20 + 18.5 + 30, 64, 50, 60),
      safe: 'above',
      slack: [0.02, 0.04],
      says: may,
      reach: 2,
    },
    'the end of the range, from where recoil may have carried the rock': {
      why: (d) => whyNot(level(), trap(nova(-30, 0), range(d), { back: 19, ahead: 19 }), asked),
      truth: 20 + 19 + RANGE,
      safe: 'above',
      slack: slackOf(1),
      says: 'an end of its stretch is still in range',
    },
    'the end of the range behind': {
      why: (d) => whyNot(level(), trap(range(-d), nova(64, 1), { back: 19, ahead: 19 }), asked),
      truth: RANGE + 19 - 20,
      safe: 'above',
      slack: slackOf(1),
      says: 'an end of its stretch is still in range',
    },
    'another rock, once recoil has carried the target away from the front': {
      why: (d) =>
        whyNot(
          levelWith({ asteroids: [on(20, 0, 50), on(64, d)], novae: [on(-46), on(80)], blackHole: spot(4000, 0), recoil: true }),
          trap(nova(-30, 0), nova(64, 1), { back: 18.5, ahead: 19 }),
          asked,
        ),
      truth: 64 - 20 + 18.5,
      safe: 'above',
      slack: [0.0299, 0.0301],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    'another rock, once recoil has carried the target away from the back': {
      why: (d) =>
        whyNot(
          levelWith({ asteroids: [on(20, 0, 50), on(-30, d)], novae: [on(-46), on(80)], blackHole: spot(4000, 0), recoil: true }),
          trap(nova(-30, 0), nova(64, 1), { back: 18.5, ahead: 19 }),
          asked,
        ),
      truth: 30 + 20 + 19,
      safe: 'above',
      slack: [0.0299, 0.0301],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    // Carried 19 px either way, the rock holds her up to 289 px along the line, and up to 251 px wherever it is.
    'another rock beside the places where the range may end': {
      why: (d) => untilLost({ asteroids: [on(20, 0, 50), on(270, d)] }),
      truth: RANGE,
      safe: 'above',
      slack: [0.0249, 0.0251],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    'another rock at the other side of them': {
      why: (d) => untilLost({ asteroids: [on(20, 0, 50), on(270, -d)] }),
      truth: RANGE,
      safe: 'above',
      slack: [0.0249, 0.0251],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    'another rock beyond the last of them': {
      why: (d) => untilLost({ asteroids: [on(20, 0, 50), on(289 + d)] }),
      truth: RANGE,
      safe: 'above',
      // It tests the stretch up to 0.01 px beyond its end, which is 0.011 px beyond the range.
      slack: [0.0459, 0.0461],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    // From the place 251 px along the line, 24 px across for 7 px back.
    'another rock before the first of them': {
      why: (d) => untilLost({ asteroids: [on(20, 0, 50), on(251 - 0.28 * d, 0.96 * d)] }),
      truth: RANGE,
      safe: 'above',
      slack: [0.0149, 0.0352],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    'another rock beside the places where the range may end behind': {
      why: (d) =>
        whyNot(
          levelWith({
            asteroids: [on(20, 0, 50), on(-230, d)],
            novae: [on(500), on(80)],
            blackHole: spot(4000, 0),
            recoil: true,
          }),
          trap(range(-249.011), nova(64, 1), { back: 19, ahead: 19 }),
          asked,
        ),
      truth: RANGE,
      safe: 'above',
      slack: [0.0249, 0.0251],
      says: 'asteroid 2 may be the nearer one on the stretch',
    },
    'a fall to where recoil may have brought the centre': {
      why: (d) =>
        whyNot(levelWith({ asteroids: [on(60, 0, 10)], novae: [on(50, 0, 40)], recoil: true }), trap(start, nova(d)), asked),
      // The centre moves towards her by a share of her path: d / (2 r pull).
      truth: 60 / (1 + 1 / (20 * PULL * (1 - 60 / RANGE))),
      safe: 'below',
      slack: [0.01, 0.012],
      says: 'she may reach the centre of the asteroid',
    },
    'a fall with a pull that is too weak to tell': {
      why: (d) =>
        whyNot(levelWith({ asteroids: [on(249.995, 0, 200)], novae: [on(230, 0, 40)], recoil: true }), trap(start, nova(d)), {
          maxTime: 60,
        }),
      truth: 249.995 - 3600 / 800,
      safe: 'below',
      slack: [0.05, 0.06],
      says: 'she may reach the centre of the asteroid',
    },
  });

  it('recoil moves the target, and its part that is certainly hot shrinks by as much', () => {
    // 400 / 120 px plus 1 % in 20 s, so that it certainly covers 26.63 px around its place.
    const level = levelWith({ asteroids: [{ ...on(60, 0, 30), hot: true }], blackHole: spot(4000, 0), recoil: true });
    const why = (to: number) =>
      whyNot(level, trap(range(-200), { at: to, by: { kind: 'asteroid', index: 0 } }, { back: 4, ahead: 4 }), { maxTime: 20 });
    expect(why(60 - 10 - 26.61)).toBeNull();
    expect(why(60 - 10 - 26.64)).toBe('the hazard at an end of the stretch may not stop her');
  });

  it('recoil moves no other asteroid: a hot one that is never the target stands still', () => {
    const big = levelWith({
      asteroids: [on(20, 0, 50), { ...on(320, 0, 240), hot: true }],
      novae: [on(-46)],
      blackHole: spot(4000, 0),
      recoil: true,
    });
    const end = (to: number) =>
      whyNot(big, trap(nova(-30, 0), { at: to, by: { kind: 'asteroid', index: 1 } }, { back: 18.5, ahead: 19 }), asked);
    expect(end(70.011)).toBeNull();
    expect(end(70.009)).toBe('the hazard at an end of the stretch may not stop her');
  });
});
