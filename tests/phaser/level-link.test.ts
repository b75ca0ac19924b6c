import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { levelFragment, levelTextOf } from '../../phaser/links/index.ts';

describe('a level in a link', () => {
  it('comes back as it went, among other parts of the fragment', async () => {
    await fc.assert(
      fc.asyncProperty(fc.string({ unit: 'grapheme', maxLength: 400 }), fc.boolean(), async (text, isFirst) => {
        const fragment = await levelFragment(text);
        expect(fragment).toMatch(/^level=[\w-]*$/);
        const among = isFirst ? `#${fragment}&play=abc` : `play=abc&${fragment}`;
        expect(await levelTextOf(among)).toEqual({ ok: true, text });
      }),
      { numRuns: 50 },
    );
  });

  it('is the same as in links that were made before', async () => {
    expect(await levelTextOf('#level=q1YqSy0qzszPU7IyrAUA')).toEqual({ ok: true, text: '{"version":1}' });
  });

  it('is refused when it is damaged, cut off or unpacks to more than a level', async () => {
    const whole = await levelFragment('{"version":1,"name":"A level with some text in it"}');
    const largest = await levelFragment(' '.repeat(1_000_000));
    expect(await levelTextOf(largest)).toMatchObject({ ok: true });
    const bomb = await levelFragment(' '.repeat(1_000_001));
    expect(bomb.length).toBeLessThan(2000);
    for (const fragment of [bomb, whole.slice(0, -6), 'level=', 'level=%%%', 'level=AAAA', `${whole}!`])
      expect(await levelTextOf(fragment), fragment).toEqual({
        ok: false,
        message: 'the level in this link is damaged: the link was cut off or changed',
      });
    expect(await levelTextOf('#play=abc')).toBeNull();
    expect(await levelTextOf('')).toBeNull();
  });
});
