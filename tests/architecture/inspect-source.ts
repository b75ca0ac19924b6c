import { dirname, posix } from 'node:path';
import { once } from '../once.ts';
import { IMPURE_GLOBALS, PORTABLE_MATH, ROOMS, TOPS } from './rooms.ts';
import { isNode, lineOf, type Node, treeOf, walk } from './syntax.ts';

const literal = (value: unknown): string | null =>
  isNode(value) && value.type === 'Literal' && typeof value.value === 'string' ? value.value : null;

/** What a text has that imports elsewhere than at its outermost level: on demand, in a type, or in a declared module. */
const MAYBE_INSIDE = /\bimport\s*[(/]|\b(?:module|namespace|global)\b/;

/** What a source file imports: static, re-exported, dynamic and in types. A dynamic import of no literal is `null`. */
export const importsOf = once((path: string, text: string): (string | null)[] => {
  const found: (string | null)[] = [];
  const visit = (node: Node): void => {
    if (node.type === 'ImportDeclaration' || node.type === 'ImportExpression' || node.type === 'TSImportType') {
      found.push(literal(node.source));
    }
    if ((node.type === 'ExportNamedDeclaration' && node.source) || node.type === 'ExportAllDeclaration') {
      found.push(literal(node.source));
    }
  };
  const tree = treeOf(path, text);
  if (MAYBE_INSIDE.test(text)) walk(tree, visit);
  else for (const statement of tree.body as readonly Node[]) visit(statement);
  return found;
});

/** Of what a source file imports more than types. */
function valuesFrom(path: string, text: string): Set<string | null> {
  const found = new Set<string | null>();
  walk(treeOf(path, text), (node) => {
    const isImport = node.type === 'ImportDeclaration' && node.importKind !== 'type';
    const isExport =
      (node.type === 'ExportNamedDeclaration' || node.type === 'ExportAllDeclaration') && node.exportKind !== 'type';
    if (isImport || isExport || node.type === 'ImportExpression') found.add(literal(node.source));
  });
  return found;
}

const packageName = (specifier: string) =>
  specifier
    .split('/')
    .slice(0, specifier.startsWith('@') ? 2 : 1)
    .join('/');

/**
 * What is wrong with the imports of a file in a room.
 * @param path from the project's root, with slashes: `engine/hash.ts`
 * @param dependencies the names under `dependencies` and `optionalDependencies` of package.json
 */
export function importProblems(path: string, text: string, dependencies: readonly string[]): string[] {
  const own = path.split('/')[0];
  const room = ROOMS[own];
  const problems: string[] = [];
  for (const specifier of importsOf(path, text)) {
    if (specifier === null) {
      if (room.pure) problems.push(`${path}: imports something computed`);
    } else if (specifier.startsWith('.')) {
      const target = posix.join(dirname(path), specifier);
      const other = target.split('/')[0];
      const top = Object.keys(TOPS).find((folder) => target.startsWith(`${folder}/`) && !path.startsWith(`${folder}/`));
      if (top !== undefined && !TOPS[top].includes(path)) problems.push(`${path}: ${top} stands on it and may not be known here`);
      if (other === own) continue;
      if (!room.knows.includes(other) && target !== 'package.json') problems.push(`${path}: ${own} may not know ${target}`);
      else if (room.knows.includes(other) && posix.basename(target) !== 'index.ts') {
        problems.push(`${path}: ${target} is not the face of its folder (index.ts)`);
      }
    } else if (specifier.startsWith('node:')) {
      if (room.pure || room.bundled) problems.push(`${path}: ${own} is no place for Node and may not import ${specifier}`);
    } else if (own !== 'editor' && (specifier === 'phaser' || specifier.startsWith('phaser/'))) {
      if (own !== 'phaser') problems.push(`${path}: ${own} may not know Phaser`);
      else if (valuesFrom(path, text).has(specifier))
        problems.push(`${path}: Phaser is given by the game and only known by its types`);
    } else {
      const name = packageName(specifier);
      if (!dependencies.includes(name)) problems.push(`${path}: ${name} is not among the dependencies of package.json`);
      else if (room.packages !== null && !room.packages.includes(name)) problems.push(`${path}: ${own} may not use ${name}`);
    }
  }
  return problems;
}

/** Places in a pure file where something not bit-identical between engines, or impure, is used. */
export function purityProblems(path: string, text: string): string[] {
  const { drawing = false } = ROOMS[path.split('/')[0]];
  const problems: string[] = [];
  walk(treeOf(path, text), (node, parent, key) => {
    const where = () => `${path}:${lineOf(text, node)}`;
    const power =
      (node.type === 'BinaryExpression' && node.operator === '**') ||
      (node.type === 'AssignmentExpression' && node.operator === '**=');
    if (power && !drawing) {
      problems.push(`${where()}: ${node.operator} is not bit-identical between engines`);
    }
    if (node.type !== 'Identifier' || parent === null) return;
    const isProperty =
      (key === 'property' && parent.type === 'MemberExpression' && parent.computed !== true) ||
      (key === 'key' && parent.computed !== true && parent.shorthand !== true);
    if (isProperty) return;
    if (node.name === 'Math' && !drawing) {
      const property = parent.type === 'MemberExpression' && parent.computed !== true ? (parent.property as Node) : null;
      if (property === null || !PORTABLE_MATH.has(property.name as string)) {
        problems.push(`${where()}: Math.${property?.name ?? '?'} is not bit-identical between engines`);
      }
    }
    if (IMPURE_GLOBALS.has(node.name as string)) problems.push(`${where()}: ${node.name} has no place in a pure room`);
  });
  return problems;
}
