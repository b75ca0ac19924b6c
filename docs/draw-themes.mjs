// Draws docs/themes.svg: a level of each theme, generated from a seed. After `npm run build`: node docs/draw-themes.mjs
import { writeFileSync } from 'node:fs';
import { compile, simulate } from '../dist/engine/index.js';
import { renderSvg } from '../dist/picture/index.js';
import { resolveLevel } from '../dist/schema/index.js';
import { createGenerator } from '../dist/solver/index.js';

const LEVELS = [
  { theme: 'orbits', seed: 1, difficulty: 1.7 },
  { theme: 'corridors', seed: 2, difficulty: 2 },
  { theme: 'slings', seed: 3, difficulty: 2.4 },
  { theme: 'lures', seed: 1, difficulty: 'easy' },
  { theme: 'fields', seed: 5, difficulty: 3 },
];

const WIDTH = 470;
const HEIGHT = 500;
const LABEL = 30;

const cells = LEVELS.map((options, i) => {
  const generator = createGenerator(options);
  while (generator.result === null) generator.advance(10_000_000);
  const level = resolveLevel(generator.result.level);
  const svg = renderSvg(level, { run: simulate(compile(level), generator.result.holds), width: WIDTH });
  // each level keeps its proportions within a cell
  const [x, y] = [(i % 3) * (WIDTH + 10) + (i < 3 ? 0 : WIDTH / 2), Math.floor(i / 3) * (HEIGHT + LABEL + 10)];
  const inner = svg
    .slice(svg.indexOf('<svg'))
    // ids of gradients and clips are those of one picture
    .replaceAll(/(id="|url\(#|href="#)/g, `$1${options.theme}-`)
    .replace(/^<svg[^>]*>/, (tag) =>
      tag
        .replace(/ (width|height|x|y)="[^"]*"/g, '')
        .replace('<svg', `<svg x="${x}" y="${y + LABEL}" width="${WIDTH}" height="${HEIGHT}"`),
    );
  console.log(options.theme, generator.result.level.name, svg.length);
  return `<text x="${x + WIDTH / 2}" y="${y + 21}" text-anchor="middle" font-family="system-ui,sans-serif" font-size="18" fill="#e4eaf1">${options.theme}</text>${inner}`;
});
const [width, height] = [3 * WIDTH + 20, 2 * (HEIGHT + LABEL) + 10];
writeFileSync(
  new URL('themes.svg', import.meta.url),
  `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" aria-label="A generated level of each theme: orbits, corridors, slings, lures, fields"><rect width="${width}" height="${height}" fill="#0b1018"/>${cells.join('\n')}</svg>\n`,
);
