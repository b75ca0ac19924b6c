import type { GameObjects } from 'phaser';
import { useMemo } from 'react';
import { heatShades, visitsInWords } from '../../picture/index.ts';
import type { Explored } from '../../solver/index.ts';

// Heat maps over the level: their squares, and the legend that says what a shade stands for.

/**
 * Fills the squares of a heat map.
 * @param opacityOf the opacity of a shade on the canvas, 0 to 1, from that in pictures
 */
export function fillSquares(
  graphics: GameObjects.Graphics,
  explored: Explored,
  colour: number,
  opacityOf: (shade: number) => number,
): void {
  const { cellSize } = explored;
  for (const { opacity, cells } of heatShades(explored)) {
    graphics.fillStyle(colour, opacityOf(opacity));
    for (const { x, y } of cells) graphics.fillRect(x - cellSize / 2, y - cellSize / 2, cellSize, cellSize);
  }
}

/** How opaque a shade of the heat map of deaths is: there are fewer squares than in the map of a search, so they are stronger. */
export const deathOpacity = (shade: number): number => Math.min(1, 0.1 + 1.1 * shade);

interface ShadeLegendProps {
  /** The name of the map. */
  readonly label: string;
  /** What its squares count. */
  readonly caption: string;
  readonly map: Parameters<typeof heatShades>[0];
  /** CSS */
  readonly colour: string;
  /** The opacity of a shade on the canvas, 0 to 1, from that in pictures. */
  opacityOf(shade: number): number;
  /** The lower corner of the canvas that it is in. */
  readonly corner: 'left' | 'right';
}

/** The legend of a heat map on the canvas: what it counts, and how much each shade stands for. Empty without squares. */
export function ShadeLegend({ label, caption, map, colour, opacityOf, corner }: ShadeLegendProps) {
  const shades = useMemo(() => heatShades(map), [map]);
  if (shades.length === 0) return null;
  return (
    <figure className={`shades shades--${corner}`} aria-label={label}>
      <figcaption>{caption}</figcaption>
      <ul className="shades__list numbers">
        {shades.map((shade) => (
          <li key={shade.opacity}>
            <span className="shades__square" aria-hidden>
              <span style={{ background: colour, opacity: opacityOf(shade.opacity) }} />
            </span>
            {visitsInWords(shade)}
          </li>
        ))}
      </ul>
    </figure>
  );
}
