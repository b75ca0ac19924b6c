import type { Box } from '../../engine/index.ts';
import type { Disc, Place } from '../../schema/basics/index.ts';
import type { DeadEnd } from '../prove/index.ts';
import { speedAfter, unlimited } from './assumptions.ts';
import { type Claim, mouthsOf, standingHazard } from './claim.ts';
import { apart, boxGap, less, unit } from './geometry.ts';

/** Hazards are tested for pieces of this length across, px. */
const STRIP = 1;

/** How far beside the line she may be when she leaves it, px, and the error of her direction as a slope. */
const BESIDE = 0.005;
const ASKEW = 1e-7;

/** A hazard counts from this depth on, px. */
const DEPTH = 0.02;

/** Every bound is rounded outwards by this, px. */
const ROUNDING = 1e-7;

/** Two asteroids are equally near if their distances differ by less than this, px. */
const EQUAL = 1e-6;

/** A push from closer than this may have any direction, px. */
const CLOSE = 0.4;

/** The steepest slope that is followed, and the most stages. */
const STEEP = 8;
const MOST = 20_000;

/** Ranges of directions of her box with a smaller chord are not divided any further. */
const FINEST_TURN = 0.0005;

/** All numbers between two. */
type Interval = readonly [number, number];

/** A place across the axis, px, and the slope of her path to the axis. */
interface Crossing {
  readonly place: number;
  readonly slope: number;
}

/** The set of states in which she may cross a line: the convex hull of some ways, and the slopes of the x axis of her box. */
interface Stage {
  readonly ways: readonly Crossing[];
  readonly box: Interval;
}

/** A centre that pulls or pushes her at the places across from `low` to `high`. */
interface Source {
  readonly at: Place;
  readonly pulls: boolean;
  readonly low: number;
  readonly high: number;
}

/** Where she leaves the line along which she fell. */
export interface Leaving {
  /** The place, px from the start. */
  readonly apex: Place;
  /** Her direction, a unit vector. */
  readonly ahead: Place;
  /** Index of the asteroid that has pulled her so far. */
  readonly before: number;
  /** Length of the line, px. */
  readonly length: number;
}

/**
 * Checks a dead end: everything that she may do beyond the apex ends at hazards or out of range, and never comes near the
 * object.
 *
 * The invariant is that every push beyond the apex points forward along the axis, and so does her motion. Her velocity is a sum
 * of the earlier one and of pushes, all with positive weights, so her slope always lies between slopes that it had and slopes
 * of pushes (lemma `slopes`). The sets of places and slopes on successive lines across the axis are therefore computed as
 * convex hulls, and hazards cut parts off, until nothing is left. With every slope that occurs she comes nearer to the new
 * asteroid faster than to the old one, so the old one never becomes the nearest again (lemma `leaving`). It holds only for
 * integrators whose error is below the margins: a fixed step may be pushed as at a place some px away, where slopes differ.
 */
export function checkDeadEnd(claim: Claim, { axis, step }: DeadEnd, { apex, ahead, before, length }: Leaving): string | null {
  // A fixed step may use the push of a place some px away, where pushes have other slopes.
  if (claim.steps) return 'with fixed steps her path may turn further than the pushes there allow';
  if (claim.level.recoil) return 'with recoil the border between two asteroids moves';
  if (claim.frames) return 'with frames she may jump over the border between two asteroids';
  if (!Array.isArray(axis) || axis.length !== 2 || !(Math.abs(axis[0] * axis[0] + axis[1] * axis[1] - 1) < 1e-9))
    return 'its axis is not a direction';
  if (!(typeof step === 'number' && step >= 0.25 && step <= 4)) return 'its step is not valid';
  const scene = sceneAlong(claim, axis, apex, before);
  const along = ahead.x * axis[0] + ahead.y * axis[1];
  const start = (ahead.y * axis[0] - ahead.x * axis[1]) / along;
  if (!(along > 0 && Math.abs(start) <= STEEP)) return 'she does not move along its axis';

  let slopes: Interval = [start - ASKEW, start + ASKEW];
  const first = [-BESIDE, BESIDE].flatMap((place) => slopes.map((slope) => ({ place, slope })));
  let stages: Stage[] = [{ ways: first, box: slopes }];
  let looked = 0;
  let farthest = 0;
  for (let n = 0; stages.length > 0; n++) {
    const next: Stage[] = [];
    for (const stage of stages) {
      // An energy bound: from rest, no two places of the line and of the dead end are farther apart than this, which bounds her
      // speed.
      for (const { place } of stage.ways) farthest = Math.max(farthest, Math.abs(place) + (n + 1 + STEEP) * step);
      if (!less(speedAfter(claim.push, length + 2 * farthest), unlimited(claim.rules, claim.push)))
        return 'she may reach the speed limit';
      if (++looked > MOST) return 'following her takes too many stages';
      const after = follow(scene, stage, n * step, step);
      if (typeof after === 'string') return after;
      slopes = hull(slopes, extent(after.ways.map(({ slope }) => slope)));
      next.push(...survivors(scene, after, (n + 1) * step));
    }
    stages = next;
  }
  const { takers, old } = scene;
  const goesOn = (taker: Place) => slopes.every((slope) => less(old.x + slope * old.y, taker.x + slope * taker.y));
  return takers.some(goesOn) ? null : 'the previous asteroid may be the nearest again';
}

