import type { Page } from 'playwright-core';

/**
 * The number of px in a part of the screen that have about this colour.
 * @param colour `#rrggbb`
 * @param around half of the side of the square, px
 */
export async function countColour(
  page: Page,
  { x, y }: { x: number; y: number },
  around: number,
  colour: string,
): Promise<number> {
  const clip = { x: x - around, y: y - around, width: 2 * around, height: 2 * around };
  const picture = (await page.screenshot({ clip })).toString('base64');
  return page.evaluate(
    async ([source, wanted]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${source}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const brush = canvas.getContext('2d');
      if (brush === null) throw new Error('no canvas');
      brush.drawImage(image, 0, 0);
      const { data } = brush.getImageData(0, 0, image.width, image.height);
      // compares the hue, so that a thin line over a dark background counts as well
      const tint = (r: number, g: number, b: number) => {
        const grey = (r + g + b) / 3;
        return [r - grey, g - grey, b - grey] as const;
      };
      const dot = (a: readonly number[], b: readonly number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      const [red, green, blue] = [1, 3, 5].map((at) => Number.parseInt(wanted.slice(at, at + 2), 16));
      const asked = tint(red, green, blue);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        const found = tint(data[i], data[i + 1], data[i + 2]);
        const along = dot(found, asked);
        if (along > 0.3 * dot(asked, asked) && along > 0.95 * Math.sqrt(dot(found, found) * dot(asked, asked))) count++;
      }
      return count;
    },
    [picture, colour] as const,
  );
}
