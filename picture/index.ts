/**
 * Draws pictures of levels as SVG: the objects, runs, searches and proofs, with a timeline and a legend.
 *
 * @module
 */
import type { Run } from '../engine/index.ts';
import type { Hold, Level } from '../schema/index.ts';
import { drawBackground, drawGradients, drawRanges } from './background.ts';
import { drawCaption, outcomeText } from './caption.ts';
import { drawContact, drawGap } from './contact.ts';
import { drawFailureRings, drawFailures, type Failures, failureSigns } from './failures.ts';
import { drawHeat, type Explored, heatSigns } from './heat.ts';
import type { LegendEntry } from './legend.ts';
import { drawLost, type Lost, lostSigns } from './lost.ts';
import { drawObjects } from './objects.ts';
import { drawProof, type ProofOverlay, proofSigns } from './proof.ts';
import {
  drawAlienWays,
  drawCollected,
  drawEnd,
  drawPresses,
  drawSeconds,
  drawStart,
  drawStartFigure,
  drawTethers,
  drawWay,
} from './run.ts';
import { drawFan, drawFanSign, drawSeveral, type NamedRun } from './several.ts';
import { THEMES, type Theme } from './theme.ts';
import { frame } from './view.ts';
import { type PathPoint, stretchesOf } from './way.ts';
import { escapeXml, num } from './xml.ts';

export { heatCaption, heatColour, heatShades, visitsInWords } from './heat.ts';
export type { NamedRun } from './several.ts';

/** What {@link renderSvg} draws besides the objects of the level. */
export interface RenderOptions {
  /** A simulated run of the level to draw. */
  readonly run?: Run;
  /** The holds that the timeline shows; by default those of the run. */
  readonly holds?: readonly Hold[];
  /** Width of the picture, px; 960 by default. The height follows from it. */
  readonly width?: number;
  /** The colours; `dark` by default. */
  readonly theme?: Theme['name'];
  /** The title above the timeline; by default the level's name. */
  readonly title?: string;
  /** A sentence below the title. */
  readonly note?: string;
  /** Several runs to draw, each in its own colour, instead of `run`. */
  readonly ways?: readonly NamedRun[];
  /** Where a search has been, to draw as a heat map. */
  readonly explored?: Explored;
  /** Where attempts of players fail, to draw as a heat map. */
  readonly failures?: Failures;
  /** Where it is already lost although she lives on, to draw as marks. */
  readonly lost?: Lost;
  /** The same run with its presses and releases shifted, to draw as thin paths. */
  readonly fan?: readonly Run[];
  /** The time of the closest approach to the black hole, s; the distance is drawn there. */
  readonly nearest?: number;
  /** A proof to draw: why something cannot be reached. */
  readonly proof?: ProofOverlay;
  /** Whether to draw texts; true by default. Pictures that are too small for them set it to false. */
  readonly words?: boolean;
}

/** Pictures are laid out for this width, in units, and then scaled, so that all of them look alike. */
const UNITS = 960;

/**
 * From this width on, px, the smallest letters of the layout are legible: capitals of 8 px, as in a font of 11 px. Narrower
 * pictures are laid out in fewer units, so that their letters stay as large.
 */
const LEGIBLE_WIDTH = 1180;

/** The least number of units: fewer have no room for words. */
const FEWEST_UNITS = 260;

const unitsFor = (width: number): number => Math.round(Math.max(FEWEST_UNITS, Math.min(UNITS, (width * UNITS) / LEGIBLE_WIDTH)));

/**
 * Draws a level as a standalone SVG document: its objects, and the run when one is given. The same input gives the same text.
 * Texts from the level are escaped.
 * @param level the level
 * @param options what to draw besides the objects, and how
 * @returns the SVG document as text
 */
