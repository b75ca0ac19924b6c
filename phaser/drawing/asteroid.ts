import { type Brush, dice, disc, faint } from './brush.ts';
import type { GameColours } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/** number of shapes */
const SHAPES = 4;

/** A lump with a bumpy rim inside the unit circle, which is where contacts happen. */
function lump(brush: Brush, roll: () => number): void {
  const bumps = 14;
  const points = Array.from({ length: bumps }, (_, i) => {
    const angle = (2 * Math.PI * i) / bumps;
    const out = 0.9 + 0.1 * roll();
    return [out * Math.cos(angle), out * Math.sin(angle)] as const;
  });
  brush.beginPath();
  const middle = (i: number) => {
    const [ax, ay] = points[i % bumps];
    const [bx, by] = points[(i + 1) % bumps];
    return [(ax + bx) / 2, (ay + by) / 2] as const;
  };
  brush.moveTo(...middle(0));
  for (let i = 1; i <= bumps; i++) brush.quadraticCurveTo(...points[i % bumps], ...middle(i));
  brush.closePath();
}

/** A cold asteroid: lit from the upper left, with craters. */
function drawRock(brush: Brush, colours: GameColours, seed: number): void {
  const roll = dice(seed);
  lump(brush, roll);
  const light = brush.createRadialGradient(-0.4, -0.45, 0.1, 0, 0, 1.1);
  light.addColorStop(0, colours.rockLight);
  light.addColorStop(0.55, colours.rock);
  light.addColorStop(1, colours.rockShade);
  brush.fillStyle = light;
  brush.fill();
  brush.save();
  brush.clip();
  for (let i = 0; i < 7; i++) {
    const angle = 2 * Math.PI * roll();
    const out = 0.75 * Math.sqrt(roll());
    const size = 0.08 + 0.14 * roll();
    const x = out * Math.cos(angle);
    const y = out * Math.sin(angle);
    brush.fillStyle = faint(colours.rockLight, 0.35);
    disc(brush, x + 0.03, y + 0.035, size);
    brush.fillStyle = faint(colours.rockShade, 0.75);
    disc(brush, x, y, size);
  }
  brush.restore();
}

/** A hot asteroid: a dark lump with glowing cracks. */
function drawHotRock(brush: Brush, colours: GameColours, seed: number): void {
  const roll = dice(seed);
  lump(brush, roll);
  const light = brush.createRadialGradient(0, 0, 0.1, 0, 0, 1);
  light.addColorStop(0, colours.ember);
  light.addColorStop(1, '#33160f');
  brush.fillStyle = light;
  brush.fill();
  brush.save();
  brush.clip();
  for (const [width, colour] of [
    [0.17, faint(colours.nova, 0.45)],
    [0.075, colours.lava],
    [0.03, colours.novaCore],
  ] as const) {
    const again = dice(seed + 1);
    brush.strokeStyle = colour;
    brush.lineWidth = width;
    brush.lineCap = 'round';
    for (let i = 0; i < 5; i++) {
      let angle = (2 * Math.PI * (i + again())) / 5;
      let [x, y] = [0.15 * Math.cos(angle), 0.15 * Math.sin(angle)];
      brush.beginPath();
      brush.moveTo(x, y);
      for (let k = 0; k < 5; k++) {
        angle += again() - 0.5;
        x += 0.2 * Math.cos(angle);
        y += 0.2 * Math.sin(angle);
        brush.lineTo(x, y);
      }
      brush.stroke();
    }
  }
  brush.restore();
}

/** A shape derived from the asteroid's key, so that it never changes. */
function shapeOf(key: string): number {
  let sum = 0;
  for (let i = 0; i < key.length; i++) sum = (sum * 31 + key.charCodeAt(i)) % 9973;
  return sum % SHAPES;
}

const shapes = [...Array(SHAPES).keys()];

/** An asteroid in one of several shapes, with a glow if it is hot. */
export const asteroid: KindDrawing<{ readonly hot: boolean }> = {
  textures: {
    ...Object.fromEntries(
      shapes.map((i) => [`rock-${i}`, (brush: Brush, colours: GameColours) => drawRock(brush, colours, 7 + 13 * i)]),
    ),
    ...Object.fromEntries(
      shapes.map((i) => [`hot-${i}`, (brush: Brush, colours: GameColours) => drawHotRock(brush, colours, 5 + 17 * i)]),
    ),
  },
  parts({ hot }, key = '') {
    const body = { texture: `${hot ? 'hot' : 'rock'}-${shapeOf(key)}`, depth: 4 };
    return hot ? [body, { texture: 'glow', depth: 3, scale: 1.9 }] : [body];
  },
  spin: 0,
};
