import type { Circle, Level } from '../schema/index.ts';
import { drawAlien, drawSight } from './alien.ts';
import { drawAsteroid } from './asteroid.ts';
import { drawBlackHole } from './black-hole.ts';
import { drawHotAsteroid } from './hot-asteroid.ts';
import { drawMineral } from './mineral.ts';
import { drawNova } from './nova.ts';
import { place } from './place.ts';
import { drawRepulsor } from './repulsor.ts';
import { drawSpeck, SPECKS_FROM, type SpeckKind } from './speck.ts';
import type { Theme } from './theme.ts';
import type { View } from './view.ts';
import { num } from './xml.ts';

/** Nothing is drawn smaller than this: radius in units of the picture. */
const LEAST = 4;

/** Around a thing that is drawn larger than it is, so that nobody takes what is drawn for its size. */
const drawRing = (radius: number, view: View, theme: Theme): string =>
  `<circle r="${num(2 * radius)}" fill="none" stroke="${theme.text}" stroke-opacity=".6" stroke-width="${num(0.8 / view.scale)}"/>`;

/** Everything in the level but the astronaut, from what lies at the back to what must never be hidden. */
export function drawObjects(view: View, theme: Theme, level: Level): string {
  const { repulsors, aliens, asteroids, novae, minerals } = level;
  const crowded = repulsors.length + aliens.length + asteroids.length + novae.length + minerals.length >= SPECKS_FROM;
  const parts: string[] = [];
  const put = (
    kind: SpeckKind,
    index: number,
    circle: Circle,
    draw: (radius: number, index: number, theme: Theme) => string,
  ): void => {
    const least = LEAST / view.scale;
    const drawing = crowded
      ? drawSpeck(kind, circle.radius, theme)
      : circle.radius < least
        ? draw(least, index, theme) + drawRing(least, view, theme)
        : draw(circle.radius, index, theme);
    parts.push(place(view, kind, index, circle, drawing));
  };
  for (const [i, o] of repulsors.entries()) put('repulsor', i, o, (radius) => drawRepulsor(radius, theme));
  if (!crowded) for (const [i, o] of aliens.entries()) parts.push(place(view, 'sight', i, o, drawSight(theme)));
  parts.push(place(view, 'black-hole', 0, level.blackHole, drawBlackHole(level.blackHole.radius, theme)));
  for (const [i, o] of asteroids.entries()) {
    if (o.hot) put('hot-asteroid', i, o, drawHotAsteroid);
    else put('asteroid', i, o, drawAsteroid);
  }
  for (const [i, o] of novae.entries()) put('nova', i, o, drawNova);
  for (const [i, o] of aliens.entries()) put('alien', i, o, (radius) => drawAlien(radius, theme));
  for (const [i, o] of minerals.entries()) put('mineral', i, o, (radius) => drawMineral(radius, theme));
  return parts.join('');
}
