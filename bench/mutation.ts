// Measures how many small errors in the source the tests of its room detect; see bench/README.md.

import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { seeded } from '../tests/scenes/seeded.ts';
import { define, number, PROJECT, text, words } from './harness/index.ts';
import { allMutants, type PlacedMutant } from './mutation/mutants.ts';
import { type Fate, PLAN, type Plan, type Reach, type Result } from './mutation/plan.ts';
import { filesIn, ROOMS } from './mutation/rooms.ts';

/** A child that has written nothing for this long hangs, ms. */
const HANGS_AFTER = 120_000;

/** Mutants that a child tries before it is replaced by a new one: what it loads for each of them stays in its memory. */
const A_CHILD = 250;

/** Why a mutant that no test detects may stay. It is identified by its file, its line, and the change. */
interface Excuse {
  readonly file: string;
  readonly at: string;
  readonly before: string;
  readonly after: string;
  /** `equivalent`: no call can tell them apart. `slack`: the tests allow a certain error, and the mutant stays within it. */
  readonly kind: 'equivalent' | 'slack';
  readonly reason: string;
}

const ROOT = `${PROJECT}/`;
const EXCUSES = join(ROOT, 'bench/mutation/survivors.json');

/** Running groups of child processes. */
const groups = new Set<number>();

/** Lets a signal end them, too. */
function endWithSignals(): void {
  for (const signal of ['SIGINT', 'SIGTERM'] as const) {
    process.on(signal, () => {
      for (const group of groups) process.kill(-group, 'SIGKILL');
      process.exit(signal === 'SIGINT' ? 130 : 143);
    });
  }
}

/** Runs a session in a child process and passes its results on as they come. Ends the child if it hangs. */
async function session(plan: Omit<Plan, 'results'>, onResult: (result: Result) => void): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'mutation-'));
  const results = join(folder, 'results.ndjson');
  writeFileSync(join(folder, 'plan.json'), JSON.stringify({ ...plan, results }));
  const child = spawn(
    process.execPath,
    ['node_modules/vitest/vitest.mjs', 'run', '--config', 'bench/mutation/vitest.config.ts'],
    { cwd: ROOT, env: { ...process.env, [PLAN]: join(folder, 'plan.json') }, stdio: ['ignore', 'pipe', 'pipe'], detached: true },
  );
  const group = child.pid as number;
  groups.add(group);
  let output = '';
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (piece: Buffer) => (output += piece.toString()));
  let taken = 0;
  let since = Date.now();
  const take = (): void => {
    const lines = existsSync(results) ? readFileSync(results, 'utf8').split('\n').slice(0, -1) : [];
    if (lines.length > taken) since = Date.now();
    for (const line of lines.slice(taken)) onResult(JSON.parse(line) as Result);
    taken = lines.length;
  };
  const patience = plan.mutants === null ? 15 * HANGS_AFTER : HANGS_AFTER;
  const timer = setInterval(() => {
    take();
    // its workers are in its process group
    if (Date.now() - since > patience) process.kill(-group, 'SIGKILL');
  }, 200);
  const code = await new Promise<number | null>((resolve) => child.on('close', resolve));
  groups.delete(group);
  clearInterval(timer);
  take();
  rmSync(folder, { recursive: true });
  if (taken === 0) throw new Error(`a session ended with ${code} and no result:\n${output}`);
}

/** Tries mutants in several child processes at once. */
async function tryAll(
  plan: Omit<Plan, 'results' | 'mutants'>,
  mutants: readonly PlacedMutant[],
  jobs: number,
): Promise<Map<number, Fate>> {
  const fates = new Map<number, Fate>();
  const waiting = [...mutants];
  const work = async (): Promise<void> => {
    for (;;) {
      let batch = waiting.splice(0, Math.min(A_CHILD, Math.ceil(mutants.length / jobs)));
      if (batch.length === 0) return;
      while (batch.length > 0) {
        let last: number | null = null;
        await session({ ...plan, mutants: batch.map(({ id, isStatic }) => ({ id, isStatic })) }, (result) => {
          if (result.kind === 'begun') last = result.id;
          if (result.kind === 'tried') {
            fates.set(result.id, result.fate);
            if (fates.size % 100 === 0) console.error(`${fates.size} of ${mutants.length}`);
          }
        });
        // if the child was ended or died, the mutant it was trying has no result
        if (last !== null && !fates.has(last)) fates.set(last, 'timeout');
        batch = batch.filter(({ id }) => !fates.has(id));
      }
    }
  };
  await Promise.all(Array.from({ length: jobs }, work));
  return fates;
}

/** Whether a path contains one of several words. */
const isAsked =
  (asked: readonly string[] | null) =>
  (file: string): boolean =>
    asked === null || asked.some((word) => file.includes(word));

/** A mutant with what became of it. */
interface Tried {
  readonly room: string;
  readonly fate: Fate;
  readonly excuse: Excuse | null;
  readonly mutant: PlacedMutant;
}

const isNoticed = ({ fate }: Tried): boolean => fate === 'killed' || fate === 'timeout';
const isOpen = ({ fate }: Tried): boolean => fate === 'survived' || fate === 'unreached';

