import { Sun } from 'lucide-react';
import { type Brush, fadingDisc, faint, TEXTURE_UNIT } from '../brush.ts';
import type { Colours } from '../colours.ts';
import type { KindOnCanvas } from './kind-on-canvas.ts';

/** radians per second */
const SPIN = 0.12;

/** px of screen below which a nova does not turn: it would not be visible, and images at rest cost next to nothing */
const TURNS_FROM = 10;

/** A dwarf nova: a white core and rays that end at the unit circle, where it is deadly. */
function drawNova(brush: Brush, colours: Colours): void {
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
export const nova: KindOnCanvas = {
  sign: { Icon: Sun, tone: 'bad' },
  textures: { nova: drawNova },
  parts: () => [
    { texture: 'nova', depth: 5 },
    { texture: 'glow', depth: 3, scale: 1.9 },
  ],
  turn({ found, images: [body] }, time, zoom) {
    if (TEXTURE_UNIT * body.scale * zoom >= TURNS_FROM) body.setRotation(SPIN * time + found.index);
  },
};
