/**
 * An SVG of `renderSvg` as a PNG.
 * @param width px; the height follows
 * @throws when the SVG is not one that resvg can read
 */
export async function renderPng(svg: string, width: number): Promise<Uint8Array> {
  // native and slow to load: only who asks for a PNG pays for it
  const { Resvg } = await import('@resvg/resvg-js');
  // fonts are looked for only where our own strokes don't suffice: it takes long, and they differ between machines
  const font = { loadSystemFonts: svg.includes('<text ') };
  return new Resvg(svg, { font, fitTo: { mode: 'width', value: width } }).render().asPng();
}