interface Scene {
  readonly box: Box;
  readonly inner: number;
  readonly thing: Place;
  readonly touch: number;
  readonly range: number;
  readonly rocks: readonly Place[];
  /** The old asteroid, and those that are equally near at the apex. */
  readonly old: Place;
  readonly takers: readonly Place[];
  readonly pulling: readonly Place[];
  readonly fields: readonly Disc[];
  readonly hazards: readonly Disc[];
  /** Winds and mouths of wormholes, with which this argument does not deal. */
  readonly strange: readonly Disc[];
}

/** The level as seen from the apex: x along the axis, y across. */
function sceneAlong(claim: Claim, [ux, uy]: readonly [number, number], apex: Place, before: number): Scene {
  const { level, place } = claim;
  const seen = ({ x, y }: Place): Place => {
    const dx = x - apex.x;
    const dy = y - apex.y;
    return { x: dx * ux + dy * uy, y: dy * ux - dx * uy };
  };
  const rocks = level.asteroids.map((rock) => seen(place(rock)));
  const old = rocks[before];
  const isOther = (_: unknown, i: number) => i !== before;
  const origin = { x: 0, y: 0 };
  const refs = [
    ...level.novae.map((_, index) => ({ kind: 'nova' as const, index })),
    ...level.asteroids.map((_, index) => ({ kind: 'asteroid' as const, index })),
    { kind: 'blackHole' as const, index: 0 },
  ];
  return {
    box: claim.box,
    inner: claim.inner,
    thing: seen(claim.thing),
    touch: claim.touch,
    range: level.range,
    rocks,
    old,
    takers: rocks.filter((rock, i) => isOther(rock, i) && apart(rock, origin) <= apart(old, origin) + EQUAL),
    pulling: rocks.filter(isOther),
    fields: level.repulsors.map((field) => ({ ...seen(place(field)), radius: field.radius })),
    strange: [...level.winds.map(place), ...mouthsOf(claim)].map((disc) => ({ ...seen(disc), radius: disc.radius })),
    hazards: refs.flatMap((ref) => {
      const hazard = standingHazard(claim, ref);
      return hazard === null ? [] : [{ ...seen(hazard), radius: hazard.radius }];
    }),
  };
}

/** The stage one step on, or why it cannot be determined. */
function follow(scene: Scene, { ways, box }: Stage, x: number, step: number): Stage | string {
  const [low, high] = extent(ways.map(({ place }) => place));
  const steepest = (list: readonly Crossing[]) => list.reduce((most, { slope }) => Math.max(most, Math.abs(slope)), 0);
  let swing = step * steepest(ways) + ROUNDING;
  for (;;) {
    const mayEnter = ({ radius, ...c }: Disc) => {
      const beside = { x: Math.max(0, x - c.x, c.x - x - step), y: Math.max(0, low - swing - c.y, c.y - high - swing) };
      return !less(radius + DEPTH, apart(beside, { x: 0, y: 0 }));
    };
    if (scene.strange.some(mayEnter)) return 'a wind or a wormhole may take her off her path';
    const sources = sourcesWithin(scene, x, step, low - swing, high + swing);
    if (sources === null) return 'something may push her back along its axis';
    const after = widened(ways, x, step, swing, sources);
    const most = steepest(after.ways);
    if (most > STEEP) return 'she may turn away from its axis';
    if (step * most > swing) {
      swing = step * most * 1.002;
      continue;
    }
    const dx = Math.max(0, x - scene.thing.x, scene.thing.x - x - step);
    const dy = Math.max(0, low - swing - scene.thing.y, scene.thing.y - high - swing);
    if (!less(scene.touch, Math.sqrt(dx * dx + dy * dy))) return 'she may touch it off the line';
    return { ways: after.ways, box: after.turned.reduce(hull, box) };
  }
}

