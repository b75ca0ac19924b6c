// Draws docs/themes.svg: a level of each theme, generated from a seed. After `npm run build`: node docs/draw-themes.mjs
import { writeFileSync } from 'node:fs';
import { compile, simulate } from '../dist/engine/index.js';
import { renderSvg } from '../dist/picture/index.js';
import { resolveLevel } from '../dist/schema/index.js';
import { createGenerator } from '../dist/solver/index.js';

const LEVELS = [
  { theme: 'orbits', seed: 3, difficulty: 2.4 },
  { theme: 'corridors', seed: 2, difficulty: 2 },
  { theme: 'slings', seed: 3, difficulty: 2.4 },
  { theme: 'lures', seed: 5, difficulty: 'easy' },
  { theme: 'fields', seed: 5, difficulty: 3 },
];

// px of the whole picture, between levels, below them for the name, and of a level before all are scaled to the same height.
const WIDTH = 1280;
const GAP = 12;
const LABEL = 34;
const DRAWN = 480;

const drawn = LEVELS.map((options) => {
  const generator = createGenerator(options);
  while (generator.result === null) generator.advance(10_000_000);
  const level = resolveLevel(generator.result.level);
  const run = simulate(compile(level), generator.result.holds);
  const svg = renderSvg(level, { run, width: DRAWN, words: false });
  const [, width, height] = /viewBox="0 0 (\S+) (\S+)"/.exec(svg);
  console.log(options.theme, generator.result.level.name, svg.length);
  return { theme: options.theme, svg, ratio: width / height };
});

// The widest of the two rows fills the picture.
const rows = [drawn.slice(0, 3), drawn.slice(3)];
const ratioOf = (row) => row.reduce((sum, { ratio }) => sum + ratio, 0);
const height = Math.floor(Math.min(...rows.map((row) => (WIDTH - GAP * (row.length + 1)) / ratioOf(row))));
let top = GAP;
const cells = rows.map((row) => {
  let left = (WIDTH - height * ratioOf(row) - GAP * (row.length - 1)) / 2;
  const inRow = row.map(({ theme, svg, ratio }) => {
    const [x, width] = [left, height * ratio];
    left += width + GAP;
    const inner = svg
      .slice(svg.indexOf('<svg'))
      // ids of gradients and clips are those of one picture
      .replaceAll(/(id="|url\(#|href="#)/g, `$1${theme}-`)
      .replace(
        /^<svg[^>]*?(viewBox="[^"]*")[^>]*>/,
        `<svg x="${x.toFixed(1)}" y="${top}" width="${width.toFixed(1)}" height="${height}" $1>`,
      );
    const middle = (x + width / 2).toFixed(1);
    return `${inner.trim()}<text x="${middle}" y="${top + height + 23}" text-anchor="middle" font-family="system-ui,sans-serif" font-size="18" fill="#e4eaf1">${theme}</text>`;
  });
  top += height + LABEL;
  return inRow.join('\n');
});
const names = LEVELS.map(({ theme }) => theme).join(', ');
writeFileSync(
  new URL('themes.svg', import.meta.url),
  `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${top}" viewBox="0 0 ${WIDTH} ${top}" role="img" aria-label="A generated level of each theme: ${names}"><rect width="${WIDTH}" height="${top}" fill="#0b1018"/>${cells.join('\n')}</svg>\n`,
);
