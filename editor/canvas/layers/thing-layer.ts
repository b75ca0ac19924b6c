import { type Cameras, GameObjects, type Renderer, type Scene } from 'phaser';
import { Things } from './draw-things.ts';
import { Plate, type Shift } from './plate.ts';
import type { Thing } from './thing.ts';

type Canvas = Renderer.Canvas.CanvasRenderer;
type Camera = Cameras.Scene2D.Camera;

/** Things of neighbouring depths, from below to above. */
interface Part {
  readonly still: Thing[];
  /** They have all gone the same way since they stood still: a drag. */
  readonly carried: Thing[];
  readonly others: Thing[];
}

const NOWHERE: Shift = { x: 0, y: 0 };

/** Where the most of those that are carried have been carried to. Of two halves one is found, of less than half maybe none. */
function shiftOf(things: readonly Thing[]): Shift {
  let shift = NOWHERE;
  let lead = 0;
  // the vote of Boyer and Moore
  for (const thing of things) {
    if (!thing.isCarried) continue;
    if (lead === 0) shift = { x: thing.shiftX, y: thing.shiftY };
    lead += thing.isCarriedBy(shift.x, shift.y) ? 1 : -1;
  }
  return shift;
}

/**
 * Images in the order of their depths. Where a plain canvas is drawn on, those that stand still and those that are dragged together are drawn once, onto pictures
 * that then stand for them; of one depth, what moves is above what stands. With a graphics card they are drawn as Phaser draws them: that is faster there.
 */
export class ThingLayer extends GameObjects.Layer {
  private readonly plates: { readonly still: Plate; readonly carried: Plate }[] = [];

  constructor(scene: Scene) {
    super(scene);
    scene.add.existing(this);
  }

  /** Called by Phaser where there is no graphics card. */
  renderCanvas(renderer: Canvas, _layer: this, camera: Camera): void {
    this.depthSort();
    const things = this.getChildren() as Thing[];
    for (const thing of things) thing.look();
    const shift = shiftOf(things);
    const context = renderer.currentContext;
    const { a, b, c, d, e, f } = camera.matrixCombined;
    const lens = { a, b, c, d, e, f, alpha: camera.alpha };
    context.save();
    for (const [i, { still, carried, others }] of sortOut(things, camera, shift).entries()) {
      this.plates[i] ??= { still: new Plate(), carried: new Plate() };
      this.plates[i].still.draw(context, new Things(still), lens, NOWHERE);
      this.plates[i].carried.draw(context, new Things(carried), lens, shift);
      new Things(others).paint(context, lens, 0, others.length);
    }
    context.restore();
  }
}

function sortOut(things: readonly Thing[], camera: Camera, shift: Shift): Part[] {
  const parts: Part[] = [];
  let part: Part = { still: [], carried: [], others: [] };
  let depth = Number.NaN;
  for (const thing of things) {
    // what lies higher may only be put into the same picture as long as nothing moves between
    if (thing.depth !== depth && part.carried.length + part.others.length > 0) {
      parts.push(part);
      part = { still: [], carried: [], others: [] };
    }
    depth = thing.depth;
    if (!thing.willRender(camera)) continue;
    const list = thing.isStill ? part.still : thing.isCarriedBy(shift.x, shift.y) ? part.carried : part.others;
    list.push(thing);
  }
  parts.push(part);
  return parts;
}