/**
 * Everything that may push her between x and x + step, at places across from `low` to `high`; null when something may push her
 * back.
 */
function sourcesWithin(scene: Scene, x: number, step: number, low: number, high: number): Source[] | null {
  const corners = [x, x + step].flatMap((cx) => [low, high].map((cy) => ({ x: cx, y: cy })));
  const sources: Source[] = [];
  for (const field of scene.fields) {
    const nearest = { x: Math.max(x, Math.min(x + step, field.x)), y: Math.max(low, Math.min(high, field.y)) };
    if (less(field.radius, apart(field, nearest))) continue;
    if (x - field.x < CLOSE) return null;
    sources.push({ at: field, pulls: false, low, high });
  }
  // What is farther away than another from all four corners is farther away from everywhere between them.
  const inside = scene.pulling.filter(
    (rock) => !scene.pulling.some((other) => other !== rock && corners.every((c) => less(apart(c, other), apart(c, rock)))),
  );
  for (const rock of inside) {
    let from = low;
    let to = high;
    for (const other of inside) {
      // p is no farther from the rock than from the other where (p - middle) (other - rock) <= 0.
      const way = { x: other.x - rock.x, y: other.y - rock.y };
      const middle = { x: (other.x + rock.x) / 2, y: (other.y + rock.y) / 2 };
      const slack = 1e-11 * (Math.abs(way.x) + Math.abs(way.y)) * (Math.abs(middle.x) + Math.abs(middle.y) + x);
      const left = way.x * (middle.x - (way.x > 0 ? x : x + step)) + slack;
      if (way.y > 0) to = Math.min(to, middle.y + left / way.y + ROUNDING);
      if (way.y < 0) from = Math.max(from, middle.y + left / way.y - ROUNDING);
      if (way.y === 0 && left < 0) to = Number.NEGATIVE_INFINITY;
    }
    if (from > to) continue;
    if (rock.x - x - step < CLOSE) return null;
    sources.push({ at: rock, pulls: true, low: from, high: to });
  }
  return sources;
}

/**
 * From a place with a slope, while pushes have slopes from s to t, she comes to slopes between her own and [s, t], and leaves
 * that interval never again. Her place moves by the step times the mean slope. The hull of the extremes contains all of it,
 * because they are linear in place and slope.
 */
function widened(ways: readonly Crossing[], x: number, step: number, swing: number, sources: readonly Source[]) {
  const [low, high] = extent(ways.map(({ place }) => place));
  const next: Crossing[] = ways.map(({ place, slope }) => ({ place: place + step * slope, slope }));
  const turned: Interval[] = [];
  const borders = new Set([low, high]);
  for (const source of sources) {
    for (const border of [source.low - swing, source.high + swing]) if (border > low && border < high) borders.add(border);
  }
  const ordered = [...borders].sort((a, b) => a - b);
  if (ordered.length === 1) ordered.push(ordered[0]);
  for (let i = 1; i < ordered.length; i++) {
    const [a, b] = [ordered[i - 1], ordered[i]];
    const acting = sources.filter((source) => source.low - swing <= a && source.high + swing >= b);
    const slopesAt = (place: number, of: readonly Source[]): Interval =>
      of
        .flatMap(({ at, pulls }) => {
          const off = swing / (pulls ? at.x - x - step : x - at.x) + ROUNDING;
          const here = (at.y - place) / (at.x - x);
          const there = (at.y - place) / (at.x - x - step);
          return [[Math.min(here, there) - off, Math.max(here, there) + off] as const];
        })
        .reduce(hull);
    if (acting.length === 0) continue;
    const part = within(ways, a, b);
    for (const { place, slope } of part) {
      for (const s of slopesAt(place, acting)) next.push({ place: place + step * slope, slope: s });
    }
    for (const place of extent(part.map((way) => way.place))) {
      const ends = slopesAt(place, acting);
      for (const mean of ends) for (const slope of ends) next.push({ place: place + step * mean, slope });
      const pulling = acting.filter(({ pulls }) => pulls);
      if (pulling.length > 0) turned.push(slopesAt(place, pulling));
    }
  }
  return { ways: corners(next), turned };
}

