import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { loadPngRenderer } from '../../cli/commands/render/views.ts';
import { renderSvg } from '../../picture/index.ts';
import { DROP, level } from './scenes.ts';

const renderPng = await loadPngRenderer();

const HOSTILE = [
  '</title><script>alert(1)</script>',
  '" onload="alert(1)',
  "'><img src=x>",
  '&amp; &lt;',
  ']]>',
  '\u0000\u0008\u001f\ufffe\uffff',
  '\ud800 alone',
  '日本 é 🚀',
  '‮reversed',
];

describe('texts of a level can’t break out of the picture', () => {
  test.each(HOSTILE)('%j', (text) => {
    const svg = renderSvg(level({ ...DROP, name: text, description: text }));
    expect(svg).not.toMatch(/<script|<img| onload="/);
    // resvg refuses what is not well-formed.
    expect(renderPng(svg, 60).length).toBeGreaterThan(100);
  });

  test('whatever the name, the document is well-formed', () => {
    const any = fc.string({ unit: 'binary', minLength: 1, maxLength: 120 });
    fc.assert(
      fc.property(any, (name) => {
        renderPng(renderSvg(level({ ...DROP, name })), 20);
      }),
      { numRuns: 15 },
    );
  });

  test('texts in the stroke font need no font, all others are left to the viewer', () => {
    expect(renderSvg(level({ ...DROP, name: 'Drop: 100% & "more" (1/2)?' }))).not.toContain('<text ');
    expect(renderSvg(level({ ...DROP, name: 'Première' }))).toContain('>Première</text>');
  });

  test('a long name is cut to fit, and complete in the title', () => {
    const name = 'W'.repeat(120);
    expect(renderSvg(level({ ...DROP, name }))).toContain(`<title>${name}</title>`);
    const drawn = (n: string) => renderSvg(level({ ...DROP, name: n })).split('M').length;
    expect(drawn(name)).toBe(drawn(`${name}W`));
  });

  test('a title replaces the name', () => {
    expect(renderSvg(level(DROP), { title: 'run 2 of 3' })).toContain('<title>run 2 of 3</title>');
  });
});
