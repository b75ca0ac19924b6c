import { type AccuracyName, boxCircleGap, boxOf, compile, simulate, TICK_RATE } from '../../engine/index.ts';
import { type Level, rulesOf } from '../../schema/index.ts';
import type { About } from '../../solver/index.ts';
import type { Play, Pose } from './plays.ts';
import { AWAY } from './styles.ts';

type Circle = Level['novae'][number];

/** A level and an object in it that a run touches: a proof that it cannot be touched is wrong. */
export interface FalseClaim {
  readonly level: Level;
  readonly about: About;
  readonly play: Play;
}

/** Her box in a level. */
const boxIn = (level: Level) => boxOf(rulesOf(level));

/** A circle that just overlaps a corner or an edge of her box in a pose, from outside. */
export function thingAt(level: Level, { x, y, cos, sin }: Pose, random: () => number): Circle {
  const { halfWidth, halfHeight } = boxIn(level);
  const pick = (...of: number[]) => of[Math.floor(random() * of.length)];
  const radius = pick(0.5, 2, 7, 18);
  const depth = pick(1e-3, 0.02, 0.3);
  const sideX = pick(-1, 1);
  const sideY = pick(-1, 1);
  const turn = (random() * Math.PI) / 2;
  // the corner, or a place on one of its two edges
  const edge = random();
  const along = edge < 0.2 ? halfWidth * random() : halfWidth;
  const across = edge > 0.8 ? halfHeight * random() : halfHeight;
  const outX = along < halfWidth ? 0 : across < halfHeight ? 1 : Math.cos(turn);
  const outY = across < halfHeight ? 0 : along < halfWidth ? 1 : Math.sin(turn);
  const px = sideX * (along + outX * (radius - depth));
  const py = sideY * (across + outY * (radius - depth));
  return { id: null, x: x + px * cos - py * sin, y: y + px * sin + py * cos, radius };
}

/**
 * A circle so close to a centre that her box touches it as it passes, unless the box points along the direction from the centre
 * to it.
 */
export function thingBeside(level: Level, random: () => number): Circle {
  const { x, y } = level.asteroids[0];
  const { x: sx, y: sy } = level.astronaut;
  const { halfHeight, halfDiagonal } = boxIn(level);
  const d = Math.hypot(x - sx, y - sy) || 1;
  const radius = random() < 0.5 ? 7 : 18;
  const far = (random() < 0.5 ? -1 : 1) * (radius + halfHeight - 0.01 + 1.01 * (halfDiagonal - halfHeight) * random());
  const off = 4 * (random() - 0.5);
  const [ux, uy] = [(x - sx) / d, (y - sy) / d];
  return { id: null, x: x + off * ux - far * uy, y: y + off * uy + far * ux, radius };
}

/** Some of a play's poses: the first and the last, the outermost in each direction, and others. */
export function somePoses({ poses }: Play, random: () => number, count: number): Pose[] {
  if (poses.length === 0) return [];
  const farthest = (turn: number) => {
    const [ux, uy] = [Math.cos(turn), Math.sin(turn)];
    return poses.reduce((a, b) => (b.x * ux + b.y * uy > a.x * ux + a.y * uy ? b : a));
  };
  const anyOf = (n: number) => poses[Math.floor(random() * n)];
  return Array.from({ length: count }, (_, n) =>
    n % 3 === 0
      ? farthest(6.2832 * random())
      : n % 3 === 1
        ? anyOf(poses.length)
        : poses[poses.length - 1 - Math.floor(random() ** 3 * poses.length)],
  );
}

/**
 * The claims about those objects that the play really touches, every other one about the black hole; and how many it touched.
 */
export function trueTouches(level: Level, accuracy: AccuracyName, play: Play, things: readonly Circle[]): FalseClaim[] {
  const last = play.poses[play.poses.length - 1]?.tick ?? 0;
  const run = simulate(compile({ ...level, minerals: things }, accuracy), play.holds, { maxTime: (last + 2) / TICK_RATE });
  const touched = new Map(run.minerals.map(({ index, time }) => [index, time]));
  return things.flatMap((thing, i): FalseClaim[] => {
    const time = touched.get(i);
    if (time === undefined) return [];
    if (i % 2 === 0) return [{ level: { ...level, minerals: [thing] }, about: { kind: 'mineral', index: 0 }, play }];
    const claim: FalseClaim = { level: { ...level, blackHole: thing }, about: { kind: 'blackHole' }, play };
    // an object touched in the instant of the end need not complete the level
    return time < run.time - 1e-9 || run.outcome === 'timeout' || isFalse(claim, accuracy) ? [claim] : [];
  });
}

/** Whether the script of a claim really touches the object of the claim. */
export function isFalse({ level, about, play }: FalseClaim, accuracy: AccuracyName): boolean {
  const last = play.poses[play.poses.length - 1].tick;
  const run = simulate(compile(level, accuracy), play.holds, { maxTime: (last + 2) / TICK_RATE });
  return about.kind === 'blackHole' ? run.outcome === 'completed' : run.minerals.some(({ index }) => index === about.index);
}

/**
 * Novae around the object and beside her path, as large as possible without touching her before she reaches it, so that they
 * almost shut her out. In the second level they are larger, and perhaps shut her out.
 */
export function hugged(claim: FalseClaim, closely: boolean, random: () => number): { near: FalseClaim; shut: Level } {
  const { level, about, play } = claim;
  const thing = about.kind === 'blackHole' ? level.blackHole : level.minerals[about.index];
  const { poses } = play;
  const box = boxIn(level);
  const novae: Circle[] = [];
  const room = random() < 0.5 ? 0.05 : 0.6;
  const around = closely ? thing.radius + 8 : random() < 0.6 ? 30 : 90;
  for (let n = (closely ? 5 : 2) + Math.floor(random() * 6); n > 0; n--) {
    const from = closely || random() < 0.7 ? thing : poses[Math.floor(random() * poses.length)];
    const turn = 6.2832 * random();
    const far = around * Math.sqrt(random());
    const c = { x: from.x + far * Math.cos(turn), y: from.y + far * Math.sin(turn) };
    const gap = poses.reduce(
      (least, p) => Math.min(least, boxCircleGap(box, c.x - p.x, c.y - p.y, p.cos, p.sin, 0)),
      Number.POSITIVE_INFINITY,
    );
    const radius = gap - room;
    if (radius > 0.5 && radius < 200) novae.push({ id: null, ...c, radius });
  }
  const larger = novae.map((c) => ({ ...c, radius: c.radius + 1 + room }));
  const all = (more: readonly Circle[]): Level => ({ ...level, novae: [...level.novae, ...more] });
  return { near: { level: all(novae), about, play }, shut: all(larger) };
}

/** The same level with the object far away. */
export function withoutThing({ level, about }: FalseClaim): Level {
  return about.kind === 'blackHole' ? { ...level, blackHole: AWAY } : { ...level, minerals: [AWAY] };
}
