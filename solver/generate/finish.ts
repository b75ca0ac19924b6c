import { compile, findWarnings, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import type { Random } from '../random.ts';
import { measureRobustness } from '../robustness/index.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import type { Attempt } from './generated.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import type { Layout } from './layout.ts';
import { toLevelFile } from './level-file.ts';
import { placeMinerals } from './minerals.ts';
import { nameLevel } from './name.ts';
import { ALL, ANY, findWays, gradeRun, sceneOf } from './scouting.ts';
import { wayOf } from './tube.ts';

const MINERALS = 3;

// The cost of the measurements, in runs, about.
const MEASURING = 8000;

/** Places the minerals, finds a run that collects them all, and checks everything that is claimed. */
export function* finish(
  layout: Layout,
  spec: GeneratorSpec,
  ways: readonly Candidate[],
  random: Random,
  description: string,
): Attempt {
  const [solution] = ways;
  const bare = sceneOf(layout);
  const precise = compile(bare.level);
  const arcade = measureRobustness(bare, solution.holds, ANY, { seed: 1 });
  const robustness = measureRobustness(precise, solution.holds, ANY, { seed: 1 });
  const grade = gradeRun(precise, solution, 1);
  yield MEASURING * solution.tick;
  if (grade.value < spec.grade[0] || grade.value > spec.grade[1]) return null;
  for (const { certifiedTicks, p40 } of [robustness, arcade]) {
    if (certifiedTicks < spec.certifiedTicks || p40.p < spec.p40) return null;
  }

  // Put the minerals on several paths first, so that they have to be looked for. If no run collects them all, put them on the
  // path to the black hole.
  const several = Array.from({ length: MINERALS }, (_, i) => wayOf(bare, ways[i % ways.length].holds));
  const along = Array.from({ length: MINERALS }, () => wayOf(bare, solution.holds));
  for (const mineralWays of ways.length > 1 ? [several, along] : [along]) {
    const full = placeMinerals(layout, spec, mineralWays, random);
    if (full.minerals.length < MINERALS) continue;
    const collecting = yield* findWays(sceneOf(full), ALL, random.next());
    const onTheWay = verifyRun(sceneOf(full), solution.holds, ALL);
    const all = collecting[0] ?? onTheWay;
    if (all === undefined || all === null) continue;
    const runs = [
      { name: 'solution', holds: solution.holds },
      { name: 'all-minerals', holds: all.holds },
    ];
    const level = toLevelFile(full, nameLevel(random), description, runs);
    if (holdsUp(level)) return { level, holds: solution.holds, robustness, arcade, grade };
  }
  return null;
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
  return findWarnings(level, [simulate(scene, solution.holds), simulate(scene, all.holds)]).length === 0;
}
