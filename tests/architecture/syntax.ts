import { parseSync } from 'vite';

/** A node of a syntax tree (ESTree). */
export interface Node {
  readonly type: string;
  readonly start: number;
  readonly [key: string]: unknown;
}

/**
 * The syntax tree of a source file.
 * @throws SyntaxError if the file has one
 */
export function treeOf(path: string, text: string): Node {
  const { program, errors } = parseSync(path, text);
  if (errors.length > 0) throw new SyntaxError(`${path}: ${errors[0].message}`);
  return program as unknown as Node;
}

export const isNode = (value: unknown): value is Node =>
  typeof value === 'object' && value !== null && typeof (value as { type?: unknown }).type === 'string';

/** Visits every node, with its parent and the parent's key for it. */
export function walk(
  node: Node,
  visit: (node: Node, parent: Node | null, key: string) => void,
  parent: Node | null = null,
  key = '',
): void {
  visit(node, parent, key);
  // for...in, because a list of the entries of every node takes longer than the visits
  for (const name in node) {
    const value = node[name];
    if (Array.isArray(value)) {
      for (const child of value) if (isNode(child)) walk(child, visit, node, name);
    } else if (isNode(value)) walk(value, visit, node, name);
  }
}

/** The line of a node, from 1. */
export const lineOf = (text: string, { start }: Node): number => text.slice(0, start).split('\n').length;
