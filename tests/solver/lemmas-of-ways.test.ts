import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { TICK } from '../../engine/index.ts';
import { type Level, NO_OBJECTS, rulesOf } from '../../schema/index.ts';
import { swingDrift } from '../../solver/prove/swing-drift.ts';
import { claimOf } from '../../solver/verify/claim.ts';
import { expectDeep } from '../depth.ts';
import { continuousNames } from '../engine/accuracies.ts';
import { accuracyNames } from '../levels/shipped-pack.ts';
import { real } from '../real.ts';
import { windyLevel } from './proofs-crowded.ts';
import { someRules } from './some-rules.ts';
import { type Look, lingering, type Player, watch } from './watched-play.ts';

// More lemmas, see lemmas.test.ts: those about where she was and how she moved.

const HOLE = { kind: 'blackHole' } as const;
const RANGE = 250;

const whole = (min: number, max: number) => fc.integer({ min, max });
const rock = (x: number, y: number, radius: number) => ({ id: null, x, y, radius, hot: false });

const level = (asteroids: Level['asteroids'], more: Partial<Level> = {}): Level => ({
  name: 'lemma',
  description: '',
  astronaut: { x: 0, y: 0, vx: 0, vy: 0 },
  blackHole: { x: 0, y: 1e7, radius: 18 },
  range: RANGE,
  recoil: false,
  ...NO_OBJECTS,
  asteroids,
  runs: [],
  ...more,
});

/** A button that changes now and then. */
const script = fc.array(whole(1, 60), { minLength: 5, maxLength: 30 });
const playing = (lengths: readonly number[]): Player => {
  let left = lengths[0];
  let k = 0;
  return () => {
    while (left === 0) left = lengths[++k % lengths.length];
    left--;
    return k % 2 === 0;
  };
};

describe('chord: between two frames outside a disc she enters it no deeper than a chord as long as the jump', () => {
  it('arcade', () => {
    let deepest = 0;
    fc.assert(
      fc.property(
        windyLevel,
        someRules,
        script,
        whole(0, 300),
        real(-1, 1),
        real(1.01, 4),
        (plain, rules, lengths, at, aside, size) => {
          const of = { ...plain, rules };
          const { jump } = claimOf(of, HOLE, 60, 'frames');
          const looks = watch(of, 'arcade', 400, playing(lengths), () => 0);
          const i = Math.min(at, looks.length - 2);
          if (i < 0) return;
          const [ax, ay] = looks[i].s;
          const [bx, by] = looks[i + 1].s;
          const far = Math.hypot(bx - ax, by - ay);
          // A frame that goes through a wormhole is not straight.
          if (far === 0 || far > jump) return;
          // A disc on or outside of whose rim both ends of the frame lie, with its centre beside the middle of the flight.
          const r = (size * jump) / 2;
          const off = Math.sqrt(Math.max(0, r * r - (far * far) / 4)) * (aside < 0 ? aside / 100 - 1 : 1 + aside / 100);
          const centre = { x: (ax + bx) / 2 - (off * (by - ay)) / far, y: (ay + by) / 2 + (off * (bx - ax)) / far };
          if (Math.hypot(ax - centre.x, ay - centre.y) < r || Math.hypot(bx - centre.x, by - centre.y) < r) return;
          const bound = Math.sqrt(r * r - (jump * jump) / 4);
          for (let k = 0; k <= 32; k++) {
            const d = Math.hypot(ax + ((bx - ax) * k) / 32 - centre.x, ay + ((by - ay) * k) / 32 - centre.y);
            if (d < bound) expect.fail(`${r - d} px deep of ${r - bound}`);
            deepest = Math.max(deepest, (r - d) / (r - bound));
          }
        },
      ),
      { numRuns: 120 },
    );
    expectDeep(deepest).toBeGreaterThan(0.1);
  });
});

