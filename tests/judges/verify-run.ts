import {
  boxCircleGap,
  createSimulation,
  DEFAULT_BOX,
  joinHolds,
  type Run,
  type Scene,
  STATE_SIZE,
  TICK,
} from '../../engine/index.ts';
import type { Circle, Hold } from '../../schema/index.ts';

/** How far to either side of a rim she may be while she slides along it, px. */
const SLIDES = 1e-6;

/** Largest number of complaints about one run. */
const ENOUGH = 5;

/** Time before and after a jump at which her state is read, s, and how far it may differ from the expected one, px and px/s. */
const JUMP = 1e-9;
const JUMP_SLACK = 1e-5;

/**
 * The mouth of a wormhole that she is in, so that it does not fire: 0 none, 1 the one at (x, y), 2 the other one; null if
 * unknown.
 */
type MouthState = 0 | 1 | 2 | null;

interface Modes {
  readonly held: boolean;
  readonly target: number;
  readonly field: number;
  /** The sum of all winds that blow on her, px/s². */
  readonly wind: readonly [number, number];
  readonly awake: readonly boolean[];
}

/**
 * Checks a run in continuous time against the rules, without using how it was found. At every tick: the gun pulls towards the
 * nearest asteroid; the first field that contains her is the one that acts; nothing overlaps her that should have ended the run
 * or been collected; exactly the winds that contain her blow; no open wormhole lets her stay in a mouth. A jump moves her by
 * the difference of the mouths and changes nothing else. Between events, energy, angular momentum, and straight lines (or
 * parabolas in a wind) are conserved.
 * @param slack - how far a place may be beyond what a rule allows, px
 * @param drift - relative change of energy and angular momentum that is allowed per tick
 * @returns what is wrong, in words; empty if nothing is
 */
