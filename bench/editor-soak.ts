import process from 'node:process';
import { createRandom } from '../solver/index.ts';
import { HAZARDS, playRound, type Round, VICTIMS } from './editor-soak/round.ts';
import { type Victim, World } from './editor-soak/world.ts';
import { atLeast, atMost, define, number, sum } from './harness/index.ts';

// Everything is nudged to the right, one px per key, while page, browser and server are killed and other things go wrong. When
// all runs again, everything must be at least where the editor had shown it as saved or had kept it in its journal, and no
// farther than it was moved. Edits from the last two seconds before a kill are examined, too: each one that is missing is
// reported with its age at the kill.

/** Rounds, keys, edits that nothing had acknowledged, and how many of these were there. */
function rowOf(name: string, rounds: readonly Round[]): (string | number)[] {
  const all = (value: (round: Round) => number) => sum(rounds.map(value));
  return [
    name,
    rounds.length,
    all(({ pressed }) => pressed),
    all(({ most, least }) => most - least),
    all(({ found, least }) => found - least),
  ];
}

/** Ages of edits at the kill, ms: the bounds of the rows in the report. */
const AGES = [0, 20, 50, 100, 200, 500, 1000, 2000, Number.POSITIVE_INFINITY];
/** Edits as old as that may not be lost, ms. */
const LATE = 2000;

/** Says how many edits of each age were lost. */
function agesInWords(edits: Round['edits']): string {
  const lines = AGES.slice(0, -1).map((from, i) => {
    const of = edits.filter(({ age }) => age >= from && age < AGES[i + 1]);
    const to = AGES[i + 1] === Number.POSITIVE_INFINITY ? 'and more' : `to ${AGES[i + 1]}`;
    return `${`${from} ${to} ms before`.padEnd(26)} ${String(of.length).padStart(5)} edits, ${of.filter(({ isLost }) => isLost).length} lost`;
  });
  const late = edits.filter(({ age }) => age < LATE);
  const lost = late.filter(({ isLost }) => isLost).length;
  const oldest = Math.max(0, ...edits.filter(({ isLost }) => isLost).map(({ age }) => age));
  return [
    ...lines,
    `in the 2 s before a kill   ${String(late.length).padStart(5)} edits, ${lost} lost: ${((100 * lost) / Math.max(1, late.length)).toFixed(1)} %; ` +
      `of all that were lost the oldest was done ${oldest.toFixed(0)} ms before`,
  ].join('\n');
}

export const bench = define({
  what: 'page, browser and server killed while somebody edits; about 20 minutes (needs Chromium)',
  options: {
    kills: number(300, 'kills'),
    seconds: number(3600, 'time'),
    seed: number(1, 'the seed'),
  },
  claims: {
    failures: atMost(0, 'rounds in which something was not as promised'),
    lost: atMost(0, 'edits lost that were older than 2 s when something was killed'),
    rounds: atLeast(1, 'rounds'),
  },
  async run({ kills: wanted, seconds, seed }) {
    const until = Date.now() + 1000 * seconds;
    const random = createRandom(seed);
    const rounds: Round[] = [];
    const failures: string[] = [];
    const kills: Record<Victim, number> = { page: 0, browser: 0, server: 0 };
    const total = (of: Record<Victim, number>) => of.page + of.browser + of.server;
    let world: World | null = null;
    const leave = async () => {
      if (world === null) return;
      for (const victim of Object.keys(kills) as Victim[]) kills[victim] += world.kills[victim];
      await world.end();
      world = null;
    };
    let isAsked = false;
    for (const signal of ['SIGINT', 'SIGTERM'] as const) {
      process.once(signal, () => {
        isAsked = true;
      });
    }
    while (total(kills) + (world === null ? 0 : total(world.kills)) < wanted && Date.now() < until && !isAsked) {
      const number = rounds.length + 1;
      const state = random.fork();
      try {
        if (world === null) {
          world = new World();
          await world.mend('close');
          await world.settle();
        }
        const round: Round = await playRound(world, state);
        rounds.push(round);
        for (const failure of round.failures) failures.push(`round ${number}, ${round.victims}, ${round.hazard}: ${failure}`);
        if (process.stderr.isTTY || round.failures.length > 0) {
          console.error(`${number}: ${round.victims}, ${round.hazard}: ${round.failures.join('; ') || 'ok'}`);
        }
      } catch (error) {
        const failure = `round ${number}: ${error instanceof Error ? error.message : error}`;
        console.error(failure);
        failures.push(failure);
        await leave();
      }
    }
    await leave();
    const edits = rounds.flatMap((round) => round.edits);
    return {
      title: `Seed ${seed}: ${kills.page} pages, ${kills.browser} browsers and ${kills.server} servers killed in ${rounds.length} rounds`,
      columns: ['', 'rounds', 'keys', 'edits that nothing had acknowledged', 'of these there'],
      rows: [
        ...VICTIMS.map((name) =>
          rowOf(
            name,
            rounds.filter(({ victims }) => victims === name),
          ),
        ),
        ...HAZARDS.map((name) =>
          rowOf(
            name,
            rounds.filter(({ hazard }) => hazard === name),
          ),
        ),
      ],
      measured: {
        failures: failures.length,
        lost: edits.filter(({ age, isLost }) => isLost && age >= LATE).length,
        rounds: rounds.length,
      },
      notes: [agesInWords(edits), ...failures.map((failure) => `FAILED  ${failure}`)],
    };
  },
});
