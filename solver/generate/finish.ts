import { compile, findWarnings, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import type { Random } from '../random.ts';
import { measureRobustness } from '../robustness/index.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import type { Attempt, Rejection } from './generated.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { withoutIdle } from './idle.ts';
import type { Layout } from './layout.ts';
import { toLevelFile } from './level-file.ts';
import { placeMinerals } from './minerals.ts';
import { nameLevel } from './name.ts';
import { ALL, ANY, findWays, gradeRun, sceneOf } from './scouting.ts';
import { wayOf } from './tube.ts';

const MINERALS = 3;

// Ticks to find a run that collects all minerals.
const COLLECTING = 800_000;

// The cost of the measurements, in runs, about.
const MEASURING = 8000;

/** Removes idle objects, measures the level, places the minerals, and checks everything that is claimed. */
export function* finish(
  hardened: Layout,
  spec: GeneratorSpec,
  ways: readonly Candidate[],
  random: Random,
  description: string,
): Attempt {
  const [solution] = ways;
  const { layout, ticks } = withoutIdle(hardened, ways.slice(0, 3), random.next());
  yield ticks;
  const bare = sceneOf(layout);
  const precise = compile(bare.level);
  if (verifyRun(bare, solution.holds) === null || verifyRun(precise, solution.holds) === null) return 'unforgiving';
  const grade = gradeRun(precise, solution, 1);
  if (grade.value < spec.grade[0]) return 'tooEasy';
  if (grade.value > spec.grade[1]) return 'tooHard';
  const arcade = measureRobustness(bare, solution.holds, ANY, { seed: 1 });
  const robustness = measureRobustness(precise, solution.holds, ANY, { seed: 1 });
  yield MEASURING * solution.tick;
  for (const { certifiedTicks, p40 } of [robustness, arcade]) {
    if (certifiedTicks < spec.certifiedTicks || p40.p < spec.p40) return 'unforgiving';
  }

  // Put the minerals on several paths first, so that they have to be looked for. If no run collects them all, put them on the
  // path to the black hole.
  const several = Array.from({ length: MINERALS }, (_, i) => wayOf(bare, ways[i % ways.length].holds));
  const along = Array.from({ length: MINERALS }, () => wayOf(bare, solution.holds));
  let reason: Rejection = 'noMinerals';
  for (const mineralWays of ways.length > 1 ? [several, along, along] : [along, along]) {
    const full = placeMinerals(layout, spec, mineralWays, random);
    if (full.minerals.length < MINERALS) continue;
    const onTheWay = verifyRun(sceneOf(full), solution.holds, ALL);
    const collecting = onTheWay === null ? yield* findWays(sceneOf(full), ALL, random.next(), COLLECTING, [solution]) : [];
    const all = onTheWay ?? collecting[0];
    if (all === undefined) continue;
    const runs = [
      { name: 'solution', holds: solution.holds },
      { name: 'all-minerals', holds: all.holds },
    ];
    const level = toLevelFile(full, nameLevel(random), description, runs);
    if (holdsUp(level)) return { level, holds: solution.holds, robustness, arcade, grade };
    reason = 'warnings';
  }
  return reason;
}

/** Whether both runs of a finished file do what their names say at `precise` and `arcade`, and no warnings are left. */
function holdsUp(file: LevelFile): boolean {
  const level = resolveLevel(file);
  const [solution, all] = level.runs;
  for (const accuracy of ['precise', 'arcade'] as const) {
    const scene = compile(level, accuracy);
    if (verifyRun(scene, []) !== null) return false;
    if (verifyRun(scene, solution.holds) === null || verifyRun(scene, all.holds, ALL) === null) return false;
  }
  const scene = compile(level);
  const warnings = findWarnings(level, [simulate(scene, solution.holds), simulate(scene, all.holds)]);
  return warnings.length === 0;
}
