import { type Brush, dice, disc, fadingDisc, faint } from '../brush.ts';
import type { Colours } from '../colours.ts';

/** A tile of stars that fits to itself on all sides; `share` of them are big. The brush counts px here. */
export function drawStars(brush: Brush, colours: Colours, size: number, count: number, biggest: number, seed: number): void {
  const roll = dice(seed);
  for (let i = 0; i < count; i++) {
    const x = size * roll();
    const y = size * roll();
    const radius = 0.4 + (biggest - 0.4) * roll() ** 4;
    brush.fillStyle = faint(colours.star, 0.25 + 0.65 * roll());
    disc(brush, x, y, radius);
  }
}

/** A soft cloud, tinted: laid large behind everything. */
export function drawHaze(brush: Brush, colours: Colours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.haze, 0.9)],
    [0.5, faint(colours.haze, 0.35)],
    [1, faint(colours.haze, 0)],
  ]);
}
