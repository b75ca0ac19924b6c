import type { Configuration } from '../configuration.ts';
import type { CheckedLevel } from './checked-level.ts';

type Configured = Pick<Configuration, 'severity'>;

/** Applies what a configuration and a level say about its problems. The verdict stays. */
export async function judgeOf({ severity }: Configured): Promise<(level: CheckedLevel) => CheckedLevel> {
  // imported only if needed: it loads the schema, which usually only the workers load
  const { applyPolicy } = await import('../../check/policy/index.ts');
  return (level) => ({ ...level, ...applyPolicy(level.problems, { severity, allow: level.allow ?? {} }) });
}

/** Applies what a configuration and each level say about problems. Verdicts stay. */
export async function judgeLevels(levels: readonly CheckedLevel[], configuration: Configured): Promise<readonly CheckedLevel[]> {
  const isPlain = Object.keys(configuration.severity).length === 0 && levels.every(({ allow }) => allow === undefined);
  return isPlain ? levels : levels.map(await judgeOf(configuration));
}
