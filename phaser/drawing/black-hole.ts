import { type Brush, disc, fadingDisc, faint, ring } from './brush.ts';
import type { GameColours } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/** The black hole: a dark middle, and arms of light that spiral into it. */
function drawBlackHole(brush: Brush, colours: GameColours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.holeRim, 0.9)],
    [0.5, faint(colours.holeRim, 0.5)],
    [1, faint(colours.holeRim, 0)],
  ]);
  brush.lineCap = 'round';
  for (let arm = 0; arm < 4; arm++) {
    for (let k = 0; k < 40; k++) {
      const share = k / 40;
      const out = 0.46 + 0.5 * share;
      const angle = (Math.PI / 2) * arm + 3.2 * share;
      brush.fillStyle = faint(k % 3 === 0 ? '#ffffff' : colours.holeRim, 0.75 * (1 - share));
      disc(brush, out * Math.cos(angle), out * Math.sin(angle), 0.075 * (1 - 0.6 * share));
    }
  }
  brush.fillStyle = colours.hole;
  disc(brush, 0, 0, 0.5);
  ring(brush, 0.5, 0.04, '#ffffff');
}

/** The black hole with its arms, which reach to twice its radius; it turns. */
export const blackHole: KindDrawing = {
  textures: { 'black-hole': drawBlackHole },
  parts: () => [{ texture: 'black-hole', depth: 2, scale: 2 }],
  spin: -0.5,
};
