import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createPlayReplayer } from '../../check/plays/index.ts';
import { countMinerals } from '../../check/words/index.ts';
import { compile, simulate, termsOf } from '../../engine/index.ts';
import { createPlayer, decodePlay, encodePlay, playOf, verifyPlay } from '../../game/index.ts';
import { resolveLevel } from '../../schema/index.ts';

// `arcade` counts a mineral again in the next frame if another one is touched in the same frame

const holds = [[0, 600] as const];

const levelWith = (minerals: readonly { readonly x: number; readonly y: number }[]) =>
  resolveLevel({
    version: 1,
    name: 'Pair',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 200, y: 0 },
    asteroids: [{ x: 100, y: 0, radius: 16 }],
    minerals: [...minerals],
    runs: [{ name: 'solution', holds: [[0, 600]] }],
  });

function played(level: ReturnType<typeof levelWith>, accuracy: 'arcade' | 'precise') {
  const player = createPlayer(level, { accuracy, replay: holds });
  while (player.ending === null) player.advance(1000);
  return player;
}

describe('minerals that arcade counts twice', () => {
  const pair = levelWith([
    { x: 40, y: 8 },
    { x: 40, y: -8 },
    { x: 60, y: 0 },
  ]);

  it('are one for people, and stay in the play as the game counts them', () => {
    const player = played(pair, 'arcade');
    expect([player.mineralCount, player.collectedCount]).toEqual([4, 3]);
    const bytes = encodePlay(playOf(player));
    const decoded = decodePlay(bytes);
    expect(decoded).toMatchObject({ ok: true, play: { claim: { minerals: 4 } } });
    const { verdict, message, found } = verifyPlay(pair, bytes, { accuracy: 'any' });
    expect({ verdict, message, found }).toEqual({
      verdict: 'ok',
      message: 'completed at tick 243 with 3 minerals',
      found: { tick: 243, minerals: 4, outcome: 'completed' },
    });
  });

  it('are named both ways where a claim is wrong by them', () => {
    const play = playOf(played(pair, 'arcade'));
    const wrong = { ...play, claim: { ...play.claim, minerals: 3 } };
    const words =
      'expected completed at tick 243 with 3 minerals, as the play claims; found completed at tick 243 with 3 minerals, counted as 4';
    expect(verifyPlay(pair, encodePlay(wrong), { accuracy: 'arcade' })).toMatchObject({
      verdict: 'claim-differs',
      message: words,
    });
    expect(createPlayReplayer(pair, termsOf('arcade'), { minerals: 'any' }).replay(wrong, 0)).toMatchObject({ message: words });
  });

  it('are never more than the level has, and as many as a run collects', () => {
    const place = fc.record({ x: fc.integer({ min: -10, max: 150 }), y: fc.integer({ min: -12, max: 12 }) });
    fc.assert(
      fc.property(
        fc.array(place, { maxLength: 5 }),
        fc.constantFrom('arcade' as const, 'precise' as const),
        (places, accuracy) => {
          const level = levelWith(places);
          const player = played(level, accuracy);
          expect(player.collectedCount).toBeLessThanOrEqual(level.minerals.length);
          expect(player.collectedCount).toBe(countMinerals(simulate(compile(level, accuracy), holds)));
          const { verdict, message } = verifyPlay(level, encodePlay(playOf(player)), { accuracy: 'any' });
          expect(verdict).toBe('ok');
          expect(message).toMatch(new RegExp(` with ${player.collectedCount} minerals?$`));
        },
      ),
      { numRuns: 60 },
    );
  });
});
