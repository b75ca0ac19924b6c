import { type Cameras, GameObjects, type Renderer, type Scene } from 'phaser';
import { type Drawn, Thing } from '../thing.ts';
import { Things } from './draw-things.ts';
import { Plate, type Shift } from './plate.ts';

type Canvas = Renderer.Canvas.CanvasRenderer;
type Camera = Cameras.Scene2D.Camera;

/** Things of neighbouring depths, from below to above. */
interface Part {
  readonly still: Things;
  /** They have all gone the same way since they stood still: a drag. */
  readonly carried: Things;
  readonly alone: Things;
}

const NOWHERE: Shift = { x: 0, y: 0 };

/** Where the most of those that are carried have been carried to. Of two halves one is found, of less than half maybe none. */
function shiftOf(things: Iterable<Thing>): Shift {
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
  /** Those that are not known to stand still: of thousands these alone are looked at in a frame. */
  private readonly restless = new Set<Thing>();
  private parts: readonly Part[] = [];
  /** How many things there were when they were sorted last. */
  private sorted = 0;

  constructor(scene: Scene) {
    super(scene);
    scene.add.existing(this);
  }

  addThing(texture: string, depth: number): Thing {
    const thing = new Thing(this.scene, texture, this.restless).setDepth(depth);
    this.add(thing);
    return thing;
  }

  /** What comes next is another level: it begins without the pictures of the last one. */
  forget(): void {
    this.plates.length = 0;
  }

  /** Called by Phaser where there is no graphics card. */
  renderCanvas(renderer: Canvas, _layer: this, camera: Camera): void {
    const shift = this.sortAnew();
    const context = renderer.currentContext;
    const { a, b, c, d, e, f } = camera.matrixCombined;
    const lens = { a, b, c, d, e, f, alpha: camera.alpha };
    context.save();
    for (const [i, { still, carried, alone }] of this.parts.entries()) {
      this.plates[i] ??= { still: new Plate(), carried: new Plate() };
      this.plates[i].still.draw(context, still, lens, NOWHERE);
      this.plates[i].carried.draw(context, carried, lens, shift);
      alone.paint(context, lens, 0, alone.count);
    }
    context.restore();
  }

  /** Sorts the things out anew if one of them is to be drawn in another way than in the last frame. @returns how far those that are carried are */
  private sortAnew(): Shift {
    const { restless } = this;
    for (const thing of restless) thing.look();
    const shift = shiftOf(restless);
    let isOther = this.getChildren().length !== this.sorted;
    for (const thing of restless) {
      const drawn: Drawn = thing.isStill ? 'still' : thing.isCarriedBy(shift.x, shift.y) ? 'carried' : 'alone';
      if (drawn !== thing.drawn) isOther = true;
      thing.drawn = drawn;
      if (drawn === 'still') restless.delete(thing);
    }
    if (isOther) {
      this.depthSort();
      const things = this.getChildren() as Thing[];
      this.sorted = things.length;
      this.parts = sortOut(things);
    }
    return shift;
  }
}

function sortOut(things: readonly Thing[]): Part[] {
  const parts: Part[] = [];
  const empty = () => ({ still: [] as Thing[], carried: [] as Thing[], alone: [] as Thing[] });
  let part = empty();
  const end = () =>
    parts.push({ still: new Things(part.still), carried: new Things(part.carried), alone: new Things(part.alone) });
  let depth = Number.NaN;
  for (const thing of things) {
    // what lies higher may only be put into the same picture as long as nothing moves between
    if (thing.depth !== depth && part.carried.length + part.alone.length > 0) {
      end();
      part = empty();
    }
    depth = thing.depth;
    part[thing.drawn ?? 'alone'].push(thing);
  }
  end();
  return parts;
}
