/** An upright rectangle, px of the page. */
export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

interface Size {
  readonly width: number;
  readonly height: number;
}

interface Corner {
  readonly x: number;
  readonly y: number;
}

/** The sides of something on which a card can stand. */
export type Side = 'right' | 'left' | 'below' | 'above';
const SIDES: readonly Side[] = ['right', 'left', 'below', 'above'];

/** Where a card stands: its left and upper edge, px of the page. */
export interface CardPosition extends Corner {
  /** null: no side has room, and it covers what it stands beside */
  readonly side: Side | null;
}

/** px between the card and the edges of the page */
const MARGIN = 8;

const within = (value: number, size: number, room: number): number => Math.max(MARGIN, Math.min(room - size - MARGIN, value));

function positionAt(side: Side, beside: Rect, card: Size, page: Size): Corner {
  const y = within((beside.top + beside.bottom - card.height) / 2, card.height, page.height);
  const x = within((beside.left + beside.right - card.width) / 2, card.width, page.width);
  switch (side) {
    case 'right':
      return { x: Math.max(MARGIN, beside.right), y };
    case 'left':
      return { x: Math.min(page.width - MARGIN, beside.left) - card.width, y };
    case 'below':
      return { x, y: Math.max(MARGIN, beside.bottom) };
    case 'above':
      return { x, y: Math.min(page.height - MARGIN, beside.top) - card.height };
  }
}

/**
 * Where a card stands beside something, never off the page: on the side where it covers least.
 * @param beside what it must not cover, with the distance that it keeps
 * @param covered points that it should not cover, px of the page
 * @param side where it stood last: it stays there for as long as there is room, so that it does not jump about
 */
export function cardPosition(
  beside: Rect,
  card: Size,
  page: Size,
  covered: () => readonly Corner[],
  side: Side | null,
): CardPosition {
  const fits = ({ x, y }: Corner) =>
    x >= MARGIN && x + card.width <= page.width - MARGIN && y >= MARGIN && y + card.height <= page.height - MARGIN;
  const places = SIDES.map((name) => ({ side: name, ...positionAt(name, beside, card, page) })).filter(fits);
  const stays = places.find((place) => place.side === side);
  if (stays !== undefined) return stays;
  const points = covered();
  const count = ({ x, y }: Corner) =>
    points.filter((point) => point.x > x && point.x < x + card.width && point.y > y && point.y < y + card.height).length;
  let best: CardPosition | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const place of places) {
    const covers = count(place);
    if (covers >= least) continue;
    least = covers;
    best = place;
  }
  return (
    best ?? {
      side: null,
      x: within(beside.right, card.width, page.width),
      y: within(beside.bottom, card.height, page.height),
    }
  );
}
