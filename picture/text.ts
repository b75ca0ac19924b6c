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

/**
 * A small stroke font, so that a picture needs no installed font and looks the same everywhere. Units: capitals are 10 high,
 * small letters 7; y grows downwards from the baseline. A glyph has a width and strokes; a stroke is its first point, and the
 * rest as relative path commands.
 */
interface Glyph {
  readonly width: number;
  readonly strokes: readonly { readonly x: number; readonly y: number; readonly rest: string }[];
}

const RIGHT_BOWL = '0,-3.5 c0 2.2 1 3.5 2.5 3.5s2.5 -1.3 2.5 -3.5s-1 -3.5 -2.5 -3.5s-2.5 1.3 -2.5 3.5';
const LEFT_BOWL = '5,-3.5 c0 2.2 -1 3.5 -2.5 3.5s-2.5 -1.3 -2.5 -3.5s1 -3.5 2.5 -3.5s2.5 1.3 2.5 3.5';
const ROUND = '4,-10 c2.4 0 4 2 4 5s-1.6 5 -4 5s-4 -2 -4 -5s1.6 -5 4 -5z';
const OPEN = '7,-8 c-.8 -1.4 -1.9 -2 -3.1 -2c-2.4 0 -3.9 2 -3.9 5s1.5 5 3.9 5c';
const ARCH = '0,-4.2 c.3 -1.8 1.2 -2.8 2.5 -2.8c1.5 0 2.2 1 2.2 2.7v4.3';

