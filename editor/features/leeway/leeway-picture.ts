import { CELL_NUMBERS, type CellState, cornerCompletes, type Leeway, stateOfCode } from '../../workers/index.ts';

/** A rectangle of the level, px. */
export interface ShadeRect {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** What the shade shows, px of the level. */
export interface LeewayShapes {
  /** The run completes the level at their corners and their middles; at places sampled px by px, each is a square of its own. */
  readonly allowed: readonly ShadeRect[];
  /** Not decided yet: not sampled, or samples differ. */
  readonly open: readonly ShadeRect[];
  /** Sampled places, x and y alternating: where it completes, and where not. */
  readonly good: readonly number[];
  readonly bad: readonly number[];
  /** What was examined. */
  readonly frame: ShadeRect | null;
}

/** @param least px between sampled places below which they are not told one by one */
export function shapesOf({ cells, lattice }: Pick<Leeway, 'cells' | 'lattice'>, least: number): LeewayShapes {
  const allowed: ShadeRect[] = [];
  const open: ShadeRect[] = [];
  const places = { good: [] as number[], bad: [] as number[] };
  let frame: { left: number; top: number; right: number; bottom: number } | null = null;
  const { x, y, unit } = lattice;
  for (let o = 0; o < cells.length; o += CELL_NUMBERS) {
    const rect = {
      left: x + unit * cells[o],
      top: y + unit * cells[o + 1],
      right: x + unit * cells[o + 2],
      bottom: y + unit * cells[o + 3],
    };
    frame =
      frame === null
        ? { ...rect }
        : {
            left: Math.min(frame.left, rect.left),
            top: Math.min(frame.top, rect.top),
            right: Math.max(frame.right, rect.right),
            bottom: Math.max(frame.bottom, rect.bottom),
          };
    const code = cells[o + 4];
    const state: CellState = stateOfCode(code);
    if (state === 'completes') allowed.push(rect);
    else if (state === 'mixed' || state === 'unsampled') open.push(rect);
    else if (state === 'corners') allowed.push(...completingCorners(rect, code, unit));
    if (state !== 'completes' && state !== 'fails') continue;
    if (rect.right - rect.left < least) continue;
    const middle = unit * ((cells[o] + cells[o + 2]) >> 1);
    const centre = unit * ((cells[o + 1] + cells[o + 3]) >> 1);
    const list = state === 'completes' ? places.good : places.bad;
    list.push(rect.left, rect.top, rect.right, rect.top, rect.left, rect.bottom, rect.right, rect.bottom, x + middle, y + centre);
  }
  return { allowed, open, ...places, frame };
}

/** The places themselves: between them nothing was sampled. */
function completingCorners({ left, top, right, bottom }: ShadeRect, code: number, unit: number): ShadeRect[] {
  const half = unit / 2;
  const corners = [
    [left, top],
    [right, top],
    [left, bottom],
    [right, bottom],
  ] as const;
  return corners.flatMap(([x, y], k) =>
    cornerCompletes(code, k) ? [{ left: x - half, top: y - half, right: x + half, bottom: y + half }] : [],
  );
}
