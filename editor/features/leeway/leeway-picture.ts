import type { Box } from '../../canvas/index.ts';
import { CELL_NUMBERS, type CellState, cornerCompletes, type Leeway, stateOfCode } from '../../workers/index.ts';

/** What the shade shows, px of the level. */
interface LeewayShapes {
  /** The run completes the level at their corners and their middles; at places sampled px by px, each is a square of its own. */
  readonly allowed: readonly Box[];
  /** Not decided yet: not sampled, or samples differ. */
  readonly open: readonly Box[];
  /** Sampled places, x and y alternating: where it completes, and where not. */
  readonly good: readonly number[];
  readonly bad: readonly number[];
  /** What was examined. */
  readonly frame: Box | null;
}

/** @param least px between sampled places below which they are not told one by one */
export function shapesOf({ cells, lattice }: Pick<Leeway, 'cells' | 'lattice'>, least: number): LeewayShapes {
  const allowed: Box[] = [];
  const open: Box[] = [];
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
function completingCorners({ left, top, right, bottom }: Box, code: number, unit: number): Box[] {
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

// how it is painted

/** px of the picture between strokes, and between the dots of what is open */
const HATCH = 9;
const DOTS = 7;
/** px of the picture of the line around allowed places */
const EDGE = 1.6;
/** Directions in which the allowed places are widened to draw that line. */
const AROUND = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
  [0.7, 0.7],
  [-0.7, 0.7],
  [0.7, -0.7],
  [-0.7, -0.7],
] as const;

interface Look {
  /** px of the picture per px of the level */
  readonly scale: number;
  /** px of the picture per px of the screen */
  readonly density: number;
  /** CSS */
  readonly colour: string;
  readonly bad: string;
  readonly open: string;
}

type Brush = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

function fill(brush: Brush, rects: readonly Box[], frame: Box, scale: number): void {
  brush.beginPath();
  for (const { left, top, right, bottom } of rects)
    brush.rect((left - frame.left) * scale, (top - frame.top) * scale, (right - left) * scale, (bottom - top) * scale);
  brush.fill();
}

/** A canvas on which only the rectangles are painted. */
function maskOf(rects: readonly Box[], frame: Box, scale: number, { width, height }: HTMLCanvasElement) {
  const mask = new OffscreenCanvas(width, height);
  const brush = mask.getContext('2d');
  if (brush === null) return null;
  fill(brush, rects, frame, scale);
  return { mask, brush };
}

function strokes(brush: Brush, width: number, height: number, { colour, density }: Look): void {
  const step = HATCH * density;
  brush.strokeStyle = colour;
  brush.lineWidth = 1.3 * density;
  brush.beginPath();
  for (let c = -height; c < width; c += step) {
    brush.moveTo(c, 0);
    brush.lineTo(c + height, height);
  }
  brush.stroke();
}

function dots(brush: Brush, width: number, height: number, { open, density }: Look): void {
  const step = DOTS * density;
  brush.fillStyle = open;
  for (let y = step / 2; y < height; y += step)
    for (let x = step / 2; x < width; x += step) brush.fillRect(x - density / 2, y - density / 2, density, density);
}

/**
 * Paints where objects may stand: strokes and a line around it; dots where nothing is decided; a point for each sample that can be
 * made out. The size of the canvas is that of the frame.
 */
export function drawLeeway(canvas: HTMLCanvasElement, shapes: LeewayShapes, look: Look): void {
  const { frame, allowed, open, good, bad } = shapes;
  const context = canvas.getContext('2d');
  if (frame === null || context === null) return;
  const { scale, density } = look;
  const { width, height } = canvas;
  context.clearRect(0, 0, width, height);
  const undecided = maskOf(open, frame, scale, canvas);
  if (undecided !== null && open.length > 0) {
    undecided.brush.globalCompositeOperation = 'source-in';
    // what is drawn next would be cut to the dots drawn before
    const pattern = new OffscreenCanvas(width, height);
    const brush = pattern.getContext('2d');
    if (brush !== null) dots(brush, width, height, look);
    undecided.brush.drawImage(pattern, 0, 0);
    context.globalAlpha = 0.55;
    context.drawImage(undecided.mask, 0, 0);
  }
  const inside = maskOf(allowed, frame, scale, canvas);
  const outline = maskOf([], frame, scale, canvas);
  const hatch = maskOf([], frame, scale, canvas);
  if (inside === null || outline === null || hatch === null) return;
  for (const [x, y] of AROUND) outline.brush.drawImage(inside.mask, x * EDGE * density, y * EDGE * density);
  outline.brush.globalCompositeOperation = 'source-in';
  outline.brush.fillStyle = look.colour;
  outline.brush.fillRect(0, 0, width, height);
  outline.brush.globalCompositeOperation = 'destination-out';
  outline.brush.drawImage(inside.mask, 0, 0);
  strokes(hatch.brush, width, height, look);
  hatch.brush.globalCompositeOperation = 'destination-in';
  hatch.brush.drawImage(inside.mask, 0, 0);
  context.globalAlpha = 0.5;
  context.drawImage(hatch.mask, 0, 0);
  context.globalAlpha = 1;
  context.drawImage(outline.mask, 0, 0);
  for (const [places, colour, radius, alpha] of [
    [good, look.colour, 1.7, 1],
    [bad, look.bad, 1, 0.55],
  ] as const) {
    context.globalAlpha = alpha;
    context.fillStyle = colour;
    const r = radius * density;
    for (let i = 0; i < places.length; i += 2)
      context.fillRect((places[i] - frame.left) * scale - r, (places[i + 1] - frame.top) * scale - r, 2 * r, 2 * r);
  }
}
