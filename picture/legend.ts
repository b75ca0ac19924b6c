import {
  appearanceOfObject,
  isVariant,
  type Level,
  LISTED_KINDS,
  type ObjectKind,
  rulesOf,
  SINGLE_KINDS,
} from '../schema/index.ts';
import { IN_PICTURE } from './kinds/index.ts';
import { drawText, textWidth } from './text.ts';
import type { Theme } from './theme.ts';
import { thingsOf } from './view.ts';
import { num } from './xml.ts';

const ICON = 9;
const LABEL = 7;
const ROW = 25;
const GAP = 20;

/** An entry of the legend. */
export interface LegendEntry {
  readonly label: string;
  /** SVG around the origin; null for an entry without an icon. */
  readonly icon: string | null;
}

/** The legend's entries for the objects of one kind, with one for its variant. */
function entriesOfKind(level: Level, theme: Theme, kind: ObjectKind): LegendEntry[] {
  const { legend, draw } = IN_PICTURE[kind];
  if (legend === null) return [];
  const things = thingsOf(level, kind);
  return [false, true].flatMap((varied): LegendEntry[] => {
    const object = things.find((thing) => isVariant(kind, thing) === varied);
    if (object === undefined) return [];
    const { radius, factor } = legend;
    const icon = radiusIcon(draw({ object, place: 0, radius, index: 0, theme, rules: rulesOf(level) }), radius);
    const label = appearanceOfObject(kind, object).one;
    return [{ label, icon: factor === undefined ? icon : `<g transform="scale(${num(factor).replace(/^0/, '')})">${icon}</g>` }];
  });
}

const radiusIcon = (drawing: string, radius: number): string => `<g transform="scale(${num(ICON / radius)})">${drawing}</g>`;

function entriesOf(level: Level, theme: Theme, runs: 'none' | 'one' | 'several', others: readonly LegendEntry[]): LegendEntry[] {
  const entries: LegendEntry[] = [...others];
  if (runs !== 'none') {
    const dots = `<circle r="2.7" cx="-4" fill="${theme.text}"/><circle r="2.7" cx="6" fill="${theme.text}"/>`;
    entries.push(
      {
        label: 'gun held',
        icon: `<path d="M-10 3C-4-4 4-4 10-1" fill="none" stroke="${theme.gun}" stroke-width="4.6" stroke-linecap="round"/>`,
      },
      {
        label: runs === 'one' ? 'coasting, one dot per second' : 'coasting',
        icon: `<path d="M-10 0H10" stroke="${theme.coast}" stroke-width="1.5"/>${runs === 'one' ? dots : ''}`,
      },
    );
  }
  for (const kind of [...LISTED_KINDS, ...SINGLE_KINDS]) entries.push(...entriesOfKind(level, theme, kind));
  if (level.asteroids.length > 0) {
    entries.push({
      label: 'range',
      icon: `<circle r="${ICON}" fill="${theme.range}" fill-opacity=".12" stroke="${theme.range}" stroke-opacity=".7" stroke-dasharray="1.5 3" stroke-linecap="round"/>`,
    });
  }
  return entries;
}

/** Draws the legend: the meaning of the icons in this picture, in rows of at most `width` units. `others` come first. */
export function drawLegend(
  level: Level,
  theme: Theme,
  runs: 'none' | 'one' | 'several',
  others: readonly LegendEntry[],
  x: number,
  y: number,
  width: number,
): { readonly svg: string; readonly height: number } {
  let left = x;
  let top = y;
  let svg = '';
  for (const { label, icon } of entriesOf(level, theme, runs, others)) {
    const iconWidth = icon === null ? 0 : 2 * ICON + 7;
    const entryWidth = iconWidth + textWidth(label, LABEL);
    if (left > x && left + entryWidth > x + width) {
      left = x;
      top += ROW;
    }
    const sign = icon === null ? '' : `<g transform="translate(${num(left + ICON)} ${num(top)})">${icon}</g>`;
    svg += sign + drawText(label, left + iconWidth, top + LABEL / 2, { size: LABEL, color: theme.muted, maxWidth: width });
    left += entryWidth + GAP;
  }
  return { svg: `<g data-kind="legend">${svg}</g>`, height: top - y + ROW };
}