describe('fall drift: on a fall the path of the asteroid relates to hers at most as its acceleration to hers', () => {
  it.each(accuracyNames)('%s', (accuracy) => {
    let closest = 0;
    fc.assert(
      fc.property(
        someRules,
        real(30, 200),
        real(0, 6.3),
        fc.constantFrom(0.05, 1, 16),
        script,
        (rules, d, turn, radius, lengths) => {
          const [ux, uy] = [Math.cos(turn), Math.sin(turn)];
          const of = level([rock(d * ux, d * uy, radius)], { rules, recoil: true });
          const { pull, recoil, speedLimit } = rulesOf(of);
          const share = recoil / (2 * radius * pull * (1 - d / RANGE));
          for (const { s, rocks } of watch(of, accuracy, 1200, playing(lengths), () => 0)) {
            const left = (rocks[0] - s[0]) * ux + (rocks[1] - s[1]) * uy;
            if (left <= 0) break;
            const way = s[0] * ux + s[1] * uy;
            const moved = Math.hypot(rocks[0] - d * ux, rocks[1] - d * uy);
            // At the speed limit there is no proof.
            if (Math.hypot(s[2], s[3]) > 0.99 * speedLimit - pull * TICK) break;
            // Frames move her by the velocity with which they end, for which 1 % is allowed.
            if (moved > 1.01 * share * way + 1e-9) expect.fail(`${moved} px of ${share * way}`);
            if (way > 1 && share > 0) closest = Math.max(closest, moved / (share * way));
          }
        },
      ),
      { numRuns: 20 },
    );
    expectDeep(closest).toBeGreaterThan(0.8);
  });
});

describe('swing drift: an asteroid through which she swings drifts no farther than claimed', () => {
  it.each(continuousNames)('%s', (accuracy) => {
    let most = 0;
    const chance = real(0, 1);
    fc.assert(
      fc.property(
        real(5, 120),
        fc.constantFrom(16, 32),
        fc.tuple(chance, chance, chance, chance),
        real(0, 120),
        someRules,
        fc.infiniteStream(chance),
        (centre, radius, chances, from, rules, numbers) => {
          const of = level([rock(centre, 0, radius)], { rules, recoil: true });
          const { pull, recoil, speedLimit } = rulesOf(of);
          const luck = () => numbers.next().value as number;
          const side = ({ s, rocks }: Look) => s[0] - rocks[0];
          const inwards = (look: Look) => look.s[2] * side(look) < 0;
          const mixed: Player = (look, random) =>
            random < chances[(side(look) > 0 ? 2 : 0) + (inwards(look) ? 0 : 1)] &&
            (side(look) > 0 || Math.abs(side(look)) > from);
          const greedy: Player = (look) =>
            side(look) < 0 ? inwards(look) && -side(look) > Math.min(from, centre / 2) : !inwards(look) || side(look) < from;
          for (const player of [mixed, greedy]) {
            const looks = watch(of, accuracy, 3600, player, luck);
            const seconds = (looks.length - 1) * TICK;
            const places = looks.map(({ s }) => s[0]);
            const stretch = { centre, back: Math.min(...places), front: Math.max(...places) };
            // At the speed limit there is no proof.
            if (looks.some(({ s }) => Math.abs(s[2]) > 0.99 * speedLimit - pull * TICK)) continue;
            const always = (1.01 * recoil * seconds * seconds) / 4 / radius;
            const bound = swingDrift(rulesOf(of), radius, RANGE, stretch, seconds, always);
            for (const { rocks } of looks) {
              if (centre - rocks[0] > bound.back + 1e-9) expect.fail(`${centre - rocks[0]} px back of ${bound.back}`);
              if (rocks[0] - centre > bound.ahead + 1e-9) expect.fail(`${rocks[0] - centre} px ahead of ${bound.ahead}`);
              if (recoil > 0) most = Math.max(most, (centre - rocks[0]) / bound.back, (rocks[0] - centre) / bound.ahead);
            }
          }
        },
      ),
      { numRuns: 6 },
    );
    expectDeep(most).toBeGreaterThan(0.05);
  });
});

describe('in range: while the run goes on she is in range of the asteroid, wherever recoil has carried it', () => {
  it.each(continuousNames)('%s', (accuracy) => {
    let farthest = 0;
    let carried = 0;
    fc.assert(
      fc.property(
        real(5, 245),
        real(0, 6.3),
        fc.constantFrom(0.5, 4, 16),
        fc.constantFrom([1], [-1], [1, -1]),
        fc.constantFrom(-0.5, 0.01, 0.5, 5),
        fc.constantFrom({}, { recoil: 20 }, { pull: 200 }),
        (d, turn, radius, sides, within, rules) => {
          const [ux, uy] = [Math.cos(turn), Math.sin(turn)];
          const of = level([rock(d * ux, d * uy, radius)], { rules, recoil: true });
          const along = ({ s, rocks }: Look) => (s[0] - rocks[0]) * ux + (s[1] - rocks[1]) * uy;
          const speed = ({ s }: Look) => s[2] * ux + s[3] * uy;
          const player = lingering(rulesOf(of).pull, RANGE, along, speed, sides, within);
          for (const { s, rocks } of watch(of, accuracy, 3600, player, () => 0)) {
            const far = Math.hypot(s[0] - rocks[0], s[1] - rocks[1]);
            if (far > RANGE + 1e-6) expect.fail(`${far} px from the asteroid`);
            farthest = Math.max(farthest, far);
            carried = Math.max(carried, Math.hypot(rocks[0] - d * ux, rocks[1] - d * uy));
          }
        },
      ),
      { numRuns: 12 },
    );
    expectDeep(farthest).toBeGreaterThan(RANGE - 1);
    expectDeep(carried).toBeGreaterThan(100);
  });
});

