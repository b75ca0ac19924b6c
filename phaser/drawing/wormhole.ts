import { type Brush, disc, faint, ring } from './brush.ts';
import type { GameColours, Theme } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/** Colours of the rim, against space, and of the spiral, against the dark of the mouth. */
const RIM = { dark: '#ff9de2', light: '#b0128a' } as const;
const SPIRAL = '#ff9de2';

function drawMouth(brush: Brush, colours: GameColours, theme: Theme): void {
  brush.fillStyle = faint(colours.hole, 0.85);
  disc(brush, 0, 0, 1);
  ring(brush, 0.95, 0.1, RIM[theme]);
  brush.strokeStyle = faint(SPIRAL, 0.85);
  brush.lineWidth = 0.06;
  brush.lineCap = 'round';
  brush.beginPath();
  for (let i = 0; i < 60; i++) {
    const out = 0.9 * (1 - i / 62);
    brush.lineTo(out * Math.cos(0.3 * i), out * Math.sin(0.3 * i));
  }
  brush.stroke();
}

/** Both mouths look alike and turn. */
export const wormhole: KindDrawing = {
  textures: { mouth: drawMouth },
  parts: () => [{ texture: 'mouth', depth: 2.5 }],
  spin: 0.6,
};
