import type { Run } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { drawLegend } from './legend.ts';
import { drawText, textWidth } from './text.ts';
import type { Theme } from './theme.ts';
import { drawTimeline } from './timeline.ts';
import { num } from './xml.ts';

const PADDING = 26;
const KINDS = { nova: 'nova', asteroid: 'hot asteroid', alien: 'alien', blackHole: 'black hole' } as const;

/** How the run went, in a few words. */
export function outcomeText(level: Level, run: Run): string {
  const time = `${run.time.toFixed(2)} s`;
  const what = {
    completed: `completed in ${time}`,
    collided: `burned by ${run.with === null ? 'a hazard' : `${KINDS[run.with.kind]} ${run.with.index}`} at ${time}`,
    lost: `lost at ${time}`,
    timeout: `nothing ended it in ${time}`,
  }[run.outcome];
  const all = level.minerals.length;
  // `arcade` may count one twice
  const collected = new Set(run.minerals.map(({ index }) => index)).size;
  return all === 0 ? what : `${what} · ${collected} of ${all} mineral${all === 1 ? '' : 's'}`;
}

/** Below the scene: name, outcome, when the gun was held, and what the signs mean. */
export function drawCaption(
  level: Level,
  theme: Theme,
  top: number,
  width: number,
  title: string,
  run: Run | undefined,
  holds: readonly Hold[] | undefined,
): { readonly svg: string; readonly height: number } {
  const inner = width - 2 * PADDING;
  let y = top + 34;
  let outcome = '';
  let outcomeWidth = 0;
  if (run !== undefined) {
    const words = outcomeText(level, run);
    const color = run.outcome === 'completed' ? theme.good : run.outcome === 'timeout' ? theme.muted : theme.bad;
    outcomeWidth = textWidth(words, 9.5) + 24;
    outcome = drawText(words, width - PADDING, y, { size: 9.5, color, anchor: 'end' });
  }
  const name = drawText(title, PADDING, y, { size: 14, color: theme.text, bold: true, maxWidth: inner - outcomeWidth });
  y += 18;
  const timeline = drawTimeline(theme, PADDING, y, inner, run, holds);
  y += timeline === '' ? 8 : 50;
  const legend = drawLegend(level, theme, run !== undefined, PADDING, y, inner);
  const height = y + legend.height - top;
  return {
    svg:
      `<g data-kind="caption"><rect y="${num(top)}" width="${num(width)}" height="${num(height)}" fill="${theme.panel}"/>` +
      `<path d="M0 ${num(top)}H${num(width)}" stroke="${theme.rule}"/>${name}${outcome}${timeline}${legend.svg}</g>`,
    height,
  };
}
