import { Failure } from './io/index.ts';

/** The package that draws PNGs: a native module, which not every installation has. */
const PACKAGE = '@resvg/resvg-js';

/** Draws an SVG as a PNG of a width, px; the height keeps the aspect ratio. Throws if it can't read the SVG. */
export type PngRenderer = (svg: string, width: number) => Uint8Array;

/**
 * Loads what draws PNGs. It is slow to load, so only those who want a PNG call this.
 * @throws {Failure} when the package is not installed, or not for this platform
 */
export async function loadPngRenderer(load = () => import('@resvg/resvg-js')): Promise<PngRenderer> {
  const { Resvg } = await load().catch((error: unknown) => {
    const code = (error as NodeJS.ErrnoException | null)?.code;
    // the package itself is missing, or the part of it for this platform
    const isMissing = code === 'ERR_MODULE_NOT_FOUND' || code === 'MODULE_NOT_FOUND';
    const why = isMissing
      ? 'not installed'
      : `not loaded: ${String(error instanceof Error ? error.message : error).split('\n')[0]}`;
    throw new Failure(
      `a PNG needs the package ${PACKAGE}, which is ${why}
install it: npm install --save-dev ${PACKAGE}, or name a file that ends in .svg: an SVG needs no package`,
    );
  });
  // system fonts are loaded only if the built-in strokes don't suffice: that takes long, and fonts differ between machines
  return (svg, width) => {
    const font = { loadSystemFonts: svg.includes('<text ') };
    return new Resvg(svg, { font, fitTo: { mode: 'width', value: width } }).render().asPng();
  };
}
