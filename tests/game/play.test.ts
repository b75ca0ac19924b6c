import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile } from '../../engine/index.ts';
import {
  createPlayer,
  decodePlay,
  encodePlay,
  type Play,
  type Player,
  playFromText,
  playOf,
  playToText,
  verifyPlay,
} from '../../game/index.ts';
import type { Hold } from '../../schema/index.ts';
import { accuracyNames, levelsFor } from '../engine/accuracies.ts';
import { arbitraryPlayableLevel } from '../engine/arbitrary-level.ts';
import { pack, shipped } from '../levels/shipped-pack.ts';
import { propertySettings } from '../property-settings.ts';

const { runs: FACTOR } = propertySettings(process.env);

const { level: firewalk } = shipped('firewalk');

function playOut(player: Player, most = Number.POSITIVE_INFINITY): Player {
  while (player.ending === null && player.tick < most) player.advance(1000 / 60);
  return player;
}

/** Holds from the lengths of the times between edges. */
const holds = fc.array(fc.integer({ min: 1, max: 90 }), { maxLength: 40 }).map((lengths): Hold[] => {
  const made: Hold[] = [];
  let tick = -1;
  for (let i = 0; i + 1 < lengths.length; i += 2) {
    made.push([tick + lengths[i], tick + lengths[i] + lengths[i + 1]]);
    tick += lengths[i] + lengths[i + 1];
  }
  return made;
});

describe.each(accuracyNames)('a play at %s', (accuracy) => {
  const level = fc.oneof(levelsFor(accuracy), arbitraryPlayableLevel, fc.constantFrom(...pack.map((entry) => entry.level)));

  it('survives the file and is what it claims, ended, timed out or left at any tick', () => {
    fc.assert(
      fc.property(
        level,
        holds,
        fc.integer({ min: 0, max: 1500 }),
        fc.integer({ min: 1, max: 25 }),
        (of, replay, most, maxTime) => {
          const scene = compile(of, accuracy);
          const play = playOf(playOut(createPlayer(scene, { replay, maxTime }), most));
          const bytes = encodePlay(play);
          expect(decodePlay(bytes)).toEqual({ ok: true, play });
          expect(playFromText(playToText(bytes))).toEqual(bytes);
          const verified = verifyPlay(of, bytes, { accuracy: 'any', maxWork: Number.POSITIVE_INFINITY });
          expect([verified.verdict, verified.message]).toEqual(['ok', verified.message]);
          expect(verified.found).toEqual(play.claim);
        },
      ),
      { numRuns: 40 * FACTOR },
    );
  });

  it('is that of every run of the shipped levels', () => {
    for (const { level: of } of pack) {
      for (const run of of.runs) {
        const play = playOf(playOut(createPlayer(of, { accuracy, replay: run.holds })));
        const verified = verifyPlay(of, encodePlay(play), { accuracy });
        expect(verified).toMatchObject({ verdict: 'ok', found: play.claim, signs: { publishedRun: expect.any(String) } });
      }
    }
  });
});

describe('a play of another accuracy', () => {
  it('of its own can not be said', () => {
    const player = createPlayer(firewalk, {
      accuracy: { name: 'rk4 120 Hz', integrator: 'rk4', rate: 120, tolerance: null, contact: 'swept' },
    });
    expect(() => playOf(player)).toThrow(
      'playOf: expected an accuracy with a name (arcade, fast, standard, precise), found "rk4 120 Hz"',
    );
  });
});

describe('what no play can have is refused by name', () => {
  const play = playOf(playOut(createPlayer(firewalk, { replay: firewalk.runs[0].holds })));
  const { claim } = play;

  it.each<[string, Partial<Play>, string]>([
    ['engine', { engine: 'x' }, 'engine: expected 16 hexadecimal digits, lower case, found x'],
    ['level', { level: play.level.toUpperCase() }, 'level: expected 64 hexadecimal digits'],
    ['accuracy', { accuracy: 'rk4' as 'fast' }, 'accuracy: expected one of arcade, fast, standard, precise, found rk4'],
    ['challenge', { challenge: '' }, 'challenge: expected 32 hexadecimal digits'],
    ['tick', { claim: { ...claim, tick: 216_001 } }, 'claim.tick: expected a whole number from 0 to 216000, found 216001'],
    ['minerals', { claim: { ...claim, minerals: -1 } }, 'claim.minerals: expected a whole number'],
    ['outcome', { claim: { ...claim, outcome: 'won' as 'left' } }, 'claim.outcome: expected one of completed, '],
    ['checkpoints', { checkpoints: [] }, 'checkpoints: expected 1 of them, found 0'],
    ['half a tick', { holds: [[0.5, 3]] }, 'holds: number 1: expected a press at a whole tick from 0 on, found 0.5'],
    ['an empty hold', { holds: [[5, 5]] }, 'holds: number 1: expected a release after tick 5'],
    [
      'holds that touch',
      {
        holds: [
          [1, 5],
          [5, 9],
        ],
      },
      'holds: number 2: expected a press at a whole tick from 6 on, found 5',
    ],
    ['a hold beyond the end', { holds: [[5, 9000]] }, 'holds: number 1: expected a release after tick 5 and up to the end at'],
  ])('%s', (_, change, message) => {
    expect(() => encodePlay({ ...play, ...change })).toThrow(message);
  });
});
