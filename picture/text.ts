import { glyphOf } from './glyphs.ts';
import { escapeXml, num } from './xml.ts';

/** How a text is drawn. */
export interface TextStyle {
  /** Height of a capital letter, in units of the picture. */
  readonly size: number;
  readonly color: string;
  readonly anchor?: 'start' | 'middle' | 'end';
  readonly bold?: boolean;
  readonly opacity?: number;
  /** Longer texts are cut and end in an ellipsis; units of the picture. */
  readonly maxWidth?: number;
}

const CAPITAL = 10;
const GAP = 2.3;
// The assumed width of a letter that the stroke font does not have, in units of that font.
const UNKNOWN_WIDTH = 9;

const isDrawable = (text: string): boolean => [...text].every((c) => glyphOf(c) !== null);

/** The width of a text, in the units of `size`; an estimate for letters that the stroke font does not have. */
export function textWidth(text: string, size: number): number {
  let width = -GAP;
  for (const c of text) width += (glyphOf(c)?.width ?? UNKNOWN_WIDTH) + GAP;
  return (Math.max(0, width) * size) / CAPITAL;
}

function shorten(text: string, size: number, maxWidth: number): string {
  if (textWidth(text, size) <= maxWidth) return text;
  const letters = [...text];
  while (letters.length > 0 && textWidth(`${letters.join('').trimEnd()}…`, size) > maxWidth) letters.pop();
  return `${letters.join('').trimEnd()}…`;
}

/** Breaks a text into lines of at most `width`, where its words allow it. */
export function wrapText(text: string, size: number, width: number): string[] {
  const lines: string[] = [];
  let line = '';
  for (const word of text.split(' ')) {
    const longer = line === '' ? word : `${line} ${word}`;
    if (line !== '' && textWidth(longer, size) > width) {
      lines.push(line);
      line = word;
    } else line = longer;
  }
  return [...lines, line];
}

/**
 * Draws a line of text on the baseline y. It is drawn as strokes and needs no font; a text with letters that the stroke font
 * does not have is left to the viewer's fonts.
 */
export function drawText(text: string, x: number, y: number, style: TextStyle): string {
  const shown = style.maxWidth === undefined ? text : shorten(text, style.size, style.maxWidth);
  const opacity = style.opacity === undefined ? '' : ` opacity="${style.opacity}"`;
  const anchor = style.anchor ?? 'start';
  if (!isDrawable(shown)) {
    return (
      `<text x="${num(x)}" y="${num(y)}" fill="${style.color}" font-family="sans-serif" font-size="${num(style.size * 1.38)}"` +
      `${style.bold ? ' font-weight="700"' : ''} text-anchor="${anchor}"${opacity}>${escapeXml(shown)}</text>`
    );
  }
  const width = textWidth(shown, style.size);
  const left = anchor === 'start' ? x : anchor === 'end' ? x - width : x - width / 2;
  let at = 0;
  let d = '';
  for (const c of shown) {
    const glyph = glyphOf(c);
    if (glyph === null) continue;
    for (const stroke of glyph.strokes) d += `M${num(at + stroke.x)} ${num(stroke.y)}${stroke.rest}`;
    at += glyph.width + GAP;
  }
  return (
    `<path d="${d}" transform="translate(${num(left)} ${num(y)}) scale(${Number((style.size / CAPITAL).toPrecision(4))})" fill="none" ` +
    `stroke="${style.color}" stroke-width="${style.bold ? 1.7 : 1.15}" stroke-linecap="round" stroke-linejoin="round"${opacity}/>`
  );
}