/** She flies to the right; asteroids ahead pull her forward while she is to the left of all of them. */
const ahead = fc.record({
  vx: real(5, 100),
  vy: real(-60, 60),
  asteroids: fc.array(
    fc.record({ x: real(40, 240), y: real(-120, 120) }).map(({ x, y }) => rock(x, y, 16)),
    { minLength: 1, maxLength: 4 },
  ),
});

describe('slopes: where all pushes point forward, the slope of her path only turns towards their slopes', () => {
  it('precise', () => {
    let turned = 0;
    fc.assert(
      fc.property(ahead, someRules, script, ({ vx, vy, asteroids }, rules, lengths) => {
        const of = level(asteroids, { rules, astronaut: { x: 0, y: 0, vx, vy }, range: 1000 });
        const { pull, speedLimit } = rulesOf(of);
        const first = Math.min(...asteroids.map(({ x }) => x));
        let before: Look | null = null;
        for (const look of watch(of, 'precise', 240, playing(lengths), () => 0)) {
          const [x, y, u, v] = look.s;
          if (x >= first - 1) break;
          // At the speed limit there is no proof.
          if (Math.max(Math.abs(u), Math.abs(v)) > 0.99 * speedLimit - pull * TICK) break;
          if (before !== null) {
            const slopes: number[] = [];
            // The slopes of pushes between the two observations: extremes at both places, with room for what lies between.
            const room = (p: number, q: number) => 0.02 * (1 + Math.abs(p) + Math.abs(q)) * Math.max(1, 20 / (first - x));
            for (const [px, py] of [before.s, look.s]) {
              for (const a of asteroids) slopes.push((a.y - py) / (a.x - px));
            }
            const [low, high] = [Math.min(...slopes), Math.max(...slopes)];
            const was: number = before.s[3] / before.s[2];
            const is: number = v / u;
            const slack = room(low, high);
            if (is > Math.max(was, high + slack) + 1e-9 || is < Math.min(was, low - slack) - 1e-9)
              expect.fail(`slope ${is} after ${was}, pushes from ${low} to ${high} at ${x}, ${y}`);
            if (Math.abs(is - was) > 1e-3) turned++;
          }
          before = look;
        }
      }),
      { numRuns: 100 },
    );
    expectDeep(turned).toBeGreaterThan(150);
  });
});

describe('leaving: on slopes that take her nearer to another asteroid faster than to the previous one, the previous one is never the nearest again', () => {
  it('precise', () => {
    let left = 0;
    fc.assert(
      fc.property(ahead, someRules, real(-200, 0), real(-150, 150), script, ({ vx, vy, asteroids }, rules, ox, oy, lengths) => {
        const old = rock(ox, oy, 16);
        const of = level([...asteroids, old], { rules, astronaut: { x: 0, y: 0, vx, vy }, range: 1000 });
        const looks = watch(of, 'precise', 240, playing(lengths), () => 0);
        const far = ({ s }: Look, a: { x: number; y: number }) => Math.hypot(s[0] - a.x, s[1] - a.y);
        for (const taker of asteroids) {
          const from = looks.findIndex((look) => far(look, taker) <= far(look, old));
          if (from < 0) continue;
          for (let i = from + 1; i < looks.length; i++) {
            const [u, v] = looks[i].s.slice(2);
            // Every stretch of her path so far approaches the new asteroid faster than the old one.
            if (u <= 0 || (taker.x - old.x) * u + (taker.y - old.y) * v <= 0) break;
            const [pu, pv] = looks[i - 1].s.slice(2);
            if (pu <= 0 || (taker.x - old.x) * pu + (taker.y - old.y) * pv <= 0) break;
            left++;
            if (far(looks[i], old) < far(looks[i], taker) - 1e-9) expect.fail(`the one before is the nearer at look ${i}`);
          }
        }
      }),
      { numRuns: 100 },
    );
    expectDeep(left).toBeGreaterThan(300);
  });
});
