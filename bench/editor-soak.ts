import process from 'node:process';
import { createRandom } from '../solver/index.ts';
import { HAZARDS, playRound, type Round, VICTIMS } from './editor-soak/round.ts';
import { type Victim, World } from './editor-soak/world.ts';
import { optionValue } from './harness.ts';

// Everything is nudged to the right, one px per key, while page, browser and server are killed and other things go wrong. When
// all runs again, everything must be at least where the editor had shown it as saved or had kept it in its journal, and no
// farther than it was moved. Edits from the last two seconds before a kill are examined, too: each one that is missing is
// reported with its age at the kill.

function report(rounds: readonly Round[]): void {
  const line = (name: string, of: readonly Round[]) => {
    const sum = (value: (round: Round) => number) => of.reduce((total, round) => total + value(round), 0);
    const unacknowledged = sum(({ most, least }) => most - least);
    const kept = sum(({ found, least }) => found - least);
    console.log(
      `${name.padEnd(20)} ${String(of.length).padStart(4)} rounds, ${sum(({ pressed }) => pressed)} keys; of ${unacknowledged} that ` +
        `nothing had acknowledged ${kept} were there`,
    );
  };
  for (const victims of VICTIMS) {
    const of = rounds.filter((round) => round.victims === victims);
    line(victims, of);
  }
  for (const hazard of HAZARDS) {
    const of = rounds.filter((round) => round.hazard === hazard);
    line(hazard, of);
  }
}

/** Ages of edits at the kill, ms: the bounds of the rows in the report. */
const AGES = [0, 20, 50, 100, 200, 500, 1000, 2000, Number.POSITIVE_INFINITY];

/**
 * Reports how many edits of the last two seconds before a kill were lost.
 * @returns the number of older edits that were lost
 */
function reportLastSeconds(rounds: readonly Round[]): number {
  const all = rounds.flatMap(({ edits }) => edits);
  for (const [i, from] of AGES.slice(0, -1).entries()) {
    const of = all.filter(({ age }) => age >= from && age < AGES[i + 1]);
    const to = AGES[i + 1] === Number.POSITIVE_INFINITY ? 'and more' : `to ${AGES[i + 1]}`;
    const lost = of.filter(({ isLost }) => isLost).length;
    console.log(`${`${from} ${to} ms before`.padEnd(26)} ${String(of.length).padStart(5)} edits, ${lost} lost`);
  }
  const late = all.filter(({ age }) => age < 2000);
  const lost = all.filter(({ isLost }) => isLost);
  const lostLate = lost.filter(({ age }) => age < 2000).length;
  const share = late.length === 0 ? 0 : (100 * lostLate) / late.length;
  const oldest = Math.max(0, ...lost.map(({ age }) => age));
  console.log(
    `in the 2 s before a kill   ${String(late.length).padStart(5)} edits, ${lostLate} lost: ${share.toFixed(1)} %; ` +
      `of all that were lost the oldest was done ${oldest.toFixed(0)} ms before`,
  );
  return lost.length - lostLate;
}

async function main(): Promise<void> {
  const wanted = Number(optionValue('--kills') ?? 300);
  const seed = Number(optionValue('--seed') ?? 1);
  const until = Date.now() + 1000 * Number(optionValue('--seconds') ?? 3600);
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
  report(rounds);
  const lostEarlier = reportLastSeconds(rounds);
  if (lostEarlier > 0) failures.push(`${lostEarlier} edits were lost that were older than 2 s when something was killed`);
  for (const failure of failures) console.log(`FAILED  ${failure}`);
  console.log(
    `seed ${seed}: ${kills.page} pages, ${kills.browser} browsers and ${kills.server} servers killed in ${rounds.length} rounds; ` +
      `${failures.length} failures`,
  );
  if (failures.length > 0 || rounds.length === 0) process.exitCode = 1;
}

await main();
