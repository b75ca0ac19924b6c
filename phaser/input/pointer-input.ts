import type { GameObjects, Input, Scene } from 'phaser';
import type { Held } from './held.ts';

type Pointer = Input.Pointer;

const nameOf = ({ id }: Pointer): string => `pointer ${id}`;

/** Whether it presses: a finger, or the main button of a mouse. */
const isDown = (pointer: Pointer): boolean => (pointer.wasTouch ? pointer.isDown : pointer.primaryDown);

/** Mouse, pen and fingers on the canvas. */
export class PointerInput {
  private readonly down: Pointer[] = [];

  /** @param counts whether a press at a place of the canvas counts */
  constructor(
    private readonly scene: Scene,
    private readonly held: Held,
    private readonly counts: (x: number, y: number) => boolean,
  ) {
    scene.input.on('pointerdown', this.onDown, this);
    scene.input.on('pointerup', this.look, this);
    scene.input.on('pointerupoutside', this.look, this);
  }

  private onDown(pointer: Pointer, over: readonly GameObjects.GameObject[]): void {
    // a button of the game is not the gun's
    if (over.length > 0 || !isDown(pointer) || !this.counts(pointer.x, pointer.y)) return;
    if (!this.down.includes(pointer)) this.down.push(pointer);
    this.held.press(nameOf(pointer));
  }

  /**
   * Releases what is not down any more. Called every frame, too: Phaser does not report to this scene that a pointer goes up
   * over a button of another scene, or outside of the window.
   */
  look(): void {
    const { down } = this;
    for (let i = down.length - 1; i >= 0; i--) {
      const pointer = down[i];
      if (isDown(pointer) && this.held.has(nameOf(pointer))) continue;
      down[i] = down[down.length - 1];
      down.length--;
      this.held.release(nameOf(pointer));
    }
  }

  destroy(): void {
    const { input } = this.scene;
    input.off('pointerdown', this.onDown, this);
    input.off('pointerup', this.look, this);
    input.off('pointerupoutside', this.look, this);
    this.down.length = 0;
  }
}
