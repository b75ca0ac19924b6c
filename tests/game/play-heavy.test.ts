import { expect, it } from 'vitest';
import { compile } from '../../engine/index.ts';
import { createPlayer, createVerifier, encodePlay, type Player, playOf } from '../../game/index.ts';
import { isHunt } from '../depth.ts';
import { accuracyNames } from '../engine/accuracies.ts';
import { pack } from '../levels/shipped-pack.ts';
import { seeded } from '../scenes/index.ts';

const TICK = 1000 / 60;

const played = (player: Player): string => Buffer.from(encodePlay(playOf(player))).toString('hex');

it.each(accuracyNames)('snapshot and restore at every tick give the same play on every shipped level at %s', (accuracy) => {
  for (const { slug, level } of pack) {
    const scene = compile(level, accuracy);
    for (const { holds: replay } of isHunt ? level.runs : level.runs.slice(0, 1)) {
      const plain = createPlayer(scene, { replay });
      while (plain.ending === null) plain.advance(100);
      const heavy = createPlayer(scene, { replay });
      while (heavy.ending === null) {
        const before = heavy.snapshot();
        heavy.advance(heavy.tick % 8 === 0 ? 3 * TICK : TICK);
        heavy.restore(before);
        heavy.advance(TICK);
      }
      expect([slug, played(heavy)]).toEqual([slug, played(plain)]);
    }
  }
});

/** How long frames are: as a monitor makes them, unsteady, with stalls, and from a clock that steps back. */
const FRAMES: readonly ((random: () => number) => number)[] = [
  () => TICK,
  () => 1000 / 144,
  () => 1000 / 30,
  (random) => TICK * (0.5 + random()),
  (random) => (random() < 0.05 ? 40 + 400 * random() : TICK + 2 * (random() - 0.5)),
  (random) => (random() < 0.1 ? -3 : 50 * random()),
];

const SEQUENCES = isHunt ? 10_000 : 200;

it(`${SEQUENCES} sequences of unsteady frames, with presses at any time, are plays that verify`, () => {
  const outcomes = new Set<string>();
  const cases = pack.flatMap(({ level }) => {
    const verifier = createVerifier(level, { accuracy: 'any' });
    return accuracyNames.map((accuracy) => ({ verifier, scene: compile(level, accuracy) }));
  });
  for (let seed = 1; seed <= SEQUENCES; seed++) {
    const random = seeded(seed);
    const { verifier, scene } = cases[Math.floor(cases.length * random())];
    const player = createPlayer(scene, { maxTime: 5 + 15 * random() });
    const length = FRAMES[seed % FRAMES.length];
    const pressing = 0.02 + 0.2 * random();
    for (let frame = 0; frame < 600 && player.ending === null; frame++) {
      if (random() < pressing) player.press();
      if (random() < pressing) player.release();
      player.advance(length(random));
    }
    const play = playOf(player);
    outcomes.add(play.claim.outcome);
    const { verdict, message } = verifier.verify(encodePlay(play));
    expect([seed, verdict, message]).toEqual([seed, 'ok', message]);
  }
  expect(outcomes.size).toBeGreaterThanOrEqual(4);
});
