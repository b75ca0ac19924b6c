import type { Thing } from '../thing.ts';
import type { Lens, Marks, Spot } from './marks.ts';

/** half of the diagonal of a square over half of its side */
const DIAGONAL = Math.SQRT2;

function spotOf(thing: Thing, { a, b, c, d, e, f }: Lens, into: Spot): Spot {
  const { x, y, scaleX, scaleY, displayOriginX, displayOriginY } = thing;
  const zoom = Math.max(Math.sqrt(a * a + b * b), Math.sqrt(c * c + d * d));
  into.x = a * x + c * y + e;
  into.y = b * x + d * y + f;
  into.reach = DIAGONAL * zoom * Math.max(displayOriginX * Math.abs(scaleX), displayOriginY * Math.abs(scaleY));
  return into;
}

/**
 * Draws things like Phaser's canvas renderer, but faster: for each thing, Phaser saves and sets the whole state of the canvas,
 * which takes longer than the drawing itself, and it also draws what is not visible.
 */
function drawThings(context: CanvasRenderingContext2D, things: readonly Thing[], lens: Lens, from: number, to: number): void {
  const { a, b, c, d } = lens;
  const { width, height } = context.canvas;
  const spot: Spot = { x: 0, y: 0, reach: 0 };
  for (let i = from; i < to; i++) {
    const thing = things[i];
    const { rotation, scaleX, scaleY, displayOriginX, displayOriginY, frame } = thing;
    const alpha = lens.alpha * thing.alpha;
    const { x, y, reach } = spotOf(thing, lens, spot);
    if (alpha === 0 || x + reach < 0 || x - reach > width || y + reach < 0 || y - reach > height) continue;
    const cos = Math.cos(rotation);
    const sin = Math.sin(rotation);
    context.setTransform(
      (a * cos + c * sin) * scaleX,
      (b * cos + d * sin) * scaleX,
      (c * cos - a * sin) * scaleY,
      (d * cos - b * sin) * scaleY,
      x,
      y,
    );
    context.globalAlpha = alpha;
    context.drawImage(frame.source.image as HTMLCanvasElement, -displayOriginX, -displayOriginY);
  }
}

/** Images, painted without Phaser. */
export class Things implements Marks {
  constructor(private readonly things: readonly Thing[]) {}

  get count(): number {
    return this.things.length;
  }

  looksLike(others: Marks): boolean {
    if (others === this) return true;
    if (!(others instanceof Things) || others.count !== this.count) return false;
    return this.things.every((thing, i) => thing === others.things[i]);
  }

  spotOf(index: number, lens: Lens, into: Spot): Spot {
    return spotOf(this.things[index], lens, into);
  }

  paint(context: CanvasRenderingContext2D, lens: Lens, from: number, to: number): void {
    drawThings(context, this.things, lens, from, to);
  }
}
