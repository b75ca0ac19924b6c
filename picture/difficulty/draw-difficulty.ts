import { type Ground, inked, inkStyle } from '../ink.ts';
import { drawText } from '../text.ts';
import { escapeXml } from '../xml.ts';
import { drawCurves, type SuccessCurve } from './curves.ts';
import { drawWindows, type Edge } from './windows.ts';

/** What a picture of difficulty shows. */
export interface DifficultyPicture {
  readonly title: string;
  /** At most two lines. */
  readonly subtitle: readonly string[];
  readonly curves: readonly SuccessCurve[];
  /** The slack of each press and release of a single level; empty otherwise. */
  readonly edges: readonly Edge[];
  /** The largest shift of an edge that was tried, ticks. */
  readonly limit: number;
}

const WIDTH = 960;
const TOP = 122;
const BOTTOM = 60;
const PLOT_HEIGHT = 380;
const LEAST_ROW = 15;
const ROW = 26;

/**
 * Draws success under timing noise and the slack of each press and release, as a standalone SVG document. The same input gives
 * the same text.
 */
export function drawDifficulty(picture: DifficultyPicture, ground: Ground = 'auto'): string {
  const { title, subtitle, curves, edges, limit } = picture;
  const row = Math.max(LEAST_ROW, Math.min(ROW, PLOT_HEIGHT / Math.max(1, edges.length)));
  const plotHeight = Math.max(PLOT_HEIGHT, edges.length * row);
  const height = TOP + plotHeight + BOTTOM;
  const hasWindows = edges.length > 0;
  const parts = [
    inked(ground, 'panel', `<rect width="${WIDTH}" height="${height}" rx="10" fill="currentColor"/>`),
    inked(ground, 'text', drawText(title, 24, 36, { size: 13, color: 'currentColor', bold: true, maxWidth: WIDTH - 48 })),
    inked(
      ground,
      'muted',
      subtitle
        .map((text, i) => drawText(text, 24, 58 + 16 * i, { size: 8, color: 'currentColor', maxWidth: WIDTH - 48 }))
        .join(''),
    ),
    drawCurves(curves, { left: 76, right: hasWindows ? 520 : 720, top: TOP, bottom: TOP + PLOT_HEIGHT }, ground),
    hasWindows ? drawWindows(edges, limit, { left: 640, right: 920, top: TOP, row }, ground) : '',
  ];
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${height}" viewBox="0 0 ${WIDTH} ${height}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(subtitle.join(' '))}</desc>${inkStyle(ground)}${parts.join('')}</svg>\n`
  );
}
