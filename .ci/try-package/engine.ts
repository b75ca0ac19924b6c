import { compile, type Run, simulate } from 'gravity-quest-toolkit';
import { readLevel } from 'gravity-quest-toolkit/game';

/** The hash of the level's first run. */
export function trial(text: string): string {
  const read = readLevel(text);
  if (!read.ok) throw new Error(read.message);
  const run: Run = simulate(compile(read.level, 'precise'), read.level.runs[0].holds);
  const hash: string = run.hash;
  // @ts-expect-error: the types are known, and this is none of them
  const tick: string = run.tick;
  return tick === undefined ? '' : hash;
}
