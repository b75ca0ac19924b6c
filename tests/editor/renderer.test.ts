import { describe, expect, it } from 'vitest';
import { chooseRenderer } from '../../editor/canvas/renderer.ts';
import type { Settings } from '../../editor/core/settings/index.ts';

const choose = (setting: Settings['renderer'], search: string, offer: 'none' | 'software' | 'card') =>
  chooseRenderer(setting, search, (need) => (need === 'card' ? offer === 'card' : offer !== 'none'));

describe('the renderer of the canvas', () => {
  it('is WebGL with a graphics card, else a plain canvas, by default', () => {
    expect(choose('automatic', '', 'card')).toEqual({ name: 'webgl', setting: 'automatic', complaint: null });
    for (const offer of ['software', 'none'] as const) {
      expect(choose('automatic', '', offer)).toEqual({ name: 'canvas', setting: 'automatic', complaint: null });
    }
  });

  it('is that of the setting, but the address takes precedence', () => {
    for (const offer of ['card', 'software'] as const) {
      expect(choose('webgl', '', offer)).toEqual({ name: 'webgl', setting: 'webgl', complaint: null });
      expect(choose('canvas', '', offer)).toEqual({ name: 'canvas', setting: 'canvas', complaint: null });
      expect(choose('canvas', '?a=b&renderer=webgl', offer)).toEqual({ name: 'webgl', setting: null, complaint: null });
      expect(choose('webgl', '?renderer=canvas', offer)).toEqual({ name: 'canvas', setting: null, complaint: null });
    }
  });

  it('is a plain canvas if WebGL is requested but missing, and names the source of the request', () => {
    const bySetting = choose('webgl', '', 'none');
    expect(bySetting).toMatchObject({ name: 'canvas', setting: 'webgl' });
    expect(bySetting.complaint).toContain('the setting “Renderer”');
    const byAddress = choose('automatic', '?renderer=webgl', 'none');
    expect(byAddress).toMatchObject({ name: 'canvas', setting: null });
    expect(byAddress.complaint).toContain('the address of this page');
  });

  it('follows the setting if the address has an unknown value, and reports what was expected and found', () => {
    for (const search of ['?renderer=gpu', '?renderer=', '?renderer=WebGL']) {
      const { complaint, ...chosen } = choose('webgl', search, 'software');
      expect(chosen).toEqual({ name: 'webgl', setting: 'webgl' });
      expect(complaint).toContain(`“${search.slice(10)}”`);
      expect(complaint).toContain('the renderer webgl or canvas');
    }
  });
});