export function verifyRun(scene: Scene, holds: readonly Hold[], run: Run, slack: number, drift: number): string[] {
  const { level } = scene;
  const complaints: string[] = [];
  const complain = (what: string) => {
    if (complaints.length < ENOUGH) complaints.push(what);
  };
  const duration = run.trajectory.duration;
  const script = joinHolds(holds);
  const events = run.events;

  for (let i = 1; i < events.length; i++) {
    if (!(events[i].time >= events[i - 1].time)) complain(`${events[i].type} at ${events[i].time} after ${events[i - 1].time}`);
  }
  for (const event of events) {
    if (!(event.time >= 0 && event.time <= run.time + 1e-12)) complain(`${event.type} at ${event.time} of ${run.time} s`);
  }

  const state = new Float64Array(STATE_SIZE);
  const aliens = new Float64Array(3 * level.aliens.length);
  const rocks = new Float64Array(2 * level.asteroids.length);
  const simulation = createSimulation(scene);
  const awake = level.aliens.map((a) => distance(a, level.astronaut.x, level.astronaut.y) < 150);
  const collected = level.minerals.map(() => false);
  const dead = level.aliens.map(() => false);
  // of equal fields the first one stands for all
  const first = level.repulsors.map((f) =>
    level.repulsors.findIndex(({ x, y, radius }) => x === f.x && y === f.y && radius === f.radius),
  );
  const inside = level.repulsors.map((f, i) => first[i] === i && distance(f, level.astronaut.x, level.astronaut.y) < f.radius);
  // of several fields that contain her the first one acts
  let field = inside.indexOf(true);
  let target = -1;
  const blowing = level.winds.map((w) => distance(w, level.astronaut.x, level.astronaut.y) < w.radius);
  const mouths = level.wormholes.map((w): MouthState => mouthAt(w, level.astronaut.x, level.astronaut.y));
  let next = 0;
  const follow = (until: number) => {
    let happened = false;
    for (; next < events.length && events[next].time <= until; next++) {
      const event = events[next];
      happened = true;
      if (event.type === 'release') target = -1;
      else if (event.type === 'target') target = event.index;
      else if (event.type === 'enter' || event.type === 'leave') {
        const enters = event.type === 'enter';
        if (inside[event.index] === enters) complain(`${event.type} ${event.index} at ${event.time} once more`);
        inside[event.index] = enters;
        field = inside.indexOf(true);
      } else if (event.type === 'effect' && event.effect === 'winds') {
        const enters = event.what === 'enter';
        if (blowing[event.index] === enters) complain(`${event.what} wind ${event.index} at ${event.time} once more`);
        blowing[event.index] = enters;
      } else if (event.type === 'effect' && event.effect === 'wormholes') {
        verifyJump(scene, run, event, target >= 0, slack, complain);
        mouths.fill(null);
      } else if (event.type === 'wake') awake[event.index] = true;
      else if (event.type === 'sleep') awake[event.index] = false;
      else if (event.type === 'mineral') {
        if (collected[event.index]) complain(`mineral ${event.index} twice`);
        collected[event.index] = true;
      } else if (event.type === 'explosion') for (const a of event.aliens) dead[a] = true;
    }
    return happened;
  };

  let before: { time: number; state: Float64Array; modes: Modes } | null = null;
  const lastTick = Math.floor(duration / TICK + 1e-9);
  for (let tick = 0; tick <= lastTick; tick++) {
    const time = tick * TICK;
    const held = script.some(([press, release]) => press <= tick && tick < release);
    // a press or release at this very tick has not happened yet
    if (tick > 0)
      simulation.advance(
        1,
        script.some(([press, release]) => press <= tick - 1 && tick - 1 < release),
      );
    if (simulation.ending !== null && tick < lastTick) {
      complain(`replayed tick by tick it ends at tick ${simulation.tick}, whole at ${run.tick}`);
      break;
    }
    if (simulation.ending !== null) break;
    simulation.readState(state);
    simulation.readAliens(aliens);
    simulation.readAsteroids(rocks);
    const happened = follow(time - 1e-9);
    for (const value of [...state, ...aliens, ...rocks]) if (!Number.isFinite(value)) complain(`${value} at tick ${tick}`);
    const [x, y, , , cos, sin] = state;
    const at = `at tick ${tick}`;

    // a mode can differ on the two sides of an instant; near one both answers are right
    const near = next < events.length && events[next].time < time + 1e-9;
    let least = Number.POSITIVE_INFINITY;
    const rockDistance = level.asteroids.map((_, i) => Math.hypot(rocks[2 * i] - x, rocks[2 * i + 1] - y));
    for (const d of rockDistance) least = Math.min(least, d);
    if (least > level.range + slack && !near) complain(`not lost ${at}, ${least - level.range} px out of range`);
    if (target >= 0 && rockDistance[target] > least + slack && !near) {
      complain(`target ${target} ${at} is ${rockDistance[target] - least} px farther than the nearest`);
    }
    if (target >= 0 && rockDistance[target] > 1e-3 && !near) {
      const d = rockDistance[target];
      const off = Math.hypot((rocks[2 * target] - x) / d - cos, (rocks[2 * target + 1] - y) / d - sin);
      if (off > 1e-9 + (1e-15 * scale(scene)) / d) complain(`box ${at} is turned ${off} away from target ${target}`);
    }
    for (const [i, f] of level.repulsors.entries()) {
      if (first[i] !== i) continue;
      const d = distance(f, x, y);
      if (near) break;
      // while she slides along a rim she may be slightly to either side of it
      if (inside[i] && d > f.radius + slack + SLIDES) complain(`in field ${i} ${at}, ${d - f.radius} px outside it`);
      if (!inside[i] && d < f.radius - slack - SLIDES) complain(`not in field ${i} ${at}, ${f.radius - d} px inside`);
    }
    for (const [i, w] of level.winds.entries()) {
      if (near) break;
      const outside = distance(w, x, y) - w.radius;
      if (blowing[i] && outside > slack + SLIDES) complain(`in wind ${i} ${at}, ${outside} px outside it`);
      if (!blowing[i] && outside < -slack - SLIDES) complain(`not in wind ${i} ${at}, ${-outside} px inside`);
    }
    for (const [i, w] of level.wormholes.entries()) {
      if (near) break;
      const there = mouthAt(w, x, y);
      const depth = w.radius - Math.min(distance(w, x, y), distance({ ...w, x: w.toX, y: w.toY }, x, y));
      if (mouths[i] === 0 && depth > slack + SLIDES) complain(`${depth} px in a mouth of open wormhole ${i} ${at}`);
      // from one mouth into the other mouth of the same wormhole she moves without a jump
      else mouths[i] = there;
    }
    for (const [i, a] of level.novae.entries()) overlap('nova', i, a.x, a.y, a.radius);
    for (const [i, a] of level.asteroids.entries()) {
      if (a.hot) overlap('hot asteroid', i, rocks[2 * i], rocks[2 * i + 1], a.radius);
    }
    overlap('black hole', 0, level.blackHole.x, level.blackHole.y, level.blackHole.radius);
    for (const [i, a] of level.minerals.entries()) if (!collected[i] && !near) overlap('mineral', i, a.x, a.y, a.radius);
    for (const [i, a] of level.aliens.entries()) {
      if (dead[i] !== (aliens[3 * i + 2] === 0) && !near)
        complain(`alien ${i} alive: ${aliens[3 * i + 2]} ${at}, by events ${!dead[i]}`);
      if (dead[i]) continue;
      const ax = aliens[3 * i];
      const ay = aliens[3 * i + 1];
      const d = Math.hypot(ax - x, ay - y);
      if (!near && (awake[i] ? d > 150 + slack : d < 150 - slack))
        complain(`alien ${i} ${awake[i] ? 'awake' : 'asleep'} ${at} at ${d} px`);
      overlap('alien', i, ax, ay, a.radius);
      for (let j = i + 1; j < level.aliens.length; j++) {
        if (dead[j]) continue;
        const gap = Math.hypot(aliens[3 * j] - ax, aliens[3 * j + 1] - ay) - a.radius - level.aliens[j].radius;
        if (gap < -slack && !near) complain(`aliens ${i} and ${j} overlap by ${-gap} px ${at}`);
      }
    }
    function overlap(what: string, i: number, cx: number, cy: number, r: number) {
      // at tick 0 the contact itself may be the first event
      if (near || tick === 0) return;
      const gap = boxCircleGap(DEFAULT_BOX, cx - x, cy - y, cos, sin, r);
      if (gap < -slack) complain(`${what} ${i} overlaps her by ${-gap} px ${at}`);
    }

    const wind = [0, 0] as [number, number];
    for (const [i, w] of level.winds.entries()) {
      if (!blowing[i]) continue;
      wind[0] += w.ax;
      wind[1] += w.ay;
    }
    const modes: Modes = { held, target, field, wind, awake: [...awake] };
    if (before !== null && !happened && before.time > 0) keepsInvariants(before.state, state, before.modes);
    before = near ? null : { time, state: state.slice(), modes };

    function keepsInvariants(a: Float64Array, b: Float64Array, m: Modes) {
      const [wx, wy] = m.wind;
      const most = 1000 - (39 + Math.hypot(wx, wy)) * TICK;
      if (Math.max(Math.abs(a[2]), Math.abs(a[3]), Math.abs(b[2]), Math.abs(b[3])) > most) return;
      const speed = Math.hypot(a[2], a[3]);
      if (!m.held && m.field < 0) {
        const bent = Math.hypot(b[2] - a[2] - wx * TICK, b[3] - a[3] - wy * TICK);
        const [fallX, fallY] = [(wx * TICK * TICK) / 2, (wy * TICK * TICK) / 2];
        const off = bent + Math.hypot(b[0] - a[0] - a[2] * TICK - fallX, b[1] - a[1] - a[3] * TICK - fallY);
        if (off > 1e-12 * (1 + speed) + 1e-15 * scale(scene)) complain(`coasting ${at} bends by ${off}`);
        return;
      }
      if (m.field < 0 && (level.recoil || m.target < 0)) return;
      if (m.field >= 0 && slides(level.repulsors[m.field], a) && slides(level.repulsors[m.field], b)) return;
      const centre = m.field >= 0 ? level.repulsors[m.field] : level.asteroids[m.target];
      const potential = (d: number) => (m.field >= 0 ? -20 * d : 39 * (d - (d * d) / (2 * level.range)));
      const [ea, la, size] = invariants(a);
      const [eb, lb] = invariants(b);
      const rounding = 1e-15 * scale(scene);
      const bound = drift * (1 + size) + rounding * 100;
      if (Math.abs(eb - ea) > bound) complain(`energy ${at} jumps by ${eb - ea} of ${ea} (${JSON.stringify(m)})`);
      // a wind turns her about any centre
      if (wx !== 0 || wy !== 0) return;
      if (Math.abs(lb - la) > bound + rounding * (speed + 100)) complain(`angular momentum ${at} jumps by ${lb - la} of ${la}`);
      function invariants(q: Float64Array): [number, number, number] {
        const dx = q[0] - centre.x;
        const dy = q[1] - centre.y;
        const d = Math.hypot(dx, dy);
        const v2 = q[2] * q[2] + q[3] * q[3];
        const all = potential(d) - wx * dx - wy * dy;
        return [v2 / 2 + all, dx * q[3] - dy * q[2], v2 + Math.abs(potential(d)) + d * (Math.sqrt(v2) + Math.hypot(wx, wy))];
      }
    }
  }
  verifyEnd(scene, run, slack, complain);
  return complaints;
}

