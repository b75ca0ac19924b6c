import type { Run } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { drawBackground } from './background.ts';
import { drawCaption, outcomeText } from './caption.ts';
import { drawGradients } from './gradients.ts';
import { drawTick } from './mineral.ts';
import { drawObjects } from './objects.ts';
import { place } from './place.ts';
import { drawRanges } from './range.ts';
import { drawAlienWays, drawEnd, drawPresses, drawSeconds, drawTethers, drawWay } from './run.ts';
import { drawStart } from './start.ts';
import { THEMES, type Theme } from './theme.ts';
import { frame, type View } from './view.ts';
import { stretchesOf } from './way.ts';
import { escapeXml, num } from './xml.ts';

export { renderPng } from './png.ts';

export interface RenderOptions {
  /** A simulated run of the level, to be drawn into it. */
  readonly run?: Run;
  /** What the timeline shows; the run's own presses and releases when left out. */
  readonly holds?: readonly Hold[];
  /** Width of the picture in px; 960 when left out. The height follows. */
  readonly width?: number;
  readonly theme?: Theme['name'];
  /** Above the timeline; the level's name when left out. */
  readonly title?: string;
}

/** Everything is laid out for a picture of this width and then scaled, so that pictures of any size look alike. */
const UNITS = 960;

function drawCollected(view: View, theme: Theme, level: Level, run: Run): string {
  const indices = [...new Set(run.minerals.map(({ index }) => index))];
  return indices.map((i) => place(view, 'collected', i, level.minerals[i], drawTick(theme))).join('');
}

/**
 * A picture of a level as a standalone SVG document: its objects, and the run when one is given. The same input gives
 * the same text. Texts from the level are escaped.
 */
export function renderSvg(level: Level, options: RenderOptions = {}): string {
  const { run, holds, width = UNITS, title = level.name } = options;
  const theme = THEMES[options.theme ?? 'dark'];
  const stretches = run === undefined ? [] : stretchesOf(run);
  const view = frame(
    level,
    stretches.flatMap(({ points }) => points),
    UNITS,
  );
  const caption = drawCaption(level, theme, view.height, UNITS, title, run, holds);
  const height = view.height + caption.height;

  const scene = [drawBackground(view, theme, level), drawRanges(view, theme, level), drawObjects(view, theme, level)];
  if (run !== undefined) {
    scene.push(
      drawTethers(view, theme, level, run),
      drawAlienWays(view, theme, level, run),
      drawWay(view, theme, stretches),
      drawSeconds(view, theme, run),
      drawPresses(view, theme, level, run),
      drawCollected(view, theme, level, run),
    );
  }
  scene.push(drawStart(view, theme, level, run));
  if (run !== undefined) scene.push(drawEnd(view, theme, level, run));

  const about = run === undefined ? level.description : outcomeText(level, run);
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${num(width)}" height="${num((height * width) / UNITS)}" viewBox="0 0 ${UNITS} ${num(height)}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(about)}</desc>${drawGradients(theme)}` +
    `<clipPath id="gq-scene"><rect width="${UNITS}" height="${num(view.height)}"/></clipPath>` +
    `<g data-kind="scene" clip-path="url(#gq-scene)">${scene.join('')}</g>${caption.svg}</svg>\n`
  );
}
