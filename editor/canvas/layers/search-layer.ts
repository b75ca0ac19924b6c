import type { GameObjects, Scene } from 'phaser';
import type { Explored, ProofPicture } from '../../../solver/index.ts';
import { type Colours, colourNumber } from '../colours.ts';
import { fillSquares } from './heat.ts';

/** What a search shows besides paths. */
export interface SearchPicture {
  /** Where it has been. */
  readonly heat: Explored | null;
  /** Why something is out of reach. */
  readonly proof: ProofPicture | null;
}

/** The heat map of searches and the picture of an impossibility proof; below everything else. */
export class SearchLayer {
  private readonly heat: GameObjects.Graphics;
  private readonly proof: GameObjects.Graphics;

  constructor(
    scene: Scene,
    private readonly colours: Colours,
  ) {
    this.heat = scene.add.graphics().setDepth(0.2);
    this.proof = scene.add.graphics().setDepth(0.4);
  }

  /** @param zoom px of screen per px of the level */
  show({ heat, proof }: SearchPicture, showHeat: boolean, zoom: number): void {
    this.heat.clear();
    this.proof.clear();
    if (heat !== null && showHeat) fillSquares(this.heat, heat, colourNumber(this.colours.heat), (shade) => shade);
    if (proof !== null) this.drawProof(proof, zoom);
  }

  destroy(): void {
    this.heat.destroy();
    this.proof.destroy();
  }

  private drawProof({ discs, lines }: ProofPicture, zoom: number): void {
    const danger = colourNumber(this.colours.danger);
    const range = colourNumber(this.colours.range);
    for (const { x, y, radius, role } of discs) {
      const colour = role === 'range' ? range : role === 'thing' ? colourNumber(this.colours.holeRim) : danger;
      this.proof.fillStyle(colour, role === 'blocked' ? 0.2 : 0.06).fillCircle(x, y, radius);
      this.proof.lineStyle(1.2 / zoom, colour, 0.7).strokeCircle(x, y, radius);
    }
    for (const { points, closed, role } of lines) {
      const reach = role === 'reach';
      this.proof
        .lineStyle((reach ? 1 : 2.5) / zoom, reach ? colourNumber(this.colours.wayLost) : danger, reach ? 0.4 : 0.95)
        .beginPath();
      for (const { x, y } of points) this.proof.lineTo(x, y);
      if (closed) this.proof.closePath();
      this.proof.strokePath();
    }
  }
}
