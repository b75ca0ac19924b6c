import type { Scene } from 'phaser';
import { type Part, TEXTURE_UNIT } from '../../../phaser/index.ts';
import { KINDS, type LevelFile } from '../../../schema/index.ts';
import type { Pose } from '../../core/context/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf, radiusOf, visibleIn } from '../../core/document/index.ts';
import { type Figure, ON_CANVAS, put } from '../kinds.ts';
import { ThingLayer } from './thing-layer.ts';
import type { Thing } from './things.ts';

/** above the grid and its overlays, below everything else */
const DEPTH = 1;

/** A figure with its images. */
interface Shown extends Figure {
  readonly images: readonly Thing[];
}

type Json = Readonly<Record<string, unknown>>;

/** Whether an object differs at most in its places. */
function looksSame(found: FoundObject, old: FoundObject): boolean {
  if (found.kind !== old.kind) return false;
  const { fields, places } = KINDS[found.kind];
  const [now, then] = [found.object, old.object] as unknown as [Json, Json];
  return Object.keys(fields).every((name) => now[name] === then[name] || places.some((pair) => pair.includes(name)));
}

/** The objects of a level as sprites; only those that changed are touched. */
export class ObjectLayer {
  /** The figures of each object, one for each of its places. */
  private readonly shown = new Map<ObjectKey, readonly Shown[]>();
  private readonly layer: ThingLayer;
  private file: LevelFile | null = null;
  private isEditing = true;
  /** The figures that turn by themselves. */
  private turning: readonly Shown[] = [];

  constructor(scene: Scene) {
    this.layer = new ThingLayer(scene).setDepth(DEPTH);
  }

  /** Discards all sprites, as the textures are new. */
  clear(): void {
    for (const figures of this.shown.values()) destroy(figures);
    this.shown.clear();
    this.layer.forget();
    this.turning = [];
    this.file = null;
  }

  /** @param isEditing whether hidden objects are left out */
  show(file: LevelFile, isEditing: boolean): void {
    if (file === this.file && isEditing === this.isEditing) return;
    this.file = file;
    this.isEditing = isEditing;
    const objects = isEditing ? visibleIn(file) : objectsOf(file);
    for (const [key, figures] of this.shown) {
      if (objects.has(key)) continue;
      destroy(figures);
      this.shown.delete(key);
    }
    for (const found of objects.values()) {
      const old = this.shown.get(found.key);
      const was = old?.[0].found;
      if (was !== undefined && was.object === found.object && was.index === found.index) continue;
      this.shown.set(found.key, this.place(found, old));
    }
    this.turning = this.figures().filter(({ found: { kind } }) => ON_CANVAS[kind].turn !== undefined);
  }

  /**
   * Shows everything as it is in a run; null: as in the level.
   * @param zoom px of screen per px of the level
   */
  pose(pose: Pose | null, zoom: number): void {
    for (const figures of this.shown.values()) {
      const { pose: show } = ON_CANVAS[figures[0].found.kind];
      if (show !== undefined) for (const figure of figures) show(figure, pose, zoom);
    }
  }

  /**
   * @param time s, for what turns by itself
   * @param zoom px of screen per px of the level
   */
  animate(time: number, zoom: number): void {
    for (const figure of this.turning) ON_CANVAS[figure.found.kind].turn?.(figure, time, zoom);
  }

  private figures(): Shown[] {
    return [...this.shown.values()].flat();
  }

  private place(found: FoundObject, there: readonly Shown[] | undefined): readonly Shown[] {
    const isOfKind = there?.[0].found.kind === found.kind;
    // the id may now belong to an object of another kind
    if (there !== undefined && !isOfKind) destroy(there);
    const old = isOfKind ? there : undefined;
    const first = old?.[0];
    const parts = first !== undefined && looksSame(found, first.found) ? first.parts : ON_CANVAS[found.kind].parts(found);
    const radius = radiusOf(found) ?? 0;
    return placesOf(found).map((at, i) => {
      const was = old?.[i];
      const images = was !== undefined && was.parts === parts ? was.images : this.dress(parts, radius, was?.images ?? []);
      const away = images.map((_, k) => was?.away[k] ?? { x: 0, y: 0 });
      const figure = { found, at, radius, parts, images, away };
      put(figure, at.x, at.y);
      return figure;
    });
  }

  /** The images of the parts: existing ones are adapted, missing ones are created. */
  private dress(parts: readonly Part[], radius: number, there: readonly Thing[]): readonly Thing[] {
    for (const spare of there.slice(parts.length)) spare.destroy();
    return parts.map(({ texture, depth, scale = 1, rotation }, i) => {
      const image = there[i] ?? this.layer.addThing(texture, depth);
      if (image.texture.key !== texture) image.setTexture(texture);
      if (image.depth !== depth) image.setDepth(depth);
      image.setScale((radius / TEXTURE_UNIT) * scale);
      if (rotation !== undefined) image.setRotation(rotation);
      return image;
    });
  }
}

function destroy(figures: readonly Shown[]): void {
  for (const { images } of figures) for (const image of images) image.destroy();
}