/**
 * A jump begins on the rim of a mouth, ends equally far from the other mouth's centre, and keeps her velocity.
 * @param targets - whether the gun has a target
 */
function verifyJump(
  { level }: Scene,
  run: Run,
  jump: Run['events'][number] & { readonly index: number },
  targets: boolean,
  slack: number,
  complain: (what: string) => void,
): void {
  const isAlone = run.events.every((e) => e === jump || Math.abs(e.time - jump.time) > 2 * JUMP);
  if (!isAlone || jump.time < JUMP || jump.time + JUMP > run.trajectory.duration) return;
  const w = level.wormholes[jump.index];
  const a = new Float64Array(STATE_SIZE);
  const b = new Float64Array(STATE_SIZE);
  run.trajectory.at(jump.time - JUMP, a);
  run.trajectory.at(jump.time + JUMP, b);
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const off = (sign: number) => Math.hypot(dx - sign * (w.toX - w.x), dy - sign * (w.toY - w.y));
  const sign = off(1) < off(-1) ? 1 : -1;
  const from = sign === 1 ? w : { ...w, x: w.toX, y: w.toY };
  const rim = Math.abs(distance(from, a[0], a[1]) - w.radius);
  const at = `through wormhole ${jump.index} at ${jump.time}`;
  if (off(sign) > slack + JUMP_SLACK) complain(`${at} she is moved by ${dx}, ${dy}`);
  if (rim > slack + JUMP_SLACK) complain(`${at} she was ${rim} px from the rim of the mouth`);
  const change = Math.hypot(b[2] - a[2], b[3] - a[3]);
  const turn = Math.hypot(b[4] - a[4], b[5] - a[5]);
  if (change > JUMP_SLACK) complain(`${at} her velocity changes by ${change}`);
  // she turns towards a target at once
  if (!targets && turn > JUMP_SLACK) complain(`${at} she turns by ${turn}`);
}

