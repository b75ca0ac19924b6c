import type { ShownProblem } from '../shown-problem.ts';

/**
 * Says of each problem where it is in a way that survives changes elsewhere in the file: its pointer with ids of objects and
 * names of runs in place of indices.
 * @param text the file
 */
export function withKeys(problems: readonly ShownProblem[], text: string): ShownProblem[] {
  const document = problems.some(({ pointer }) => /\/\d/.test(pointer)) ? parsed(text) : null;
  return problems.map((problem) => ({ ...problem, key: keyOf(problem.pointer, document) }));
}

/** The key of a pointer into a document; entries of lists without an id or a name are all alike. */
export function keyOf(pointer: string, document: unknown): string {
  let value = document;
  const steps = pointer.split('/').map((step, i) => {
    if (i === 0) return '';
    const inner = insideOf(value, step);
    const isIndex = value === undefined || value === null ? /^\d+$/.test(step) : Array.isArray(value);
    value = inner;
    return isIndex ? nameOf(inner) : step;
  });
  return steps.join('/');
}

function insideOf(value: unknown, step: string): unknown {
  if (typeof value !== 'object' || value === null) return undefined;
  const key = step.replaceAll('~1', '/').replaceAll('~0', '~');
  return Object.hasOwn(value, key) ? (value as Record<string, unknown>)[key] : undefined;
}

function nameOf(entry: unknown): string {
  if (typeof entry !== 'object' || entry === null) return '*';
  const { id, name } = entry as { readonly id?: unknown; readonly name?: unknown };
  const known = typeof id === 'string' ? id : typeof name === 'string' ? name : null;
  return known === null ? '*' : `=${known.replaceAll('~', '~0').replaceAll('/', '~1')}`;
}

/** The content of a file; null if it is not JSON. */
function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