/** The parts of a stage that no hazard stops when she comes to x, and that are still in range. */
function survivors(scene: Scene, { ways, box }: Stage, x: number): Stage[] {
  const [low, high] = extent(ways.map(({ place }) => place));
  const near = scene.hazards.filter((hazard) => Math.abs(hazard.x - x) <= hazard.radius + scene.box.halfDiagonal);
  const [from, to] = box.map((slope) => unit({ x: 1, y: slope }));
  const isStopped = (a: Place, b: Place): boolean => {
    if (near.some((hazard) => stops(scene, hazard, a, b, from, to))) return true;
    return scene.rocks.every((rock) => {
      const nearest = { x, y: Math.max(a.y, Math.min(b.y, rock.y)) };
      return less(scene.range + DEPTH, apart(rock, nearest));
    });
  };
  const stages: Stage[] = [];
  let open: number | null = null;
  const close = (to: number) => {
    if (open !== null) stages.push({ ways: within(ways, open, to), box });
    open = null;
  };
  for (let y = low; ; ) {
    const end = Math.min(high, (Math.floor(y / STRIP + 1e-9) + 1) * STRIP);
    if (isStopped({ x, y }, { x, y: end })) close(y);
    else open ??= y;
    if (end >= high) break;
    y = end;
  }
  close(high);
  return stages;
}

/** Whether a hazard overlaps her box at all places between two, with its axis in any direction between two unit vectors. */
function stops(scene: Scene, hazard: Disc, a: Place, b: Place, from: Place, to: Place): boolean {
  const { halfDiagonal } = scene.box;
  const far = Math.max(apart(a, hazard), apart(b, hazard));
  if (less(far, hazard.radius + scene.inner - DEPTH)) return true;
  if (far > hazard.radius + halfDiagonal) return false;
  const middle = unit({ x: from.x + to.x, y: from.y + to.y });
  const off = Math.max(apart(middle, from), apart(middle, to));
  const worst = Math.max(boxGap(scene.box, a, middle, hazard), boxGap(scene.box, b, middle, hazard));
  if (less(worst + halfDiagonal * off, -DEPTH)) return true;
  if (worst > -DEPTH || off < FINEST_TURN) return false;
  return stops(scene, hazard, a, b, from, middle) && stops(scene, hazard, a, b, middle, to);
}

/** The part of a hull between two places. */
function within(ways: readonly Crossing[], low: number, high: number): Crossing[] {
  const [least, most] = extent(ways.map(({ place }) => place));
  if (low <= least && high >= most) return [...ways];
  const inside = ways.filter(({ place }) => place >= low && place <= high);
  // At each cut, the least and the greatest slope on all segments between two of the ways.
  for (const cut of [low, high]) {
    if (cut < least || cut > most) continue;
    const slopes: number[] = [];
    for (const p of ways) {
      if (p.place === cut) slopes.push(p.slope);
      for (const q of ways) {
        if (p.place < cut && q.place > cut) slopes.push(p.slope + ((cut - p.place) / (q.place - p.place)) * (q.slope - p.slope));
      }
    }
    for (const slope of extent(slopes)) inside.push({ place: cut, slope });
  }
  return inside;
}

/** The corners of the hull: the ways that do not lie between others. */
function corners(ways: readonly Crossing[]): Crossing[] {
  const least = ways.reduce((a, b) => (b.place < a.place || (b.place === a.place && b.slope < a.slope) ? b : a));
  const most = ways.reduce((a, b) => (b.place > a.place || (b.place === a.place && b.slope > a.slope) ? b : a));
  const beyond = (a: Crossing, b: Crossing, list: readonly Crossing[]): Crossing[] => {
    const height = (p: Crossing) => (b.place - a.place) * (p.slope - a.slope) - (b.slope - a.slope) * (p.place - a.place);
    const above = list.filter((p) => height(p) > 0);
    if (above.length === 0) return [];
    const top = above.reduce((p, q) => (height(q) > height(p) ? q : p));
    return [...beyond(a, top, above), top, ...beyond(top, b, above)];
  };
  return [least, ...beyond(least, most, ways), most, ...beyond(most, least, ways)];
}

const hull = (a: Interval, b: Interval): Interval => [Math.min(a[0], b[0]), Math.max(a[1], b[1])];

const extent = (values: readonly number[]): Interval =>
  values.reduce<Interval>((span, value) => hull(span, [value, value]), [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]);
