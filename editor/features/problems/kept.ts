import type { Problem } from '../../../schema/index.ts';

const isSame = (a: Problem, b: Problem): boolean =>
  a.code === b.code &&
  a.severity === b.severity &&
  a.message === b.message &&
  a.hint === b.hint &&
  a.pointer === b.pointer &&
  a.line === b.line &&
  a.column === b.column;

const nameOf = ({ code, pointer, message }: Problem): string => `${code} ${pointer} ${message}`;

/**
 * The problems found now, with objects reused for problems that were there before, and the previous list if nothing changed:
 * components for them then need not render again.
 */
export function keepSame(before: readonly Problem[], now: readonly Problem[]): readonly Problem[] {
  const old = new Map(before.map((problem) => [nameOf(problem), problem]));
  const kept = now.map((problem) => {
    const same = old.get(nameOf(problem));
    return same !== undefined && isSame(same, problem) ? same : problem;
  });
  return kept.length === before.length && kept.every((problem, i) => problem === before[i]) ? before : kept;
}

/** A key for each problem, unique in the list and independent of the problems before it. */
export function keysOf(problems: readonly Problem[]): string[] {
  const seen = new Map<string, number>();
  return problems.map(({ code, pointer }) => {
    const name = `${code} ${pointer}`;
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    return `${name} ${count}`;
  });
}
