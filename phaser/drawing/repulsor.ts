import { type Brush, fadingDisc, faint, ring } from './brush.ts';
import type { GameColours } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/** A repulsor: rings and arrows that point outwards. */
function drawRepulsor(brush: Brush, colours: GameColours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.field, 0.05)],
    [0.8, faint(colours.field, 0.16)],
    [1, faint(colours.field, 0.3)],
  ]);
  for (const out of [0.3, 0.55, 0.78]) ring(brush, out, 0.02, faint(colours.field, 0.35 + 0.4 * out));
  brush.strokeStyle = faint(colours.field, 0.9);
  brush.lineWidth = 0.035;
  brush.lineJoin = 'round';
  for (let i = 0; i < 8; i++) {
    brush.save();
    brush.rotate((Math.PI * i) / 4);
    brush.beginPath();
    brush.moveTo(0.6, -0.09);
    brush.lineTo(0.72, 0);
    brush.lineTo(0.6, 0.09);
    brush.stroke();
    brush.restore();
  }
}

export const repulsor: KindDrawing = {
  textures: { repulsor: drawRepulsor },
  parts: () => [{ texture: 'repulsor', depth: 1 }],
  spin: 0,
};
