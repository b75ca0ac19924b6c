// Measures how many small errors in the source the tests of its room detect; see bench/README.md.

import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { seeded } from '../tests/scenes/seeded.ts';
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

const root = `${process.cwd()}/`;
const EXCUSES = join(root, 'bench/mutation/survivors.json');

// running groups of child processes: a signal ends them, too
const groups = new Set<number>();
for (const signal of ['SIGINT', 'SIGTERM'] as const) {
  process.on(signal, () => {
    for (const group of groups) process.kill(-group, 'SIGKILL');
    process.exit(signal === 'SIGINT' ? 130 : 143);
  });
}

/** Runs a session in a child process and passes its results on as they come. Ends the child if it hangs. */
async function session(plan: Omit<Plan, 'results'>, onResult: (result: Result) => void): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'mutation-'));
  const results = join(folder, 'results.ndjson');
  writeFileSync(join(folder, 'plan.json'), JSON.stringify({ ...plan, results }));
  const child = spawn(
    process.execPath,
    ['node_modules/vitest/vitest.mjs', 'run', '--config', 'bench/mutation/vitest.config.ts'],
    { cwd: root, env: { ...process.env, [PLAN]: join(folder, 'plan.json') }, stdio: ['ignore', 'pipe', 'pipe'], detached: true },
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

const { values } = parseArgs({
  options: {
    room: { type: 'string', multiple: true },
    files: { type: 'string' },
    tests: { type: 'string' },
    sample: { type: 'string' },
    seed: { type: 'string', default: '1' },
    jobs: { type: 'string', default: '2' },
    json: { type: 'string' },
  },
});
const unknown = values.room?.find((name) => ROOMS[name] === undefined);
if (unknown !== undefined) throw new Error(`expected a room (${Object.keys(ROOMS).join(', ')}), found ${unknown}`);

const excuses = existsSync(EXCUSES) ? (JSON.parse(readFileSync(EXCUSES, 'utf8')) as Excuse[]) : [];
const excuseFor = (mutant: PlacedMutant): Excuse | undefined =>
  excuses.find(
    ({ file, at, before, after }) =>
      file === mutant.file && at === mutant.at && before === mutant.before && after === mutant.after,
  );

/** Whether a path contains one of several words, which are separated by commas. */
const isAsked =
  (words = '') =>
  (file: string): boolean =>
    words.split(',').some((word) => file.includes(word));

const table: Record<string, unknown>[] = [];
const all: { room: string; fate: Fate; excuse: Excuse | null; mutant: PlacedMutant }[] = [];
for (const name of values.room ?? Object.keys(ROOMS)) {
  const room = ROOMS[name];
  const files = filesIn(root, room.sources, '.ts').filter(isAsked(values.files));
  const tests = filesIn(root, room.tests, '.test.ts').filter(isAsked(values.tests));
  const random = seeded(Number(values.seed));
  const mutants = allMutants(root, files)
    .map((mutant) => ({ mutant, rank: random() }))
    .sort((a, b) => a.rank - b.rank)
    .slice(0, values.sample === undefined ? undefined : Number(values.sample))
    .map(({ mutant }) => mutant);
  if (mutants.length === 0) continue;
  let reach: Reach | null = null;
  await session({ files, tests, mutants: null, reach: null }, (result) => {
    if (result.kind === 'reach') reach = result.reach;
  });
  if (reach === null) throw new Error(`the tests of ${name} could not be measured`);
  const failing = (reach as Reach).tests.filter(({ fails }) => fails);
  for (const { file, test } of failing) console.error(`left out, since it fails without a mutant: ${file}, test ${test}`);
  const fates = await tryAll({ files, tests, reach }, mutants, Number(values.jobs));

  const row = (part: string, list: readonly PlacedMutant[]) => {
    const count = (fate: Fate) => list.filter(({ id }) => fates.get(id) === fate).length;
    const open = list.filter(({ id }) => fates.get(id) === 'survived' || fates.get(id) === 'unreached');
    const equivalent = open.filter((mutant) => excuseFor(mutant)?.kind === 'equivalent').length;
    const slack = open.filter((mutant) => excuseFor(mutant)?.kind === 'slack').length;
    const noticed = count('killed') + count('timeout');
    return {
      part,
      mutants: list.length,
      killed: count('killed'),
      timeouts: count('timeout'),
      survived: open.length,
      equivalent,
      slack,
      share: `${((100 * noticed) / Math.max(1, list.length - equivalent)).toFixed(1)} %`,
    };
  };
  for (const file of files) {
    const ofFile = mutants.filter((mutant) => mutant.file === file);
    if (ofFile.length > 0) table.push(row(file, ofFile));
  }
  table.push(row(`${name}, all`, mutants));
  for (const mutant of mutants) {
    all.push({ room: name, fate: fates.get(mutant.id) as Fate, excuse: excuseFor(mutant) ?? null, mutant });
  }
}

console.table(table);
const open = all
  .filter(({ fate, excuse }) => (fate === 'survived' || fate === 'unreached') && excuse === null)
  .sort((a, b) => a.mutant.id - b.mutant.id);
console.log(`${open.length} that no test notices, and nothing excuses:`);
for (const { fate, mutant } of open) {
  console.log(
    `${mutant.file}:${mutant.line} ${fate}: ${mutant.before.replace(/\s+/g, ' ')}  ->  ${mutant.after.replace(/\s+/g, ' ')}`,
  );
}
const noticed = all.filter(({ fate, excuse }) => excuse !== null && (fate === 'killed' || fate === 'timeout'));
for (const { mutant } of noticed)
  console.log(`excused, but noticed: ${mutant.file}:${mutant.line} ${mutant.before} -> ${mutant.after}`);
if (values.json !== undefined) writeFileSync(values.json, JSON.stringify(all, null, 1));
