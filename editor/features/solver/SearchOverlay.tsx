import type { GameObjects, Scene } from 'phaser';
import { useStore } from 'zustand';
import { heatCaption, heatColour } from '../../../picture/index.ts';
import type { ProofPicture } from '../../../solver/index.ts';
import { type Colours, colourNumber, type Drawing, type Frame, fillSquares, ShadeLegend } from '../../canvas/index.ts';
import { usePageTheme, useSession } from '../../core/context/index.ts';
import { useSolverSession } from './index.ts';
import type { SearchOverlay } from './search-session.ts';

/**
 * The legend of the heat map: what the squares count, and which shade means how many visits. Empty while the heat map is
 * hidden.
 */
export function HeatLegend() {
  const { overlay } = useSolverSession();
  const explored = useStore(overlay, ({ heat }) => heat);
  const isShown = useSession(({ layers }) => layers.heatMap);
  const theme = usePageTheme();
  if (explored === null || !isShown) return null;
  return (
    <ShadeLegend
      label="Search heat map"
      caption={heatCaption(explored)}
      map={explored}
      colour={heatColour(theme)}
      opacityOf={(shade) => shade}
      corner="left"
    />
  );
}

/** The heat map of searches and the picture of an impossibility proof; below everything else. */
export class SearchLayer implements Drawing<SearchOverlay> {
  private readonly heat: GameObjects.Graphics;
  private readonly proof: GameObjects.Graphics;

  constructor(
    scene: Scene,
    private readonly colours: Colours,
  ) {
    this.heat = scene.add.graphics().setDepth(0.2);
    this.proof = scene.add.graphics().setDepth(0.4);
  }

  show({ heat, proof }: SearchOverlay, { zoom }: Frame): void {
    this.heat.clear();
    this.proof.clear();
    if (heat !== null) fillSquares(this.heat, heat, colourNumber(this.colours.heat), (shade) => shade);
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
