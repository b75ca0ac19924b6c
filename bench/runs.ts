import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';
import {
  type AccuracyName,
  compile,
  createSimulation,
  DEFAULT_MAX_TICKS,
  joinHolds,
  playScript,
  TICK_RATE,
} from '../engine/index.ts';
import { type Hold, importOriginal, type Level, readLevel, resolveLevel } from '../schema/index.ts';
import { atMost, type Claim, compare, consume, optionValue, publish } from './harness.ts';

const ACCURACIES: readonly AccuracyName[] = ['arcade', 'fast', 'standard', 'precise'];

interface Case {
  readonly name: string;
  readonly level: Level;
  readonly holds: readonly Hold[];
}

/** Every run of the shipped levels, or of the level files in a directory given with --levels. */
function packCases(directory: string): Case[] {
  const cases: Case[] = [];
  for (const name of readdirSync(directory).filter((file) => file.endsWith('.level.json'))) {
    const read = readLevel(readFileSync(join(directory, name)));
    if (!read.ok) throw new Error(`expected a valid level in ${name}: ${read.problems[0].message}`);
    for (const run of read.level.runs) cases.push({ name: `${name} ${run.name}`, level: read.level, holds: run.holds });
  }
  return cases;
}

/** The runs of recordings of the original game, given with --recordings: `original-levels.json` beside `arcade/*.json.gz`. */
function recordedCases(directory: string): Case[] {
  const imported = importOriginal(readFileSync(join(directory, 'original-levels.json')), { recoil: false });
  if (!imported.ok) throw new Error(`expected levels to import: ${imported.problems[0].message}`);
  const levels = new Map(imported.levels.map(({ slug, file }) => [slug, resolveLevel(file)]));
  const cases: Case[] = [];
  for (const name of readdirSync(join(directory, 'arcade'))) {
    const slug = name.replace('.json.gz', '');
    const level = levels.get(slug);
    if (level === undefined) throw new Error(`expected ${slug} among the imported levels`);
    const { runs } = JSON.parse(gunzipSync(readFileSync(join(directory, 'arcade', name))).toString()) as {
      runs: { name: string; holds: Hold[] }[];
    };
    for (const run of runs) cases.push({ name: `${slug} ${run.name}`, level, holds: run.holds });
  }
  return cases;
}

const recordings = optionValue('--recordings');
if (recordings !== null && !existsSync(recordings))
  throw new Error(`expected a directory of recordings, found none at ${recordings}`);
const cases =
  recordings === null
    ? packCases(optionValue('--levels') ?? fileURLToPath(new URL('../../levels/', import.meta.url)))
    : recordedCases(recordings);

const ratios: Record<string, { name: string; ratio: number }[]> = Object.fromEntries(ACCURACIES.map((a) => [a, []]));
const costs: Record<string, number[]> = Object.fromEntries(ACCURACIES.map((a) => [a, []]));
for (const { name, level, holds } of cases) {
  const script = joinHolds(holds);
  const simulations = ACCURACIES.map((accuracy) => createSimulation(compile(level, accuracy)));
  const measured = compare(
    simulations.map((simulation, i) => ({
      name: ACCURACIES[i],
      run() {
        simulation.reset();
        playScript(simulation, script, DEFAULT_MAX_TICKS);
        return simulation.tick;
      },
    })),
    { rounds: 15, sampleMs: 0.5, warmUpMs: 5 },
  );
  // accuracies may end a run at different times, so costs are compared per simulated second
  const perSecond = (i: number) => (measured.time(ACCURACIES[i]).median * 1000) / (Math.max(1, simulations[i].tick) / TICK_RATE);
  for (const [i, accuracy] of ACCURACIES.entries()) {
    costs[accuracy].push(perSecond(i));
    const ticks = Math.max(1, simulations[i].tick) / Math.max(1, simulations[0].tick);
    ratios[accuracy].push({ name, ratio: measured.ratio(accuracy, 'arcade').median / ticks });
  }
  consume(simulations[0].tick);
}

const at = (values: readonly number[], part: number) => [...values].sort((a, b) => a - b)[Math.floor(part * (values.length - 1))];
const claims: Claim[] = [];
const ofPrecise = ratios.precise.map(({ ratio }) => ratio);
claims.push(atMost('precise / arcade, median run', at(ofPrecise, 0.5), 4));
claims.push(atMost('precise / arcade, 90 % of the runs', at(ofPrecise, 0.9), 7));
claims.push(atMost('precise / fast, medians of all runs', at(costs.precise, 0.5) / at(costs.fast, 0.5), 1));
publish({
  title: `Cost of each accuracy on ${cases.length} runs`,
  columns: ['accuracy', 'us a simulated second', 'over arcade: median', '90 %', 'worst', 'worst run'],
  rows: ACCURACIES.map((accuracy) => {
    const all = ratios[accuracy].map(({ ratio }) => ratio);
    const worst = [...ratios[accuracy]].sort((a, b) => b.ratio - a.ratio)[0];
    return [accuracy, at(costs[accuracy], 0.5), at(all, 0.5), at(all, 0.9), at(all, 1), worst.name];
  }),
  claims,
  notes: ['Per simulated second; each run timed side by side at every accuracy, medians of 15 interleaved rounds.'],
});
