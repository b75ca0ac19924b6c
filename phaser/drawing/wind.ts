import { type Brush, fadingDisc, faint, ring } from './brush.ts';
import type { GameColours, Theme } from './colours.ts';
import type { KindDrawing } from './kind-drawing.ts';

/**
 * The strength in px/s2 at which streaks have their largest size, and the sizes as shares of the disc: even the weakest are
 * visible.
 */
const STRONG = 60;
const LEAST_STREAKS = 0.5;
const MOST_STREAKS = 0.95;

const INK = { dark: '#8fd3ff', light: '#1c74b8' } as const;

function drawDisc(brush: Brush, _: GameColours, theme: Theme): void {
  fadingDisc(brush, 1, [
    [0, faint(INK[theme], 0.05)],
    [1, faint(INK[theme], 0.18)],
  ]);
  ring(brush, 0.985, 0.02, faint(INK[theme], 0.7));
}

/** Streaks to the right. */
function drawStreaks(brush: Brush, _: GameColours, theme: Theme): void {
  brush.strokeStyle = faint(INK[theme], 0.9);
  brush.lineWidth = 0.045;
  brush.lineCap = 'round';
  brush.lineJoin = 'round';
  for (const [y, to] of [
    [-0.45, 0.55],
    [0, 0.8],
    [0.45, 0.55],
  ]) {
    brush.beginPath();
    brush.moveTo(-to, y);
    brush.lineTo(to, y);
    brush.moveTo(to - 0.14, y - 0.12);
    brush.lineTo(to, y);
    brush.lineTo(to - 0.14, y + 0.12);
    brush.stroke();
  }
}

/** Marks a wind of strength 0, which an empty disc would not show. */
function drawCalm(brush: Brush, _: GameColours, theme: Theme): void {
  ring(brush, 0.5, 0.09, faint(INK[theme], 0.9));
}

/** A disc with streaks in the direction of the wind, larger for stronger winds; a small ring for a wind of strength 0. */
export const wind: KindDrawing<{ readonly ax: number; readonly ay: number }> = {
  textures: { wind: drawDisc, streaks: drawStreaks, calm: drawCalm },
  parts({ ax, ay }) {
    const strength = Math.hypot(ax, ay);
    const disc = { texture: 'wind', depth: 1.5 };
    if (strength === 0) return [disc, { texture: 'calm', depth: 1.6, scale: 0.4 }];
    const scale = LEAST_STREAKS + (MOST_STREAKS - LEAST_STREAKS) * Math.min(1, strength / STRONG);
    return [disc, { texture: 'streaks', depth: 1.6, scale, rotation: Math.atan2(ay, ax) }];
  },
  spin: 0,
};
