import type { Settings } from '../core/settings/index.ts';

/** What draws the canvas: WebGL on the graphics card, or the browser's 2D canvas. */
export type RendererName = 'webgl' | 'canvas';

/** The renderer and why it was chosen; chosen once per page. */
export interface ChosenRenderer {
  readonly name: RendererName;
  /** The setting that determined it; null: the page's address, which overrides the setting. */
  readonly setting: Settings['renderer'] | null;
  /** Why it is not the requested one, for the user; null if it is. */
  readonly complaint: string | null;
}

/** Names by which browsers report software rendering. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/** The WebGL that is required: on a graphics card, or any. */
type WebglNeed = 'card' | 'any';

/** Whether the browser offers such a WebGL. If a graphics card is required, the slow setup of software rendering is avoided. */
export function offersWebgl(document: Document, need: WebglNeed): boolean {
  const context = document.createElement('canvas').getContext('webgl', { failIfMajorPerformanceCaveat: need === 'card' });
  if (context === null) return false;
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(context.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return need === 'any' || !SOFTWARE.test(renderer);
}

/**
 * Chooses the renderer. Without a graphics card, the 2D canvas is many times faster than WebGL in software.
 * @param setting the user's preference
 * @param search the query of the page's address: `?renderer=webgl` or `?renderer=canvas` overrides the setting
 * @param offers called only if it matters
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
    const complaint = `Expected the renderer webgl or canvas in the address of this page, found “${asked}”. The setting is used instead. Correct the address or remove the parameter.`;
    return { name, setting: by, complaint };
  }
  if (wanted === 'canvas') return { name: 'canvas', setting: by, complaint: null };
  if (wanted === 'automatic') return { name: offers('card') ? 'webgl' : 'canvas', setting: by, complaint: null };
  if (offers('any')) return { name: 'webgl', setting: by, complaint: null };
  const where = by === null ? 'the address of this page' : 'the setting “Renderer”';
  const complaint = `WebGL is requested by ${where}, but this browser does not offer it. A plain canvas is used instead. Turn on the browser’s hardware acceleration, or choose another renderer.`;
  return { name: 'canvas', setting: by, complaint };
}
