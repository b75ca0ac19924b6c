import { type Brush, disc } from './brush.ts';
import type { GameColours } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/**
 * The astronaut. The unit is 16 px, so that her box is 20 x 32 px. The gun points to her right, along the x axis of the box.
 */
function drawAstronaut(brush: Brush, colours: GameColours): void {
  const px = 1 / 16;
  const part = (x: number, y: number, width: number, height: number, round: number, colour: string) => {
    brush.fillStyle = colour;
    brush.beginPath();
    brush.roundRect(x * px, y * px, width * px, height * px, round * px);
    brush.fill();
  };
  part(-10, -6, 6, 13, 2, colours.suitShade);
  part(-6, 5, 5, 11, 2, colours.suitShade);
  part(1, 5, 5, 11, 2, colours.suit);
  part(-7, -4, 14, 13, 3, colours.suit);
  part(-4, -1, 8, 4, 1, colours.suitShade);
  part(2, 0, 8, 4, 2, colours.suit);
  part(5, -1, 5, 3, 1, '#39424f');
  brush.fillStyle = colours.suit;
  disc(brush, 0, -9.5 * px, 6.5 * px);
  part(-2, -13, 8, 7, 3, colours.visor);
  part(0, -12, 3, 2, 1, '#fff2cf');
}

/** Only her texture: she is drawn by her box, not by a radius. */
export const astronaut: KindDrawing = {
  textures: { astronaut: drawAstronaut },
  parts: () => [],
  spin: 0,
};
