import { boxCircleGap, HALF_DIAGONAL } from '../../engine/index.ts';
import type { StandingCircle } from './blockers.ts';
import type { Cone, Direction } from './proof.ts';
import { distance, surelyLess } from './rounding.ts';
import { LEAST_HALF, type Setting, type Thing } from './setting.ts';

/** Side of the squares that are looked at one by one, px. */
const CELL = 2;

/** So far beside the cone she may be, px: rounding is far below it. */
const BESIDE = 0.01;

/** Hazards count only as deep as this, px: an integrator may take the push of a place just inside. */
const DEEP = 0.05;

/** Tangent of the angle by which a cone is made wider than what was found to push her. */
const MORE = 0.06;

/** Two distances that differ by less are a tie, px. */
const TIE = 1e-7;

/** More squares than this, or cones, and the end is open for all that is known. */
const MOST_CELLS = 1000;
const MOST_CONES = 20;

/** Parts that the directions of a cone are cut into, as a power of two. */
const PARTS = 4;

interface Place {
  readonly x: number;
  readonly y: number;
}

const cross = (a: Place, b: Place): number => a.x * b.y - a.y * b.x;
const dot = (a: Place, b: Place): number => a.x * b.x + a.y * b.y;
const asPlace = ([x, y]: Direction): Place => ({ x, y });

/**
 * From where another asteroid pulls her off the line, her velocity is made of pushes that all lie in a cone, and so she stays in this cone. It is a dead end
 * when, on every way within it, hazards stop her before an asteroid or a field could push her out of it. Her box lies along a direction of the cone, too.
 * @param apex where she leaves the line, px from the start
 * @param ahead the direction in which she does, a unit vector
 * @param before the asteroid that pulled her before
 */
export function findDeadEnd(
  setting: Setting,
  goal: Thing,
  circles: readonly StandingCircle[],
  apex: Place,
  ahead: Place,
  before: number,
): Cone | null {
  // recoil moves the border between two asteroids: she may be overtaken by it
  if (setting.level.recoil || setting.jump > 0) return null;
  let cone: Cone = { from: [ahead.x, ahead.y], to: [ahead.x, ahead.y] };
  for (let round = 0; round < MOST_CONES; round++) {
    const wider = new Flood(setting, goal, circles, apex, before, cone).run();
    if (wider === null) return null;
    if (wider === cone && round > 0) return takesOver(setting, apex, before, cone) ? cone : null;
    cone = withMore(wider);
  }
  return null;
}

/** The cone and a little more on either side: whoever looks at other squares finds its pushes in it, too. */
function withMore({ from, to }: Cone): Cone {
  const turned = ([x, y]: Direction, by: number): Direction => {
    const length = Math.sqrt(1 + by * by);
    return [(x - by * y) / length, (y + by * x) / length];
  };
  return { from: turned(from, -MORE), to: turned(to, MORE) };
}

/** Whether some asteroid is no farther than the one before at the apex, and from there on nearer in every direction of the cone. */
function takesOver({ level: { asteroids, astronaut } }: Setting, apex: Place, before: number, cone: Cone): boolean {
  const here = { x: apex.x + astronaut.x, y: apex.y + astronaut.y };
  const old = asteroids[before];
  return asteroids.some((a, i) => {
    const step = { x: a.x - old.x, y: a.y - old.y };
    const isNear = i !== before && distance(a, here) < distance(old, here) + TIE;
    return isNear && dot(step, asPlace(cone.from)) > 0 && dot(step, asPlace(cone.to)) > 0;
  });
}

/** The cone with one direction more; the same where it has it, null where it would be half of all directions. */
function widened(cone: Cone, direction: Place): Cone | null {
  const from = asPlace(cone.from);
  const to = asPlace(cone.to);
  const middle = { x: from.x + to.x, y: from.y + to.y };
  if (cross(from, direction) >= 0 && cross(direction, to) >= 0 && dot(middle, direction) > 0) return cone;
  const more: Direction = [direction.x, direction.y];
  const wider: Cone = cross(middle, direction) > 0 ? { from: cone.from, to: more } : { from: more, to: cone.to };
  const turn = cross(asPlace(wider.from), asPlace(wider.to));
  return turn > 1e-6 || (turn >= 0 && dot(asPlace(wider.from), asPlace(wider.to)) > 0) ? wider : null;
}

/** Everything she may come through within a cone; what could push her there widens the cone. */
class Flood {
  private readonly setting: Setting;
  private readonly goal: Thing;
  private readonly circles: readonly StandingCircle[];
  private readonly apex: Place;
  private readonly before: number;
  private readonly asteroids: readonly Place[];
  private readonly fields: readonly (Place & { readonly radius: number })[];
  private readonly turns: readonly { readonly middle: Place; readonly chord: number }[];
  private readonly cone: Cone;

  constructor(setting: Setting, goal: Thing, circles: readonly StandingCircle[], apex: Place, before: number, cone: Cone) {
    const { asteroids, repulsors, astronaut } = setting.level;
    this.setting = setting;
    this.goal = goal;
    this.circles = circles;
    this.apex = apex;
    this.before = before;
    this.cone = cone;
    const place = ({ x, y }: Place) => ({ x: x - astronaut.x, y: y - astronaut.y });
    this.asteroids = asteroids.map(place);
    this.fields = repulsors.map((field) => ({ ...place(field), radius: field.radius }));
    this.turns = turnsOf(asPlace(cone.from), asPlace(cone.to), PARTS);
  }