// One line per glyph: width | stroke | stroke …
const SOURCE: Record<string, string> = {
  ' ': '2.6',
  A: '8|0,0 l4 -10l4 10|1.4,-3.5 h5.2',
  B: '6.5|0,0 v-10h3.4a2.5 2.5 0 0 1 0 5h-3.4|3.4,-5 h.6a2.5 2.5 0 0 1 0 5h-4',
  C: `7|${OPEN}1.2 0 2.3 -.6 3.1 -2`,
  D: '7.3|0,0 v-10h3c2.7 0 4.3 2 4.3 5s-1.6 5 -4.3 5z',
  E: '5.6|5.6,-10 h-5.6v10h5.6|0,-5 h4.8',
  F: '5.4|5.4,-10 h-5.4v10|0,-5 h4.6',
  G: `7.3|${OPEN}2 0 3.4 -1.3 3.4 -4.6h-3`,
  H: '7|0,0 v-10|7,0 v-10|0,-5 h7',
  I: '0|0,0 v-10',
  J: '4|4,-10 v7.2c0 1.8 -.8 2.8 -2.2 2.8c-.8 0 -1.4 -.3 -1.8 -.9',
  K: '6.4|0,0 v-10|6,-10 l-6 6|2.2,-6.2 l4.2 6.2',
  L: '5.4|0,-10 v10h5.4',
  M: '8|0,0 v-10l4 6l4 -6v10',
  N: '7|0,0 v-10l7 10v-10',
  O: `8|${ROUND}`,
  P: '6.5|0,0 v-10h3.7a2.8 2.8 0 0 1 0 5.6h-3.7',
  Q: `8|${ROUND}|5,-2.5 l3 3`,
  R: '6.7|0,0 v-10h3.7a2.8 2.8 0 0 1 0 5.6h-3.7|3.4,-4.4 l3.3 4.4',
  S: '6.4|6.2,-8.4 c-.6 -1 -1.7 -1.6 -3 -1.6c-1.7 0 -2.9 1 -2.9 2.5c0 3.4 6.2 1.5 6.2 5c0 1.6 -1.3 2.5 -3.2 2.5c-1.5 0 -2.7 -.6 -3.3 -1.8',
  T: '7|0,-10 h7|3.5,-10 v10',
  U: '7|0,-10 v6.5c0 2.2 1.3 3.5 3.5 3.5s3.5 -1.3 3.5 -3.5v-6.5',
  V: '7.6|0,-10 l3.8 10l3.8 -10',
  W: '10.4|0,-10 l2.6 10l2.6 -8l2.6 8l2.6 -10',
  X: '7|0,-10 l7 10|7,-10 l-7 10',
  Y: '7.2|0,-10 l3.6 5.2l3.6 -5.2|3.6,-4.8 v4.8',
  Z: '6.8|0,-10 h6.6l-6.6 10h6.8',
  a: `5|5,-7 v7|${LEFT_BOWL}`,
  b: `5|0,-10 v10|${RIGHT_BOWL}`,
  c: '4.6|4.6,-5.8 c-.5 -.8 -1.2 -1.2 -2 -1.2c-1.6 0 -2.6 1.4 -2.6 3.5s1 3.5 2.6 3.5c.8 0 1.5 -.4 2 -1.2',
  d: `5|5,-10 v10|${LEFT_BOWL}`,
  e: '5|0,-3.7 h5c0 -2 -1 -3.3 -2.5 -3.3s-2.5 1.3 -2.5 3.5s1 3.5 2.6 3.5c.9 0 1.6 -.4 2.1 -1.2',
  f: '3.2|3.4,-9.8 c-1.5 -.5 -2.2 .3 -2.2 1.9v7.9|0,-7 h3.1',
  g: `5|5,-7 v7.2c0 1.8 -.9 2.8 -2.4 2.8c-1 0 -1.7 -.4 -2.1 -1.1|${LEFT_BOWL}`,
  h: `4.7|0,-10 v10|${ARCH}`,
  i: '0|0,-7 v7|0,-9.7 v.1',
  j: '1.2|1.2,-7 v7.6c0 1.5 -.4 2.2 -1.4 2.4|1.2,-9.7 v.1',
  k: '4.6|0,-10 v10|4.4,-7 l-4.4 4.2|1.7,-4.4 l3 4.4',
  l: '0|0,-10 v10',
  m: '8|0,-7 v7|0,-4.4 c.2 -1.7 1 -2.6 2.1 -2.6c1.3 0 1.9 1 1.9 2.6v4.4|4,-4.4 c.2 -1.7 1 -2.6 2.1 -2.6c1.3 0 1.9 1 1.9 2.6v4.4',
  n: `4.7|0,-7 v7|${ARCH}`,
  o: '5.2|2.6,-7 c1.6 0 2.6 1.3 2.6 3.5s-1 3.5 -2.6 3.5s-2.6 -1.3 -2.6 -3.5s1 -3.5 2.6 -3.5z',
  p: `5|0,-7 v10|${RIGHT_BOWL}`,
  q: `5|5,-7 v10|${LEFT_BOWL}`,
  r: '2.8|0,-7 v7|0,-4 c.3 -2 1.3 -3 3 -2.9',
  s: '4.2|4.1,-5.9 c-.4 -.7 -1.1 -1.1 -2 -1.1c-1.2 0 -2 .7 -2 1.7c0 2.4 4.2 1 4.2 3.5c0 1.1 -.9 1.8 -2.2 1.8c-1 0 -1.8 -.4 -2.2 -1.2',
  t: '3.2|1.3,-9.2 v7.2c0 1.4 .6 2 2 1.9|0,-7 h3.2',
  u: '4.7|0,-7 v4.3c0 1.7 .7 2.7 2.2 2.7c1.3 0 2.2 -1 2.5 -2.8|4.7,-7 v7',
  v: '5|0,-7 l2.5 7l2.5 -7',
  w: '7.2|0,-7 l1.8 7l1.8 -5.6l1.8 5.6l1.8 -7',
  x: '4.6|0,-7 l4.6 7|4.6,-7 l-4.6 7',
  y: '5|0,-7 l2.5 6.8|5,-7 l-3.2 9c-.3 .8 -.8 1.1 -1.6 1',
  z: '4.6|0,-7 h4.4l-4.4 7h4.6',
  0: '5.6|2.8,-10 c1.8 0 2.8 2 2.8 5s-1 5 -2.8 5s-2.8 -2 -2.8 -5s1 -5 2.8 -5z',
  1: '5.6|1.2,-8.2 l2.2 -1.8v10',
  2: '5.6|.2,-7.6 c.2 -1.5 1.2 -2.4 2.6 -2.4c1.5 0 2.6 1 2.6 2.5c0 2.6 -3.6 4.3 -5.2 7.5h5.4',
  3: '5.6|.3,-8.5 c.5 -1 1.4 -1.5 2.4 -1.5c1.5 0 2.5 .9 2.5 2.3c0 1.5 -1 2.4 -3 2.4c2.1 0 3.3 1 3.3 2.6c0 1.6 -1.2 2.7 -2.8 2.7c-1.2 0 -2.2 -.6 -2.7 -1.7',
  4: '5.6|4.2,0 v-10l-4.2 7h5.7',
  5: '5.6|5,-10 h-4.2l-.5 4.6c.6 -.6 1.4 -.9 2.3 -.9c1.7 0 2.9 1.2 2.9 3.1s-1.2 3.2 -2.9 3.2c-1.2 0 -2.1 -.5 -2.6 -1.5',
  6: '5.6|4.9,-9 c-.5 -.7 -1.2 -1 -2 -1c-1.9 0 -2.9 2.4 -2.9 5.9c0 2.6 1 4.1 2.8 4.1c1.6 0 2.8 -1.2 2.8 -3s-1.1 -3 -2.7 -3c-1.3 0 -2.4 .9 -2.8 2.4',
  7: '5.6|0,-10 h5.6l-3.6 10',
  8: '5.6|2.8,-5.4 c-1.4 0 -2.3 -.9 -2.3 -2.3s.9 -2.3 2.3 -2.3s2.3 .9 2.3 2.3s-.9 2.3 -2.3 2.3c-1.7 0 -2.8 1.1 -2.8 2.7s1.1 2.7 2.8 2.7s2.8 -1.1 2.8 -2.7s-1.1 -2.7 -2.8 -2.7z',
  9: '5.6|.7,-1 c.5 .7 1.2 1 2 1c1.9 0 2.9 -2.4 2.9 -5.9c0 -2.6 -1 -4.1 -2.8 -4.1c-1.6 0 -2.8 1.2 -2.8 3s1.1 3 2.7 3c1.3 0 2.4 -.9 2.8 -2.4',
  '.': '0|0,-.1 v.1',
  ',': '1|.8,-.3 l-.8 2.2',
  ':': '0|0,-5.5 v.1|0,-.1 v.1',
  ';': '1|.8,-5.5 v.1|.8,-.3 l-.8 2.2',
  '!': '0|0,-10 v6.8|0,-.1 v.1',
  '?': '4.8|0,-8 c.3 -1.3 1.2 -2 2.4 -2c1.4 0 2.4 .9 2.4 2.3c0 2 -2.3 2.2 -2.3 4.6|2.5,-.1 v.1',
  "'": '0|0,-10 v2.6',
  '’': '1|.8,-10 l-.6 2.8',
  '"': '1.8|0,-10 v2.6|1.8,-10 v2.6',
  '(': '2|2,-11 c-2.7 3.6 -2.7 9.4 0 13',
  ')': '2|0,-11 c2.7 3.6 2.7 9.4 0 13',
  '[': '2|2,-11 h-2v13h2',
  ']': '2|0,-11 h2v13h-2',
  '{': '3|3,-11 c-2.6 0 -.6 6.5 -3 6.5c2.4 0 .4 6.5 3 6.5',
  '}': '3|0,-11 c2.6 0 .6 6.5 3 6.5c-2.4 0 -.4 6.5 -3 6.5',
  '|': '0|0,-11 v13',
  '-': '3.4|0,-4 h3.4',
  '–': '5|0,-4 h5',
  '—': '8|0,-4 h8',
  '+': '5.4|0,-4.2 h5.4|2.7,-6.9 v5.4',
  '=': '5.4|0,-5.6 h5.4|0,-2.8 h5.4',
  '<': '5|5,-7.4 l-5 3.2l5 3.2',
  '>': '5|0,-7.4 l5 3.2l-5 3.2',
  '~': '5.4|0,-3.8 c.9 -2.4 2.3 -1 2.8 -.4s1.9 1.8 2.7 -.5',
  '/': '4|0,1 l4 -12',
  '\\': '4|0,-11 l4 12',
  _: '5|0,1.6 h5',
  '*': '4.4|2.2,-10 v5|0,-8.8 l4.4 2.6|4.4,-8.8 l-4.4 2.6',
  '^': '4.4|0,-7.4 l2.2 -2.6l2.2 2.6',
  '`': '1.4|0,-10 l1.4 1.8',
  '#': '6|2,-9.4 l-1.2 9|5.2,-9.4 l-1.2 9|.2,-6.6 h5.8|0,-3.2 h5.8',
  '%': '7.4|6.6,-10 l-5.8 10|1.5,-10 c1 0 1.6 .9 1.6 2.2s-.6 2.2 -1.6 2.2s-1.5 -.9 -1.5 -2.2s.5 -2.2 1.5 -2.2z|5.9,-4.4 c1 0 1.6 .9 1.6 2.2s-.6 2.2 -1.6 2.2s-1.5 -.9 -1.5 -2.2s.5 -2.2 1.5 -2.2z',
  '&': '7|6.8,0 l-5.2 -6c-.8 -.9 -1 -1.5 -1 -2.1c0 -1.1 .8 -1.9 2 -1.9s2 .8 2 1.9c0 2.6 -4.6 2.6 -4.6 5.6c0 1.5 1.1 2.5 2.7 2.5c2.2 0 3.7 -1.6 3.9 -4.6',
  $: '6.4|6.2,-8 c-.6 -.8 -1.7 -1.2 -3 -1.2c-1.7 0 -2.9 .8 -2.9 2.1c0 2.9 6.2 1.2 6.2 4.4c0 1.4 -1.3 2.1 -3.2 2.1c-1.5 0 -2.7 -.5 -3.3 -1.5|3.2,-10.6 v11.4',
  '@': '9|6.3,-4.6 c0 1.4 -.8 2.4 -1.9 2.4s-1.9 -1 -1.9 -2.4s.8 -2.4 1.9 -2.4s1.9 1 1.9 2.4c0 1.6 .5 2.2 1.3 2.2c1 0 1.4 -1.2 1.4 -2.8c0 -2.8 -1.9 -4.7 -4.5 -4.7c-2.7 0 -4.5 2.1 -4.5 5.2s1.8 5.2 4.5 5.2c1.2 0 2.1 -.3 2.9 -.8',
  '·': '0|0,-4.2 v.1',
  '×': '4.4|0,-6.4 l4.4 4.4|4.4,-6.4 l-4.4 4.4',
  '…': '5|0,-.1 v.1|2.5,-.1 v.1|5,-.1 v.1',
};

const GLYPHS = new Map(
  Object.entries(SOURCE).map(([character, source]): [string, Glyph] => {
    const [width, ...strokes] = source.split('|');
    return [
      character,
      {
        width: Number(width),
        strokes: strokes.map((stroke) => {
          const [start, rest] = stroke.split(/ (.*)/);
          const [x, y] = start.split(',').map(Number);
          return { x, y, rest };
        }),
      },
    ];
  }),
);

/** The glyph of a character; null when the font has none. */
const glyphOf = (character: string): Glyph | null => GLYPHS.get(character) ?? null;
