import { changesInWords, diffLevels } from '../review/index.ts';
import { KINDS, type LevelFile, LISTED_KINDS, listOf, withIds } from '../schema/index.ts';
import { seeded } from '../tests/scenes/index.ts';
import { atMost, type Contestant, compare, define, timeCells } from './harness/index.ts';

const OBJECTS = 1000;
const RUNS = 5;
const HOLDS = 40;

type Json = Record<string, unknown>;

/** A level of 1,000 objects of all kinds at random places. */
function crowdedLevel(): LevelFile {
  const random = seeded(1);
  const file: Json = { version: 1, name: 'Crowded', astronaut: { x: 0, y: 0 }, blackHole: { x: 5000, y: 5000 } };
  for (let i = 0; i < OBJECTS; i++) {
    const kind = LISTED_KINDS[i % LISTED_KINDS.length];
    const object: Json = { radius: 16 };
    for (const key of KINDS[kind].places.flat()) object[key] = Math.floor(5000 * random());
    const list = listOf(kind);
    file[list] = [...((file[list] ?? []) as object[]), object];
  }
  file.runs = Array.from({ length: RUNS }, (_, run) => ({
    name: `run ${run}`,
    holds: Array.from({ length: HOLDS }, (_, i) => [20 * i, 20 * i + 8]),
  }));
  return file as unknown as LevelFile;
}

/** The level with every nth object moved, and with other holds. */
function edited(level: LevelFile, every: number): LevelFile {
  const after = structuredClone(level) as unknown as Json;
  for (const list of LISTED_KINDS.map(listOf)) {
    for (const [i, object] of (after[list] as { x: number; y: number }[]).entries()) {
      if (i % every !== 0) continue;
      object.x += 1 + (i % 17);
      object.y -= i % 5;
    }
  }
  for (const run of after.runs as { holds: [number, number][] }[]) {
    run.holds = run.holds.filter((_, i) => i !== 7).map(([press, release]) => [press + 1, release]);
  }
  return after as unknown as LevelFile;
}

/** Compares two levels, and says in words what changed. */
function contestant(name: string, before: LevelFile, after: LevelFile): Contestant {
  return {
    name,
    run() {
      const changes = diffLevels(before, after);
      return changes.length + changesInWords(changes, after).length;
    },
  };
}

export const bench = define({
  what: 'what changed between two levels of 1,000 objects, in words',
  options: {},
  claims: { time: atMost(100, 'to tell what changed, ms') },
  run() {
    const plain = crowdedLevel();
    const named = withIds(plain);
    const others = withIds({ ...plain, asteroids: [], name: 'Others' });
    const contestants = [
      contestant('every tenth object moved', named, edited(named, 10)),
      contestant('every object moved', named, edited(named, 1)),
      contestant('every object moved, none has an id', plain, edited(plain, 1)),
      contestant('a seventh of the objects removed', named, others),
    ];
    const measured = compare(contestants, { rounds: 15 });
    return {
      title: `Two levels of ${OBJECTS} objects: what changed, in words`,
      columns: ['', 'ms', 'quartiles'],
      rows: contestants.map(({ name }) => timeCells(measured, name)),
      measured: { time: Object.fromEntries(contestants.map(({ name }) => [name, measured.time(name).median])) },
      notes: [`Medians of ${measured.rounds} rounds. Reading the files and playing the runs is not part of it.`],
    };
  },
});
