import { type AccuracyName, compile } from '../engine/index.ts';
import { createPlayer, createVerifier, encodePlay, type PlayVerifier, playOf } from '../game/index.ts';
import { minuteOfPlay } from '../tests/scenes/minute-plays.ts';
import { ACCURACY_NAMES, askedLevels, atLeast, consume, define, LEVELS, mean, type NamedLevel, spread } from './harness/index.ts';

const PLAYS_A_LEVEL = 4;
const ROUNDS = 15;
/** Shortest time of a round, ms of processor time. */
const SAMPLE = 150;

interface Recorded {
  readonly verifier: PlayVerifier;
  readonly bytes: Uint8Array;
  readonly edges: number;
}

/** Plays of a minute on every level. Where too few are found, it is said in `left`. */
function recorded(levels: readonly NamedLevel[], accuracy: AccuracyName, left: string[]): Recorded[] {
  return levels.flatMap(({ name, level }, i) => {
    const scene = compile(level, accuracy);
    const verifier = createVerifier(level, { accuracy: 'any' });
    const plays = Array.from({ length: PLAYS_A_LEVEL }, (_, k) => minuteOfPlay(scene, 1 + i * PLAYS_A_LEVEL + k)).flatMap(
      (replay) => {
        if (replay === null) return [];
        const player = createPlayer(scene, { replay, maxTime: 60 });
        while (player.ending === null) player.advance(100);
        if (player.tick !== 3600) throw new Error(`${name}: expected a play of 3600 ticks, found ${player.tick}`);
        return [{ verifier, bytes: encodePlay(playOf(player)), edges: 2 * player.holds.length }];
      },
    );
    if (plays.length < PLAYS_A_LEVEL) left.push(`${name} at ${accuracy}: ${plays.length}`);
    return plays;
  });
}

function verifyAll(plays: readonly Recorded[]): void {
  for (const { verifier, bytes } of plays) {
    const { verdict, message, work } = verifier.verify(bytes);
    if (verdict !== 'ok') throw new Error(`expected ok, found ${verdict}: ${message}`);
    consume(work);
  }
}

/** Plays a second of processor time, in every round. */
function measure(plays: readonly Recorded[]): number[] {
  const seconds = (times: number): number => {
    const before = process.cpuUsage();
    for (let i = 0; i < times; i++) verifyAll(plays);
    return process.cpuUsage(before).user / 1e6;
  };
  const first = seconds(3) / 3;
  const times = Math.max(1, Math.round(SAMPLE / 1000 / first));
  seconds(times);
  return Array.from({ length: ROUNDS }, () => (times * plays.length) / seconds(times));
}

export const bench = define({
  what: 'plays of a minute that verifyPlay repeats in a second of one core, at every accuracy',
  options: LEVELS,
  claims: { precise: atLeast(2000, 'plays of a minute a second at precise') },
  run(asked) {
    const levels = askedLevels(asked);
    const left: string[] = [];
    const rows = ACCURACY_NAMES.map((accuracy) => {
      const plays = recorded(levels, accuracy, left);
      const { median, q1, q3 } = spread(measure(plays));
      const [edges, bytes] = [mean(plays.map((p) => p.edges)), mean(plays.map((p) => p.bytes.length))];
      return [accuracy, plays.length, median, q1, q3, edges, bytes] as const;
    });
    return {
      title: `Plays of a minute that verifyPlay repeats in a second of one core, on ${levels.length} levels`,
      columns: ['accuracy', 'plays', 'a second: median', 'quartile', 'quartile', 'edges', 'bytes'],
      rows,
      measured: { precise: rows.find(([accuracy]) => accuracy === 'precise')![2] },
      notes: [
        `${PLAYS_A_LEVEL} plays of 3600 ticks on each level as it is, by a random walk of presses and releases that goes back where the play would end.`,
        'User time of the processor; a level is compiled once for all its plays.',
        ...(left.length > 0 ? [`No play of a minute was found for some: ${left.join(', ')}`] : []),
      ],
    };
  },
});
