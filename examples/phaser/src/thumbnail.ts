import { DRAWINGS, GAME_COLOURS, type KindDrawing } from 'gravity-quest-toolkit/phaser';
import type { Level } from './pack.ts';

const WIDTH = 288;
const HEIGHT = 162;
/** px of the level around its objects. */
const MARGIN = 36;
/** The smallest part of a level that is shown, px: few objects are not enlarged beyond recognition. */
const LEAST_WIDTH = 560;
/** px: small objects are drawn at least this large on the picture, to be seen at all. */
const LEAST_RADIUS = 4;
/** The radius of the drawing of the astronaut, px of the level. */
const HER_RADIUS = 20;

const COLOURS = GAME_COLOURS.dark;

/** What an object covers, px of the level. */
interface Rim {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** The drawing of any kind: which object it takes depends on the kind. */
type Drawing = KindDrawing<never>;

/** The game draws her by her box; here she is as round as the others. */
const HER: Drawing = { ...DRAWINGS.astronaut, parts: () => [{ texture: 'astronaut', depth: 9 }] };

type Drawn = readonly [drawing: Drawing, circle: Rim, key?: string];

function drawnOf(level: Level): Drawn[] {
  const mouths = level.wormholes.flatMap((hole) => [hole, { ...hole, x: hole.toX, y: hole.toY }]);
  return [
    ...level.repulsors.map((one): Drawn => [DRAWINGS.repulsor, one]),
    ...level.winds.map((one): Drawn => [DRAWINGS.wind, one]),
    ...mouths.map((one): Drawn => [DRAWINGS.wormhole, one]),
    [DRAWINGS.blackHole, level.blackHole],
    ...level.asteroids.map((one, i): Drawn => [DRAWINGS.asteroid, one, one.id ?? String(i)]),
    ...level.novae.map((one): Drawn => [DRAWINGS.nova, one]),
    ...level.minerals.map((one): Drawn => [DRAWINGS.mineral, one]),
    ...level.aliens.map((one): Drawn => [DRAWINGS.alien, one]),
    [HER, { ...level.astronaut, radius: HER_RADIUS }],
  ];
}

/** A canvas in which the unit circle of the drawings is the rim of the object. */
function drawRound(brush: CanvasRenderingContext2D, [drawing, circle, key]: Drawn, least: number): void {
  const radius = Math.max(circle.radius, least);
  const parts = [...drawing.parts(circle as never, key)].sort((one, other) => one.depth - other.depth);
  for (const { texture, scale = 1, offset, rotation = 0 } of parts) {
    brush.save();
    brush.translate(circle.x + radius * (offset?.x ?? 0), circle.y + radius * (offset?.y ?? 0));
    brush.rotate(rotation);
    brush.scale(radius * scale, radius * scale);
    // light around hot objects is no drawing of their own
    if (texture in drawing.textures) drawing.textures[texture](brush, COLOURS, 'dark');
    else drawGlow(brush);
    brush.restore();
  }
}

function drawGlow(brush: CanvasRenderingContext2D): void {
  const light = brush.createRadialGradient(0, 0, 0.3, 0, 0, 1);
  light.addColorStop(0, `${COLOURS.nova}80`);
  light.addColorStop(1, `${COLOURS.nova}00`);
  brush.fillStyle = light;
  brush.fillRect(-1, -1, 2, 2);
}

/** Draws a level small, as it looks when it is played. */
export function drawThumbnail(canvas: HTMLCanvasElement, level: Level): void {
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const brush = canvas.getContext('2d');
  if (brush === null) return;
  const drawn = drawnOf(level);
  const circles = drawn.map(([, circle]) => circle);
  const left = Math.min(...circles.map(({ x, radius }) => x - radius)) - MARGIN;
  const right = Math.max(...circles.map(({ x, radius }) => x + radius)) + MARGIN;
  const top = Math.min(...circles.map(({ y, radius }) => y - radius)) - MARGIN;
  const bottom = Math.max(...circles.map(({ y, radius }) => y + radius)) + MARGIN;
  const zoom = Math.min(WIDTH / Math.max(LEAST_WIDTH, right - left), HEIGHT / (bottom - top));
  brush.translate(WIDTH / 2, HEIGHT / 2);
  brush.scale(zoom, zoom);
  brush.translate(-(left + right) / 2, -(top + bottom) / 2);
  for (const one of drawn) drawRound(brush, one, LEAST_RADIUS / zoom);
}

/** Draws the black hole of the title. */
export function drawTitle(canvas: HTMLCanvasElement): void {
  const side = 480;
  canvas.width = side;
  canvas.height = side;
  const brush = canvas.getContext('2d');
  if (brush !== null) drawRound(brush, [DRAWINGS.blackHole, { x: side / 2, y: side / 2, radius: side / 4 }], 0);
}
