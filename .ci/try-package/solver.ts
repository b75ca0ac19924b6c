import { compile, simulate } from 'gravity-quest-toolkit';
import { readLevel } from 'gravity-quest-toolkit/game';
import { createSolver, type Solver } from 'gravity-quest-toolkit/solver';

/** The first run that is found, and the hash of what it does. */
export function trial(text: string): string {
  const read = readLevel(text);
  if (!read.ok) throw new Error(read.message);
  const scene = compile(read.level, 'precise');
  const solver: Solver = createSolver(scene, { objective: 'first' });
  while (solver.best === null && !solver.finished) solver.advance(10_000);
  if (solver.best === null) return 'none';
  // @ts-expect-error: the types are known, and this is none of them
  const holds: string = solver.best.holds;
  return `${JSON.stringify(holds)} ${simulate(scene, solver.best.holds).hash}`;
}
