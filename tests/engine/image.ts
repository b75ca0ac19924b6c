import { KINDS, type Level, OBJECT_KINDS, type ObjectKind } from '../../schema/index.ts';

/** The image of a place or a vector. */
export type Turn = (x: number, y: number) => { readonly x: number; readonly y: number };

/** Exchanges left and right. */
export const flipped: Turn = (x, y) => ({ x: 0 - x, y });

/** Exchanges up and down. */
export const upended: Turn = (x, y) => ({ x, y: 0 - y });

/** Exchanges x and y. */
export const swapped: Turn = (x, y) => ({ x: y, y: x });

/** The image of a level: transforms all places and vectors of all objects. */
export function imageOf(level: Level, turn: Turn): Level {
  const all = level as unknown as Readonly<Record<string, unknown>>;
  const images = OBJECT_KINDS.map((kind): [string, unknown] => {
    const { list } = KINDS[kind];
    if (list === null) return [kind, turned(kind, all[kind] as object, turn)];
    return [list, (all[list] as readonly object[]).map((object) => turned(kind, object, turn))];
  });
  return { ...level, ...Object.fromEntries(images) };
}

function turned(kind: ObjectKind, object: object, turn: Turn): object {
  const { places, vectors } = KINDS[kind];
  const numbers = object as Readonly<Record<string, number>>;
  const changes = [...places, ...Object.values(vectors)].flatMap(([x, y]) => {
    const image = turn(numbers[x], numbers[y]);
    return [[x, image.x] as const, [y, image.y] as const];
  });
  return { ...object, ...Object.fromEntries(changes) };
}
