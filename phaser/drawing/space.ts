import { type Brush, dice, disc, fadingDisc, faint } from './brush.ts';
import type { GameColours } from './colours.ts';

/** A seamless tile of stars; few of them are large. Here the brush uses px. */
export function drawStars(brush: Brush, colours: GameColours, size: number, count: number, biggest: number, seed: number): void {
  const roll = dice(seed);
  for (let i = 0; i < count; i++) {
    const x = size * roll();
    const y = size * roll();
    const radius = 0.4 + (biggest - 0.4) * roll() ** 4;
    brush.fillStyle = faint(colours.star, 0.25 + 0.65 * roll());
    disc(brush, x, y, radius);
  }
}

/** A soft tinted cloud, drawn large behind everything. */
export function drawHaze(brush: Brush, colours: GameColours): void {
  fadingDisc(brush, 1, [
    [0, faint(colours.haze, 0.9)],
    [0.5, faint(colours.haze, 0.35)],
    [1, faint(colours.haze, 0)],
  ]);
}