/** Counts what became of mutants. */
function rowOf(part: string, list: readonly Tried[]): (string | number)[] {
  const count = (holds: (tried: Tried) => boolean) => list.filter(holds).length;
  const equivalent = count((tried) => isOpen(tried) && tried.excuse?.kind === 'equivalent');
  return [
    part,
    list.length,
    count(({ fate }) => fate === 'killed'),
    count(({ fate }) => fate === 'timeout'),
    count(isOpen),
    equivalent,
    count((tried) => isOpen(tried) && tried.excuse?.kind === 'slack'),
    `${((100 * count(isNoticed)) / Math.max(1, list.length - equivalent)).toFixed(1)} %`,
  ];
}

interface Sample {
  readonly count: number | null;
  readonly seed: number;
}

/** Tries the mutants of some files of a room, or a sample of them, with some of its tests. */
async function tryRoom(
  name: string,
  isFile: (path: string) => boolean,
  isTest: (path: string) => boolean,
  sample: Sample,
  jobs: number,
) {
  const room = ROOMS[name];
  const files = filesIn(ROOT, room.sources, '.ts').filter(isFile);
  const tests = filesIn(ROOT, room.tests, '.test.ts').filter(isTest);
  const random = seeded(sample.seed);
  const mutants = allMutants(ROOT, files)
    .map((mutant) => ({ mutant, rank: random() }))
    .sort((a, b) => a.rank - b.rank)
    .slice(0, sample.count ?? undefined)
    .map(({ mutant }) => mutant);
  if (mutants.length === 0) return { files, tried: [] };
  let reach: Reach | null = null;
  await session({ files, tests, mutants: null, reach: null }, (result) => {
    if (result.kind === 'reach') reach = result.reach;
  });
  if (reach === null) throw new Error(`the tests of ${name} could not be measured`);
  const failing = (reach as Reach).tests.filter(({ fails }) => fails);
  for (const { file, test } of failing) console.error(`left out, since it fails without a mutant: ${file}, test ${test}`);
  const fates = await tryAll({ files, tests, reach }, mutants, jobs);
  const excuses = existsSync(EXCUSES) ? (JSON.parse(readFileSync(EXCUSES, 'utf8')) as Excuse[]) : [];
  const excuseFor = (mutant: PlacedMutant): Excuse | undefined =>
    excuses.find(
      ({ file, at, before, after }) =>
        file === mutant.file && at === mutant.at && before === mutant.before && after === mutant.after,
    );
  const tried = mutants.map(
    (mutant): Tried => ({ room: name, fate: fates.get(mutant.id) as Fate, excuse: excuseFor(mutant) ?? null, mutant }),
  );
  return { files, tried };
}

export const bench = define({
  what: 'small errors in the source, and how many of them its tests detect; minutes to hours',
  options: {
    room: words(`rooms of ${Object.keys(ROOMS).join(', ')}; all when left out`),
    files: words('files whose path contains one of these'),
    tests: words('test files whose path contains one of these'),
    sample: number(null, 'so many mutants of a room'),
    seed: number(1, 'of the sample'),
    jobs: number(2, 'child processes at a time'),
    json: text('a file for all mutants with their fates'),
  },
  claims: {},
  async run({ room, files: inFiles, tests: inTests, sample, seed, jobs, json }) {
    endWithSignals();
    const unknown = room?.find((name) => ROOMS[name] === undefined);
    if (unknown !== undefined) throw new Error(`expected a room (${Object.keys(ROOMS).join(', ')}), found ${unknown}`);
    const rows: (string | number)[][] = [];
    const all: Tried[] = [];
    for (const name of room ?? Object.keys(ROOMS)) {
      const { files, tried } = await tryRoom(name, isAsked(inFiles), isAsked(inTests), { count: sample, seed }, jobs);
      if (tried.length === 0) continue;
      for (const file of files) {
        const ofFile = tried.filter(({ mutant }) => mutant.file === file);
        if (ofFile.length > 0) rows.push(rowOf(file, ofFile));
      }
      rows.push(rowOf(`${name}, all`, tried));
      all.push(...tried);
    }
    if (json !== null) writeFileSync(json, JSON.stringify(all, null, 1));
    const open = all.filter((tried) => isOpen(tried) && tried.excuse === null).sort((a, b) => a.mutant.id - b.mutant.id);
    const inLine = (text: string) => text.replace(/\s+/g, ' ');
    return {
      title: 'Small errors in the source, and how many of them the tests of its room detect',
      columns: ['part', 'mutants', 'killed', 'timeouts', 'survived', 'equivalent', 'slack', 'share'],
      rows,
      measured: {},
      notes: [
        [
          `${open.length} that no test notices, and nothing excuses:`,
          ...open.map(
            ({ fate, mutant: { file, line, before, after } }) =>
              `${file}:${line} ${fate}: ${inLine(before)}  ->  ${inLine(after)}`,
          ),
        ].join('\n'),
        ...all
          .filter((tried) => tried.excuse !== null && isNoticed(tried))
          .map(({ mutant }) => `excused, but noticed: ${mutant.file}:${mutant.line} ${mutant.before} -> ${mutant.after}`),
      ],
    };
  },
});
