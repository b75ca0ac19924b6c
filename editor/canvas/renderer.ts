import type { Settings } from '../settings/index.ts';

/** What draws the canvas: the graphics card, or the browser's own canvas. */
export type RendererName = 'webgl' | 'canvas';

/** What draws the canvas, and why. It is chosen once a page. */
export interface ChosenRenderer {
  readonly name: RendererName;
  /** The setting that it was chosen by; null: the page's address, which wins. */
  readonly setting: Settings['renderer'] | null;
  /** Why it is not what was asked for, for the person; null where it is. */
  readonly complaint: string | null;
}

/** Names by which a browser says that the processor stands in for a graphics card. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/** The least WebGL that would do: one that a graphics card draws, or any. */
export type WebglNeed = 'card' | 'any';

/** Whether the browser offers such a WebGL. For a card alone the slow set-up of one in software is not waited for. */
export function offersWebgl(document: Document, need: WebglNeed): boolean {
  const context = document.createElement('canvas').getContext('webgl', { failIfMajorPerformanceCaveat: need === 'card' });
  if (context === null) return false;
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(context.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return need === 'any' || !SOFTWARE.test(renderer);
}

/**
 * Where a processor would have to stand in for a graphics card, a plain canvas is many times faster.
 * @param setting what the person prefers
 * @param search the part of the page's address from `?` on: `?renderer=webgl` or `?renderer=canvas` wins over the setting
 * @param offers asked where it matters
 */
export function chooseRenderer(
  setting: Settings['renderer'],
  search: string,
  offers: (need: WebglNeed) => boolean,
): ChosenRenderer {
  const asked = new URLSearchParams(search).get('renderer');
  const isKnown = asked === null || asked === 'webgl' || asked === 'canvas';
  const by = asked !== null && isKnown ? null : setting;
  const wanted = asked !== null && isKnown ? asked : setting;
  if (!isKnown) {
    const { name } = chooseRenderer(setting, '', offers);
    const complaint = `The address of this page asks for the renderer “${asked}”: expected webgl or canvas. The setting is followed instead; change the address, or leave it out there.`;
    return { name, setting: by, complaint };
  }
  if (wanted === 'canvas') return { name: 'canvas', setting: by, complaint: null };
  if (wanted === 'automatic') return { name: offers('card') ? 'webgl' : 'canvas', setting: by, complaint: null };
  if (offers('any')) return { name: 'webgl', setting: by, complaint: null };
  const where = by === null ? 'the address of this page' : 'the setting “Renderer”';
  const complaint = `WebGL is asked for by ${where}, and this browser offers none: a plain canvas is drawn on. Turn on the browser’s hardware acceleration, or choose another renderer.`;
  return { name: 'canvas', setting: by, complaint };
}
