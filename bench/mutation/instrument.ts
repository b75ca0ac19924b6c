import { parseSync } from 'vite';
import type { PlacedMutant } from './mutants.ts';

interface Insertion {
  readonly at: number;
  readonly text: string;
  /**
   * Order of edits at one place: closing ones come before opening ones; a small one is closed first, and a large one opened
   * first.
   */
  readonly order: number;
}

/**
 * The source with all of its mutants in it, each behind a switch, and with a counter in every loop, so that an endless loop is
 * noticed. `globalThis.mutation` says which mutant is on (see session.ts).
 */
export function instrumented(file: string, text: string, mutants: readonly PlacedMutant[]): string {
  const sites = new Map<string, PlacedMutant[]>();
  for (const mutant of mutants) {
    const key = mutant.site.join(' ');
    const there = sites.get(key);
    if (there === undefined) sites.set(key, [mutant]);
    else there.push(mutant);
  }
  const insertions: Insertion[] = [];
  for (const list of sites.values()) {
    const [start, end] = list[0].site;
    const ways = list.map(({ id, edit, after }) => {
      const changed = text.slice(start, edit[0]) + after + text.slice(edit[1], end);
      return `$mutation.is(${id}) ? (${changed}) : `;
    });
    insertions.push({ at: start, text: `(${ways.join('')}(`, order: 2e9 - (end - start) });
    insertions.push({ at: end, text: '))', order: end - start - 2e9 });
  }
  for (const body of loopBodies(file, text)) {
    if (text[body.start] === '{') insertions.push({ at: body.start + 1, text: ' $mutation.turn(); ', order: 0 });
    else {
      insertions.push({ at: body.start, text: '{ $mutation.turn(); ', order: 0 });
      insertions.push({ at: body.end, text: ' }', order: 0 });
    }
  }
  insertions.sort((a, b) => a.at - b.at || a.order - b.order);
  let result = 'const $mutation = globalThis.mutation; ';
  let from = 0;
  for (const { at, text: inserted } of insertions) {
    result += text.slice(from, at) + inserted;
    from = at;
  }
  return result + text.slice(from);
}

interface Node {
  readonly type: string;
  readonly start: number;
  readonly end: number;
}

function loopBodies(file: string, text: string): Node[] {
  const found: Node[] = [];
  const walk = (value: unknown): void => {
    if (Array.isArray(value)) {
      for (const one of value) walk(one);
    } else if (typeof value === 'object' && value !== null && 'type' in value) {
      const node = value as Node & { readonly body?: Node };
      if (/^(For|While|DoWhile)\w*Statement$/.test(node.type) && node.body !== undefined) found.push(node.body);
      for (const child of Object.values(node)) walk(child);
    }
  };
  walk(parseSync(file, text).program);
  return found;
}
