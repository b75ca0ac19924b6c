import Flatbush from 'flatbush';
import {
  appearanceOfObject,
  type Disc,
  KINDS,
  type Level,
  LISTED_KINDS,
  type ListedKind,
  listOf,
  OBJECT_LISTS,
  type ObjectList,
  objectName,
  objectsIn,
  type Place,
} from '../../schema/basics/index.ts';
import { ALL_EFFECTS } from '../effects/index.ts';

/** A solid circle of a level, which she may touch. Lengths are in px. */
export interface Body {
  readonly kind: ListedKind | 'blackHole';
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  /** Index within the level's list of that kind, from 0. */
  readonly index: number;
  /** Its name in a sentence: `nova 3`, `the black hole`. */
  readonly name: string;
  /** Whether touching it ends a run with `collided`. */
  readonly isHazard: boolean;
  /** Whether it stays where the level places it during a whole run. */
  readonly staysPut: boolean;
}

/** A body whose name is made when somebody reads it: few are named. */
class LevelBody implements Body {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly isHazard: boolean;
  readonly #object: Disc;

  constructor(
    readonly kind: ListedKind,
    readonly index: number,
    object: Disc,
    readonly staysPut: boolean,
  ) {
    this.x = object.x;
    this.y = object.y;
    this.radius = object.radius;
    this.isHazard = appearanceOfObject(kind, object).deadly;
    this.#object = object;
  }

  get name(): string {
    return objectName(this.kind, this.index, this.#object);
  }
}

/** The kinds of which an object can be deadly: all their objects are drawn solid. */
const SOLID = LISTED_KINDS.filter((kind) => KINDS[kind].deadly || KINDS[kind].variant?.deadly === true);

/** The solid objects of a level in the order of a file, then the black hole. */
export function bodiesOf(level: Level): Body[] {
  const bodies: Body[] = [];
  for (const kind of SOLID) {
    const chases = ALL_EFFECTS.hasChaser(kind);
    // recoil moves what the gun targets
    const stays = !chases && !(kind === 'asteroid' && level.recoil);
    const objects = objectsIn(level, kind);
    for (let i = 0; i < objects.length; i++) bodies.push(new LevelBody(kind, i, objects[i], stays));
  }
  const { x, y, radius } = level.blackHole;
  bodies.push({ kind: 'blackHole', x, y, radius, index: 0, name: 'the black hole', isHazard: false, staysPut: true });
  return bodies;
}

/** The JSON pointer of a body in the level file. */
export const pointerOf = ({ kind, index }: Body): string => (kind === 'blackHole' ? '/blackHole' : `/${listOf(kind)}/${index}`);

/** A length in words: px with at most three decimals. */
export const px = (length: number): string => `${Math.round(length * 1000) / 1000} px`;

/** Distance between two places, px. */
export function distance(a: Place, b: Place): number {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** Whether the whole of `disc` lies inside `by`, so that touching the one means touching the other. */
export const covers = (by: Disc, disc: Disc): boolean => distance(by, disc) + disc.radius <= by.radius;

/**
 * For each list of a level: the indices of objects at exactly the place of an earlier one in the list, each with that one's
 * index.
 */
export type Copies = Readonly<Record<ObjectList, ReadonlyMap<number, number>>>;

const NONE: ReadonlyMap<number, number> = new Map();

const copiesBy = (find: (list: ObjectList) => ReadonlyMap<number, number>): Copies =>
  Object.fromEntries(OBJECT_LISTS.map((list) => [list, find(list)])) as Record<ObjectList, ReadonlyMap<number, number>>;

/** Those of nearly every level. */
const NO_COPIES: Copies = copiesBy(() => NONE);

export const copiesOf = (level: Level): Copies =>
  OBJECT_LISTS.every((list) => copiesIn(level[list]) === NONE) ? NO_COPIES : copiesBy((list) => copiesIn(level[list]));

function copiesIn(list: readonly Place[]): ReadonlyMap<number, number> {
  if (list.length < INDEX_FROM && !hasCopies(list)) return NONE;
  const order = [...list.keys()].sort((a, b) => list[a].x - list[b].x || list[a].y - list[b].y || a - b);
  const copies: [number, number][] = [];
  let first = order[0];
  for (const i of order.slice(1)) {
    if (list[i].x === list[first].x && list[i].y === list[first].y) copies.push([i, first]);
    else first = i;
  }
  return copies.length === 0 ? NONE : new Map(copies.sort((a, b) => a[0] - b[0]));
}

function hasCopies(list: readonly Place[]): boolean {
  for (let i = 1; i < list.length; i++) {
    const { x, y } = list[i];
    for (let k = 0; k < i; k++) if (list[k].x === x && list[k].y === y) return true;
  }
  return false;
}

// for fewer discs than this, comparing all pairs is faster than building an index
const INDEX_FROM = 64;

// thousands of discs in one place have millions of pairs; beyond this many the search gives up instead of hanging
const MAX_CANDIDATES = 2_000_000;

/**
 * Yields pairs of overlapping discs of one list, the earlier in the list first. Touching from outside is no overlap. Lazy: the
 * search goes only as far as pairs are requested.
 */
export function* overlaps<T extends Disc>(discs: readonly T[]): Generator<readonly [T, T]> {
  if (discs.length < INDEX_FROM) {
    for (let i = 0; i < discs.length; i++) {
      for (let j = i + 1; j < discs.length; j++) if (overlap(discs[i], discs[j])) yield [discs[i], discs[j]];
    }
    return;
  }
  const near = finderOf(discs);
  let candidates = 0;
  for (const [i, a] of discs.entries()) {
    for (const j of near(a)) {
      if (++candidates > MAX_CANDIDATES) return;
      if (j > i && overlap(a, discs[j])) yield [a, discs[j]];
    }
  }
}

/** Yields pairs of a disc of one list and a disc of another that overlap, in the order of the first list. Also lazy. */
export function* overlapsBetween<T extends Disc, U extends Disc>(
  discs: readonly T[],
  others: readonly U[],
): Generator<readonly [T, U]> {
  const near = finderOf(others);
  let candidates = 0;
  for (const a of discs) {
    for (const j of near(a)) {
      if (++candidates > MAX_CANDIDATES) return;
      if (overlap(a, others[j])) yield [a, others[j]];
    }
  }
}

/** Returns a function that finds the discs which may overlap a given one: their indices, ascending. */
function finderOf(discs: readonly Disc[]): (disc: Disc) => readonly number[] {
  if (discs.length < INDEX_FROM) {
    const all = [...discs.keys()];
    return () => all;
  }
  const index = new Flatbush(discs.length);
  for (const { x, y, radius } of discs) index.add(x - radius, y - radius, x + radius, y + radius);
  index.finish();
  return ({ x, y, radius }) => index.search(x - radius, y - radius, x + radius, y + radius).sort((a, b) => a - b);
}

function overlap(a: Disc, b: Disc): boolean {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  const reach = a.radius + b.radius;
  return dx * dx + dy * dy < reach * reach;
}