function verifyEnd(scene: Scene, run: Run, slack: number, complain: (what: string) => void): void {
  const { level } = scene;
  const { x, y, cos, sin } = run.final;
  if (run.outcome === 'timeout' || run.with === null) return;
  const { kind, index } = run.with;
  const moved = new Float64Array(3 * level.aliens.length);
  run.trajectory.aliensAt(run.time, moved);
  let c: { x: number; y: number; radius: number } = level.blackHole;
  if (kind === 'nova') c = level.novae[index];
  if (kind === 'alien') c = { x: moved[3 * index], y: moved[3 * index + 1], radius: level.aliens[index].radius };
  if (kind === 'asteroid') {
    if (level.recoil) return;
    c = level.asteroids[index];
    if (!level.asteroids[index].hot) complain(`burned on cold asteroid ${index}`);
  }
  const gap = boxCircleGap(DEFAULT_BOX, c.x - x, c.y - y, cos, sin, c.radius);
  if (gap > slack) complain(`ended on ${kind} ${index} at ${run.time} s, ${gap} px away from it`);
  // an end during free motion is the first touch; at the start, when a new target turns the box, or after a wormhole, she may
  // be deep inside
  const sudden = run.time === 0 || run.events.some((e) => isSudden(e) && run.time - e.time < 1e-9);
  if (gap < -slack && !sudden) complain(`ended on ${kind} ${index} at ${run.time} s, ${-gap} px deep in it`);
}

const isSudden = (event: Run['events'][number]): boolean =>
  event.type === 'target' || (event.type === 'effect' && event.effect === 'wormholes');

/** The mouth that contains her centre. */
function mouthAt(w: Scene['level']['wormholes'][number], x: number, y: number): MouthState {
  if (distance(w, x, y) < w.radius) return 1;
  return distance({ ...w, x: w.toX, y: w.toY }, x, y) < w.radius ? 2 : 0;
}

/** Whether she is on the rim of a field and moves along it: then neither energy nor angular momentum is conserved. */
function slides(field: Circle, [x, y, vx, vy]: Float64Array): boolean {
  const d = distance(field, x, y);
  const across = ((x - field.x) * vx + (y - field.y) * vy) / d;
  return Math.abs(d - field.radius) < SLIDES && Math.abs(across) < SLIDES;
}

const scale = (scene: Scene): number => Math.abs(scene.level.astronaut.x) + Math.abs(scene.level.astronaut.y) + 1000;

const distance = (c: Circle, x: number, y: number): number => Math.hypot(c.x - x, c.y - y);
