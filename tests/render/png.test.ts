import { expect, test } from 'vitest';
import { renderPng } from '../../cli/png.ts';
import { renderSvg } from '../../picture/index.ts';
import { FULL, level, play } from './scenes.ts';

/** Width and height from a PNG's header. */
const sizeOf = (png: Uint8Array): [number, number] => {
  const view = new DataView(png.buffer, png.byteOffset);
  return [view.getUint32(16), view.getUint32(20)];
};

test.each([64, 300, 1001])('a PNG is %i px wide, and as high as the SVG requires', async (width) => {
  const svg = renderSvg(level(FULL), { run: play(FULL, [[10, 110]]) });
  const [, boxWidth, boxHeight] = /viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(svg) ?? [];
  const png = await renderPng(svg, width);
  expect([...png.slice(0, 8)]).toEqual([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  expect(sizeOf(png)[0]).toBe(width);
  expect(Math.abs(sizeOf(png)[1] - (width * Number(boxHeight)) / Number(boxWidth))).toBeLessThanOrEqual(1);
});

test('the same SVG gives the same bytes', async () => {
  const svg = renderSvg(level(FULL));
  expect(Buffer.from(await renderPng(svg, 200)).equals(await renderPng(svg, 200))).toBe(true);
});

test('anything but an SVG is refused', async () => {
  await expect(renderPng('<svg', 100)).rejects.toThrow();
});
