import { type Brush, fadingDisc, faint } from './brush.ts';
import type { GameColours } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/** A dwarf nova: a white core and rays that end at the unit circle, where it is deadly. */
function drawNova(brush: Brush, colours: GameColours): void {
  const rays = 24;
  brush.fillStyle = faint(colours.nova, 0.85);
  brush.beginPath();
  for (let i = 0; i < 2 * rays; i++) {
    const angle = (Math.PI * i) / rays;
    const out = i % 2 === 0 ? 1 : 0.78;
    brush.lineTo(out * Math.cos(angle), out * Math.sin(angle));
  }
  brush.closePath();
  brush.fill();
  fadingDisc(brush, 0.86, [
    [0, colours.novaCore],
    [0.35, colours.novaCore],
    [0.6, '#ffc35a'],
    [0.85, colours.nova],
    [1, faint(colours.nova, 0)],
  ]);
}

/** A dwarf nova with a glow; it turns. */
export const nova: KindDrawing = {
  textures: { nova: drawNova },
  parts: () => [
    { texture: 'nova', depth: 5 },
    { texture: 'glow', depth: 3, scale: 1.9 },
  ],
  spin: 0.12,
};