export function renderSvg(level: Level, options: RenderOptions = {}): string {
  const {
    run,
    holds,
    width = UNITS,
    title = level.name,
    note = '',
    ways = [],
    explored,
    failures,
    lost,
    fan,
    nearest,
    proof,
    words = true,
  } = options;
  const theme = THEMES[options.theme ?? 'dark'];
  const units = words ? unitsFor(width) : UNITS;
  const stretches = run === undefined ? [] : stretchesOf(run);
  const others = ways.map((way) => stretchesOf(way.run));
  const view = frame(level, [...[...stretches, ...others.flat()].flatMap(({ points }) => points), ...cornersOf(options)], units);
  const signs = signsOf(theme, options);
  const caption = words
    ? drawCaption(level, theme, view.height, units, { title, run, holds, ways, note, signs })
    : { svg: '', height: 0 };
  const height = view.height + caption.height;

  const scene = [drawBackground(view, theme, level)];
  if (explored !== undefined) scene.push(drawHeat(view, theme, explored));
  scene.push(drawRanges(view, theme, level), drawObjects(view, theme, level, width));
  if (failures !== undefined) scene.push(drawFailures(view, theme, failures));
  if (lost !== undefined) scene.push(drawLost(view, theme, lost));
  if (proof !== undefined) scene.push(drawProof(view, theme, proof));
  if (fan !== undefined) scene.push(drawFan(view, theme, fan));
  if (ways.length > 0) {
    scene.push(drawSeveral(view, theme, others, ways));
    for (const way of ways) if (way.run.outcome !== 'completed') scene.push(drawContact(view, theme, level, way.run));
  }
  if (run !== undefined) {
    scene.push(
      drawTethers(view, theme, level, run),
      drawAlienWays(view, theme, level, run),
      drawWay(view, theme, stretches),
      drawSeconds(view, theme, run),
      words ? drawPresses(view, theme, level, run) : '',
      drawCollected(view, theme, level, run),
    );
  }
  scene.push(words ? drawStart(view, theme, level, run) : drawStartFigure(view, theme, level));
  if (run !== undefined) scene.push(drawEnd(view, theme, level, run));
  if (run !== undefined && nearest !== undefined) scene.push(drawGap(view, theme, level, run, nearest));

  if (failures !== undefined && words) scene.push(drawFailureRings(view, theme, failures));

  const about = run === undefined ? level.description : outcomeText(level, run);
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${num(width)}" height="${num((height * width) / units)}" viewBox="0 0 ${units} ${num(height)}" role="img">` +
    `<title>${escapeXml(title)}</title><desc>${escapeXml(note === '' ? about : note)}</desc>${drawGradients(theme)}` +
    `<clipPath id="gq-scene"><rect width="${units}" height="${num(view.height)}"/></clipPath>` +
    `<g data-kind="scene" clip-path="url(#gq-scene)">${scene.join('')}</g>${caption.svg}</svg>\n`
  );
}

/** Places that the picture has to contain besides the level's objects. */
function cornersOf({ explored, failures, lost, proof }: RenderOptions): PathPoint[] {
  const cells = (explored?.cells ?? []).map(({ x, y }): PathPoint => [x, y]);
  const lines = (proof?.lines ?? []).flatMap(({ points }) => points.map(({ x, y }): PathPoint => [x, y]));
  const clusters = (failures?.clusters ?? []).map(({ x, y }): PathPoint => [x, y]);
  const states = (lost?.states ?? []).map(({ x, y }): PathPoint => [x, y]);
  return [...cells, ...lines, ...clusters, ...states];
}

function signsOf(theme: Theme, { explored, failures, lost, fan, proof }: RenderOptions): LegendEntry[] {
  const signs: LegendEntry[] = [];
  if (explored !== undefined) signs.push(...heatSigns(theme, explored));
  if (failures !== undefined) signs.push(...failureSigns(theme, failures));
  if (lost !== undefined) signs.push(...lostSigns(theme, lost));
  for (const completes of [true, false]) {
    if (!fan?.some(({ outcome }) => (outcome === 'completed') === completes)) continue;
    signs.push({ label: completes ? 'still completes it' : 'fails', icon: drawFanSign(theme, completes) });
  }
  return proof === undefined ? signs : [...signs, ...proofSigns(theme, proof)];
}
