import type { Page } from 'playwright-core';

/** The difference of two pictures. */
export interface Difference {
  /** The share of px in which a colour differs by more than the tolerance, 0 to 1; 1 if the sizes differ. */
  readonly share: number;
  /** The mean difference of all colours, 0 to 255. */
  readonly mean: number;
}

/** Differences of a colour up to this are not visible, 0 to 255. */
const TOLERANCE = 12;

/** Compares two PNGs px by px in a page, which can decode them. */
export function compare(page: Page, one: Buffer, other: Buffer): Promise<Difference> {
  return page.evaluate(
    async ([sources, tolerance]) => {
      const [a, b] = await Promise.all(
        sources.map(async (source) => {
          const image = new Image();
          image.src = `data:image/png;base64,${source}`;
          await image.decode();
          const brush = new OffscreenCanvas(image.width, image.height).getContext('2d');
          if (brush === null) throw new Error('no canvas');
          brush.drawImage(image, 0, 0);
          return brush.getImageData(0, 0, image.width, image.height);
        }),
      );
      if (a.width !== b.width || a.height !== b.height) return { share: 1, mean: 255 };
      let sum = 0;
      let others = 0;
      for (let i = 0; i < a.data.length; i += 4) {
        let most = 0;
        for (let k = i; k < i + 3; k++) {
          const difference = Math.abs(a.data[k] - b.data[k]);
          sum += difference;
          most = Math.max(most, difference);
        }
        if (most > tolerance) others++;
      }
      return { share: (4 * others) / a.data.length, mean: sum / (0.75 * a.data.length) };
    },
    [[one.toString('base64'), other.toString('base64')], TOLERANCE] as const,
  );
}
