import { expect, test } from 'vitest';
import { loadPngRenderer } from '../../cli/commands/render/views.ts';
import { Failure } from '../../cli/terminal/messages.ts';
import { renderSvg } from '../../picture/index.ts';
import { FULL, level, play } from './scenes.ts';

const renderPng = await loadPngRenderer();

/** Width and height from a PNG's header. */
const sizeOf = (png: Uint8Array): [number, number] => {
  const view = new DataView(png.buffer, png.byteOffset);
  return [view.getUint32(16), view.getUint32(20)];
};

test.each([64, 300, 1001])('a PNG is %i px wide, and as high as the SVG requires', (width) => {
  const svg = renderSvg(level(FULL), { run: play(FULL, [[10, 110]]) });
  const [, boxWidth, boxHeight] = /viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(svg) ?? [];
  const png = renderPng(svg, width);
  expect([...png.slice(0, 8)]).toEqual([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  expect(sizeOf(png)[0]).toBe(width);
  expect(Math.abs(sizeOf(png)[1] - (width * Number(boxHeight)) / Number(boxWidth))).toBeLessThanOrEqual(1);
});

test('the same SVG gives the same bytes', () => {
  const svg = renderSvg(level(FULL));
  expect(Buffer.from(renderPng(svg, 200)).equals(renderPng(svg, 200))).toBe(true);
});

test('anything but an SVG is refused', () => {
  expect(() => renderPng('<svg', 100)).toThrow();
});

test.each([
  ['the package', 'ERR_MODULE_NOT_FOUND', /which is not installed\n/],
  ['its part for this platform', 'MODULE_NOT_FOUND', /which is not installed\n/],
  ['a library of the system', 'ERR_DLOPEN_FAILED', /which is not loaded: libc is too old\n/],
])('without %s, the message names the package and how to install it', async (_what, code, words) => {
  const load = () => Promise.reject(Object.assign(new Error('libc is too old\nand more'), { code }));
  const failed = await loadPngRenderer(load).catch((error: unknown) => error);
  expect(failed).toBeInstanceOf(Failure);
  expect(String(failed)).toMatch(words);
  expect(String(failed)).toContain('npm install --save-dev @resvg/resvg-js');
});
