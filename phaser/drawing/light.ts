import { type Brush, fadingDisc, faint } from './brush.ts';

/** The light around hot objects, for twice the object's radius. */
export function drawGlow(brush: Brush, colour: string): void {
  fadingDisc(brush, 1, [
    [0, faint(colour, 0.65)],
    [0.45, faint(colour, 0.4)],
    [0.6, faint(colour, 0.16)],
    [1, faint(colour, 0)],
  ]);
}

/** A grain of light, for beams. */
export function drawSpark(brush: Brush): void {
  fadingDisc(brush, 1, [
    [0, '#ffffff'],
    [0.4, faint('#ffffff', 0.7)],
    [1, faint('#ffffff', 0)],
  ]);
}
