import type { Card, Chapter } from './pack-model.ts';

/** A move of entries, as `moveEntries` takes it. */
export interface Move {
  /** The places of what is moved, ascending. */
  readonly moved: readonly number[];
  /** The place before which it goes. */
  readonly before: number;
}

/** The number of entries, with headings. */
export const countOf = (chapters: readonly Chapter[]): number =>
  chapters.reduce((sum, { place, cards }) => sum + cards.length + (place === null ? 0 : 1), 0);

/** The places of some cards, ascending. */
export const placesOf = (cards: readonly Card[], keys: ReadonlySet<string>): number[] =>
  cards.filter(({ key }) => keys.has(key)).map(({ place }) => place);

/**
 * The move that a key asks for: by one entry, which may be a heading, or to an end.
 * @param count the number of entries
 * @returns null if they are there already
 */
export function moveByKey(places: readonly number[], key: string, count: number): Move | null {
  const first = places[0];
  const last = places[places.length - 1];
  if (first === undefined || last === undefined) return null;
  const isTogether = last - first === places.length - 1;
  const to = (before: number): Move => ({ moved: places, before });
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowUp':
      return first > 0 ? to(first - 1) : isTogether ? null : to(0);
    case 'ArrowRight':
    case 'ArrowDown':
      return last < count - 1 ? to(last + 2) : isTogether ? null : to(count);
    case 'Home':
      return first === 0 && isTogether ? null : to(0);
    case 'End':
      return last === count - 1 && isTogether ? null : to(count);
    default:
      return null;
  }
}

/** What a move is called, in undo and in words. */
export function moveInWords(cards: readonly Card[], moved: readonly number[]): string {
  const names = cards.filter(({ place }) => moved.includes(place)).map(({ entry, id }) => entry?.name ?? id);
  return names.length === 1 ? `Move "${names[0]}"` : `Move ${names.length} levels`;
}

/** Where something stands on the screen, px. */
interface Spot {
  readonly left: number;
  readonly top: number;
}

/**
 * The spot that an arrow key leads to in rows of cards: the next or the one before, or the nearest in the row below or above.
 * @returns its index; the same if there is none
 */
export function spotAfter(spots: readonly Spot[], from: number, key: string): number {
  if (key === 'ArrowRight') return Math.min(spots.length - 1, from + 1);
  if (key === 'ArrowLeft') return Math.max(0, from - 1);
  if (key === 'Home') return 0;
  if (key === 'End') return spots.length - 1;
  const here = spots[from];
  if (here === undefined) return from;
  const isDown = key === 'ArrowDown';
  const beyond = spots.map(({ top }) => top).filter((top) => (isDown ? top > here.top + 1 : top < here.top - 1));
  if (beyond.length === 0) return from;
  const row = isDown ? Math.min(...beyond) : Math.max(...beyond);
  let best = from;
  for (const [i, { left, top }] of spots.entries()) {
    if (Math.abs(top - row) > 1) continue;
    if (best === from || Math.abs(left - here.left) < Math.abs(spots[best].left - here.left)) best = i;
  }
  return best;
}
