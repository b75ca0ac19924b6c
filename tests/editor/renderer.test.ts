import { describe, expect, it } from 'vitest';
import { chooseRenderer } from '../../editor/canvas/renderer.ts';
import type { Settings } from '../../editor/settings/index.ts';

const choose = (setting: Settings['renderer'], search: string, offer: 'none' | 'software' | 'card') =>
  chooseRenderer(setting, search, (need) => (need === 'card' ? offer === 'card' : offer !== 'none'));

describe('what draws the canvas', () => {
  it('is a graphics card where there is one, else a plain canvas, while nobody asks for either', () => {
    expect(choose('automatic', '', 'card')).toEqual({ name: 'webgl', setting: 'automatic', complaint: null });
    for (const offer of ['software', 'none'] as const) {
      expect(choose('automatic', '', offer)).toEqual({ name: 'canvas', setting: 'automatic', complaint: null });
    }
  });

  it('is what the setting says, but the address wins', () => {
    for (const offer of ['card', 'software'] as const) {
      expect(choose('webgl', '', offer)).toEqual({ name: 'webgl', setting: 'webgl', complaint: null });
      expect(choose('canvas', '', offer)).toEqual({ name: 'canvas', setting: 'canvas', complaint: null });
      expect(choose('canvas', '?a=b&renderer=webgl', offer)).toEqual({ name: 'webgl', setting: null, complaint: null });
      expect(choose('webgl', '?renderer=canvas', offer)).toEqual({ name: 'canvas', setting: null, complaint: null });
    }
  });

  it('is a plain canvas where WebGL is asked for and there is none, and says who asked', () => {
    const bySetting = choose('webgl', '', 'none');
    expect(bySetting).toMatchObject({ name: 'canvas', setting: 'webgl' });
    expect(bySetting.complaint).toContain('the setting “Renderer”');
    const byAddress = choose('automatic', '?renderer=webgl', 'none');
    expect(byAddress).toMatchObject({ name: 'canvas', setting: null });
    expect(byAddress.complaint).toContain('the address of this page');
  });

  it('follows the setting where the address asks for what is unknown, and says what was expected and found', () => {
    for (const search of ['?renderer=gpu', '?renderer=', '?renderer=WebGL']) {
      const { complaint, ...chosen } = choose('webgl', search, 'software');
      expect(chosen).toEqual({ name: 'webgl', setting: 'webgl' });
      expect(complaint).toContain(`“${search.slice(10)}”`);
      expect(complaint).toContain('the renderer webgl or canvas');
    }
  });
});
