/**
 * Converts an SVG of `renderSvg` to a PNG.
 * @param width px; the height keeps the aspect ratio
 * @throws if resvg can't read the SVG
 */
export async function renderPng(svg: string, width: number): Promise<Uint8Array> {
  // a native module that is slow to load: imported only for PNGs
  const { Resvg } = await import('@resvg/resvg-js');
  // system fonts are loaded only if the built-in strokes don't suffice: that takes long, and fonts differ between machines
  const font = { loadSystemFonts: svg.includes('<text ') };
  return new Resvg(svg, { font, fitTo: { mode: 'width', value: width } }).render().asPng();
}
