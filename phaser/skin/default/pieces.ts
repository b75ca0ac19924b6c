import type { GameObjects } from 'phaser';
import { type Disc, type ObjectKind, type Place, placesIn } from '../../../schema/basics/index.ts';
import { DRAWINGS, type KindDrawing, type Part, TEXTURE_UNIT } from '../../drawing/index.ts';
import type { Draw, SkinStage } from '../skin.ts';
import { colouredTexture } from '../skin-texture.ts';

/** An image of the default skin. */
export function imageOf(stage: SkinStage, texture: string, depth: number): GameObjects.Image {
  return stage.scene.add.image(0, 0, stage.texture(texture)).setDepth(depth);
}

/** An image of the default skin in a colour. */
export function colouredImage(stage: SkinStage, texture: string, colour: string, depth: number): GameObjects.Image {
  return stage.scene.add.image(0, 0, colouredTexture(stage.scene, texture, colour)).setDepth(depth);
}

/** The images of the parts of an object at a place. */
export function imagesOf(stage: SkinStage, parts: readonly Part[], { x, y }: Place, radius: number): GameObjects.Image[] {
  return parts.map(({ texture, depth, scale = 1, offset, rotation = 0 }) =>
    imageOf(stage, texture, depth)
      .setPosition(x + (offset?.x ?? 0) * radius, y + (offset?.y ?? 0) * radius)
      .setScale((radius / TEXTURE_UNIT) * scale)
      .setRotation(rotation),
  );
}

/** Draws objects of a kind that stay where they are; they may turn. */
export function drawKind(kind: ObjectKind): Draw<Disc> {
  const { parts, spin }: KindDrawing = DRAWINGS[kind] as KindDrawing;
  return (stage, object, index) => {
    const figures = placesIn(kind, object).map((place) => imagesOf(stage, parts(object), place, object.radius));
    const objects = figures.flat();
    if (spin === 0) return { objects };
    const turning = figures.map(([first]) => first);
    return {
      objects,
      update() {
        for (const image of turning) image.setRotation(spin * stage.time + index);
      },
    };
  };
}
