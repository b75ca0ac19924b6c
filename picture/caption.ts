import { type Run, TICK } from '../engine/index.ts';
import { type Hold, type Level, touchedName } from '../schema/index.ts';
import { drawLegend, type LegendEntry } from './legend.ts';
import { drawSeveralTimelines, type NamedRun } from './several.ts';
import { drawText, textWidth, wrapText } from './text.ts';
import type { Theme } from './theme.ts';
import { heldTimes } from './way.ts';
import { num } from './xml.ts';

/** Margin at the sides, in units; smaller in narrow pictures. */
const PADDING = 26;

/** How the run ended, in a few words. */
export function outcomeText(level: Level, run: Run): string {
  const time = `${run.time.toFixed(2)} s`;
  const what = {
    completed: `completed in ${time}`,
    collided: `burned by ${run.with === null ? 'a hazard' : touchedName(run.with.kind, run.with.index)} at ${time}`,
    lost: `lost at ${time}`,
    timeout: `not over after ${time}`,
  }[run.outcome];
  const all = level.minerals.length;
  // `arcade` may count one mineral twice.
  const collected = new Set(run.minerals.map(({ index }) => index)).size;
  return all === 0 ? what : `${what} · ${collected} of ${all} mineral${all === 1 ? '' : 's'}`;
}

/** The contents of the caption. */
interface Caption {
  readonly title: string;
  readonly run: Run | undefined;
  readonly holds: readonly Hold[] | undefined;
  /** Several runs instead of one; empty for one or none. */
  readonly ways: readonly NamedRun[];
  /** A sentence below the title; '' for none. */
  readonly note: string;
  /** Entries of the legend that do not stand for objects of the level. */
  readonly signs: readonly LegendEntry[];
}

const TITLE = 14;
const OUTCOME = 9.5;
const NOTE = 7.6;
/** Distance between two lines of the outcome, in units. */
const LINE = 18;
/** From this width on, in units, a long name is cut; in narrower pictures the outcome moves below it. */
const ROOMY = 900;

/** Draws what stands below the scene: name, outcome, timeline and legend. */
export function drawCaption(
  level: Level,
  theme: Theme,
  top: number,
  width: number,
  { title, run, holds, ways, note, signs }: Caption,
): { readonly svg: string; readonly height: number } {
  const padding = Math.min(PADDING, width / 20);
  const inner = width - 2 * padding;
  let y = top + 34;
  let outcome = '';
  let outcomeWidth = 0;
  let below = 0;
  if (run !== undefined) {
    const words = outcomeText(level, run);
    const color = run.outcome === 'completed' ? theme.good : run.outcome === 'timeout' ? theme.muted : theme.bad;
    outcomeWidth = textWidth(words, OUTCOME) + 24;
    // The outcome stands beside the name, or below it where there is no room for both.
    const isBeside = textWidth(title, TITLE) + outcomeWidth <= inner || width >= ROOMY;
    if (isBeside) outcome = drawText(words, width - padding, y, { size: OUTCOME, color, anchor: 'end' });
    else {
      outcomeWidth = 0;
      const lines = wrapText(words, OUTCOME, inner);
      outcome = lines.map((line, i) => drawText(line, padding, y + LINE * (i + 1), { size: OUTCOME, color })).join('');
      below = LINE * lines.length;
    }
  }
  const name = drawText(title, padding, y, { size: TITLE, color: theme.text, bold: true, maxWidth: inner - outcomeWidth });
  y += 18 + below;
  const notes = note === '' ? [] : wrapText(note, NOTE, inner);
  const written = notes.map((line, i) => drawText(line, padding, y + 6 + 15 * i, { size: NOTE, color: theme.muted })).join('');
  y += 15 * notes.length + (notes.length > 0 ? 6 : 0);
  let timeline: string;
  if (ways.length > 0) {
    const several = drawSeveralTimelines(theme, ways, padding, y, inner);
    timeline = several.svg;
    y += several.height + 8;
  } else {
    timeline = drawTimeline(theme, padding, y, inner, run, holds);
    y += timeline === '' ? 8 : 50;
  }
  const legend = drawLegend(
    level,
    theme,
    ways.length > 0 ? 'several' : run === undefined ? 'none' : 'one',
    signs,
    padding,
    y,
    inner,
  );
  const height = y + legend.height - top;
  return {
    svg:
      `<g data-kind="caption"><rect y="${num(top)}" width="${num(width)}" height="${num(height)}" fill="${theme.panel}"/>` +
      `<path d="M0 ${num(top)}H${num(width)}" stroke="${theme.rule}"/>${name}${outcome}${written}${timeline}${legend.svg}</g>`,
    height,
  };
}

const HEIGHT = 9;

/** The least distance between two marks, and between two labels, in units. */
const MARK_ROOM = 30;
const LABEL_ROOM = 69;

// Seconds between two marks: wide pictures get at most about thirty marks.
const STEPS = [1, 2, 5, 10, 30, 60, 300, 600];

/** Draws the holds as blocks on a timeline with a mark for each second. */
function drawTimeline(
  theme: Theme,
  x: number,
  y: number,
  width: number,
  run: Run | undefined,
  holds: readonly Hold[] | undefined,
): string {
  const held =
    holds?.map(([press, release]): [number, number] => [press * TICK, release * TICK]) ??
    (run === undefined ? [] : heldTimes(run));
  const end = run?.time ?? held.reduce((last, [, release]) => Math.max(last, release), 0);
  if (!(end > 0)) return '';
  const at = (time: number): number => x + (width * Math.min(time, end)) / end;
  const blocks = held
    .filter(([press]) => press < end)
    .map(
      ([press, release]) =>
        `<rect x="${num(at(press))}" y="${num(y)}" width="${num(Math.max(1, at(release) - at(press)))}" height="${HEIGHT}" rx="2"/>`,
    )
    .join('');
  const step = STEPS.find((s) => end / s <= width / MARK_ROOM) ?? 3600;
  const label = STEPS.find((s) => s % step === 0 && end / s <= width / LABEL_ROOM) ?? 3600;
  let marks = '';
  let labels = '';
  for (let time = 0; time <= end; time += step) {
    marks += `M${num(at(time))} ${num(y + HEIGHT + 2)}v${time % label === 0 ? 5 : 3}`;
    if (time % label === 0)
      labels += drawText(`${time} s`, at(time), y + HEIGHT + 17, {
        size: 6.5,
        color: theme.muted,
        anchor: time === 0 ? 'start' : 'middle',
      });
  }
  return (
    `<g data-kind="timeline"><rect x="${num(x)}" y="${num(y)}" width="${num(width)}" height="${HEIGHT}" rx="2" fill="${theme.rule}"/>` +
    `<g fill="${theme.gun}">${blocks}</g><path d="${marks}" stroke="${theme.muted}" stroke-width="1"/>${labels}</g>`
  );
}