  /** The cone itself when nothing widens it and nothing is open; a wider one; or null. */
  run(): Cone | null {
    const seen = new Set<string>();
    const waiting: [number, number][] = [];
    const visit = (i: number, j: number) => {
      const key = `${i} ${j}`;
      if (seen.has(key)) return;
      seen.add(key);
      waiting.push([i, j]);
    };
    for (const i of [-1, 0]) for (const j of [-1, 0]) visit(i, j);
    let cone: Cone | null = this.cone;
    for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
      if (seen.size > MOST_CELLS) return null;
      const [i, j] = next;
      const piece = this.piece(i, j);
      if (piece.length === 0 || this.isOver(piece)) continue;
      if (piece.some((p) => !surelyLess(this.goal.touch + 2 * CELL, distance(p, this.goal)))) return null;
      for (const direction of this.pushes(piece)) {
        cone = direction === null || cone === null ? null : widened(cone, direction);
        if (cone === null) return null;
      }
      visit(i + 1, j);
      visit(i - 1, j);
      visit(i, j + 1);
      visit(i, j - 1);
    }
    return cone;
  }

  /** What of a square lies in the cone: the corners of a convex polygon, px from the start. */
  private piece(i: number, j: number): Place[] {
    const from = asPlace(this.cone.from);
    const to = asPlace(this.cone.to);
    const middle = { x: from.x + to.x, y: from.y + to.y };
    const corner = (a: number, b: number) => ({ x: (i + a) * CELL, y: (j + b) * CELL });
    const sides = [(p: Place) => cross(from, p), (p: Place) => cross(p, to), (p: Place) => dot(middle, p)];
    const square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    const inside = sides.reduce((polygon, side) => cutOff(polygon, (p) => side(p) + BESIDE), square);
    return inside.map((p) => ({ x: p.x + this.apex.x, y: p.y + this.apex.y }));
  }

  /** Whether every place of a piece ends the run, however her box lies: in one hazard, or out of range. */
  private isOver(piece: readonly Place[]): boolean {
    const reach = this.setting.level.range + 2 * CELL;
    if (this.asteroids.every((a) => piece.every((p) => surelyLess(reach, distance(a, p))))) return true;
    return this.circles.some((circle) => {
      const far = piece.reduce((most, p) => Math.max(most, distance(p, circle)), 0);
      if (far < circle.radius + LEAST_HALF - DEEP) return true;
      if (far > circle.radius + HALF_DIAGONAL) return false;
      return this.turns.every(({ middle, chord }) =>
        piece.every(
          (p) => boxCircleGap(circle.x - p.x, circle.y - p.y, middle.x, middle.y, circle.radius) < -DEEP - HALF_DIAGONAL * chord,
        ),
      );
    });
  }

  /** The directions in which the gun or a field may push her in a piece; null where that is any. */
  private *pushes(piece: readonly Place[]): Generator<Place | null> {
    for (const [i, asteroid] of this.asteroids.entries()) {
      // in the cone the one before is never the nearest
      if (i === this.before || !this.mayBeNearest(i, piece)) continue;
      yield* directions(piece, asteroid, 1);
    }
    for (const field of this.fields) {
      if (piece.every((p) => surelyLess(field.radius + 2 * CELL, distance(p, field)))) continue;
      yield* directions(piece, field, -1);
    }
  }

  /** Squared distances to two asteroids differ by something linear: what holds at the corners holds in the piece. */
  private mayBeNearest(i: number, piece: readonly Place[]): boolean {
    return !this.asteroids.some(
      (other, k) =>
        k !== i && k !== this.before && piece.every((p) => surelyLess(distance(p, other), distance(p, this.asteroids[i]))),
    );
  }
}

/** The directions from the corners of a piece towards a place, or away from it; null where the place is too near to tell. */
function* directions(piece: readonly Place[], to: Place, sign: number): Generator<Place | null> {
  for (const p of piece) {
    const d = distance(p, to);
    if (d < 2 * CELL) yield null;
    else yield { x: (sign * (to.x - p.x)) / d, y: (sign * (to.y - p.y)) / d };
  }
}

/** A polygon without what lies where `side` is negative. */
function cutOff(polygon: readonly Place[], side: (p: Place) => number): Place[] {
  return polygon.flatMap((a, i) => {
    const b = polygon[(i + 1) % polygon.length];
    const sa = side(a);
    const sb = side(b);
    const kept = sa >= 0 ? [a] : [];
    if (sa >= 0 === sb >= 0) return kept;
    const t = sa / (sa - sb);
    return [...kept, { x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y) }];
  });
}

/** The directions between two, in parts: the middle of each, and how far its ends are from that. */
function turnsOf(from: Place, to: Place, halvings: number): { middle: Place; chord: number }[] {
  const sum = { x: from.x + to.x, y: from.y + to.y };
  const length = Math.sqrt(dot(sum, sum));
  const middle = { x: sum.x / length, y: sum.y / length };
  if (halvings === 0) return [{ middle, chord: Math.max(distance(middle, from), distance(middle, to)) }];
  return [...turnsOf(from, middle, halvings - 1), ...turnsOf(middle, to, halvings - 1)];
}
