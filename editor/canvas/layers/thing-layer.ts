import { type Cameras, GameObjects, type Renderer, type Scene } from 'phaser';
import { Plate, type Shift } from './plate.ts';
import { type Drawn, Thing, Things } from './things.ts';

type Canvas = Renderer.Canvas.CanvasRenderer;
type Camera = Cameras.Scene2D.Camera;

/** Things of neighbouring depths, from below to above. */
interface Part {
  readonly still: Things;
  /** Things that have all moved by the same shift since they were at rest: a drag. */
  readonly carried: Things;
  readonly alone: Things;
}

const NOWHERE: Shift = { x: 0, y: 0 };

/** The shift of the majority of the carried things. If no shift has a majority, the result may be that of none. */
function shiftOf(things: Iterable<Thing>): Shift {
  let shift = NOWHERE;
  let lead = 0;
  // the majority vote algorithm of Boyer and Moore
  for (const thing of things) {
    if (!thing.isCarried) continue;
    if (lead === 0) shift = { x: thing.shiftX, y: thing.shiftY };
    lead += thing.isCarriedBy(shift.x, shift.y) ? 1 : -1;
  }
  return shift;
}

/**
 * Images in order of depth. With the canvas renderer, images at rest and images dragged together are painted once to pictures,
 * which are then drawn instead; at equal depth, moving images are above those at rest. With WebGL, Phaser draws all images
 * itself, which is faster there.
 */
export class ThingLayer extends GameObjects.Layer {
  private readonly plates: { readonly still: Plate; readonly carried: Plate }[] = [];
  /** Things that may not be at rest: only these, out of thousands, are examined in a frame. */
  private readonly restless = new Set<Thing>();
  private parts: readonly Part[] = [];
  /** number of things when they were last sorted */
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

  /** Another level follows: it starts without the pictures of this one. */
  forget(): void {
    this.plates.length = 0;
  }

  /** Called by Phaser's canvas renderer. */
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

  /**
   * Sorts the things again if one of them is to be drawn differently than in the last frame. @returns the shift of the carried
   * things
   */
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
    // Things of greater depth may join the same picture only while nothing moves in between.
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
