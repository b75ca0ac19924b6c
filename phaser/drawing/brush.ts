/** The context for drawing textures: the origin is in the middle of the texture, the unit is half its size. */
export type Brush = CanvasRenderingContext2D;

/** half of a texture's side, px: the radius of the drawing's unit circle */
export const TEXTURE_UNIT = 64;

/**
 * A colour with an opacity.
 *
 * @param css - `#rrggbb`
 * @param opacity - 0 to 1
 * @returns `#rrggbbaa`
 */
export function faint(css: string, opacity: number): string {
  return `${css}${Math.round(255 * opacity)
    .toString(16)
    .padStart(2, '0')}`;
}

/** A disc with a radial gradient. @param stops colours by their distance from the centre, 0 to 1 */
export function fadingDisc(brush: Brush, radius: number, stops: readonly (readonly [at: number, colour: string])[]): void {
  const gradient = brush.createRadialGradient(0, 0, 0, 0, 0, radius);
  for (const [at, colour] of stops) gradient.addColorStop(at, colour);
  brush.fillStyle = gradient;
  disc(brush, 0, 0, radius);
}

export function disc(brush: Brush, x: number, y: number, radius: number): void {
  brush.beginPath();
  brush.arc(x, y, radius, 0, 2 * Math.PI);
  brush.fill();
}

/**
 * Draws a circle about the origin.
 *
 * @param brush - the context of the texture
 * @param radius - of the middle of the line, in the unit of the brush
 * @param width - of the line, in the unit of the brush
 * @param colour - as CSS
 */
export function ring(brush: Brush, radius: number, width: number, colour: string): void {
  brush.strokeStyle = colour;
  brush.lineWidth = width;
  brush.beginPath();
  brush.arc(0, 0, radius, 0, 2 * Math.PI);
  brush.stroke();
}

/** Pseudo-random numbers from 0 to 1, the same for the same seed, so that textures look the same on every start. */
export function dice(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

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
