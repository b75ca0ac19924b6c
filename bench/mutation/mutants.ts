import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseSync } from 'vite';

/** One small change to a source file, such as a typing error would make. */
export interface Mutant {
  /** Its number among all mutants of a session. */
  readonly id: number;
  readonly file: string;
  /** Line in the file, from 1. */
  readonly line: number;
  /** The line of the source without leading and trailing space; it identifies the place when lines above change. */
  readonly at: string;
  readonly before: string;
  readonly after: string;
  /** Whether it takes effect while its module is loaded, not only when a function is called. */
  readonly isStatic: boolean;
}

/** A mutant with its place in the text: `edit` is replaced; `site` is the expression around it that can be switched. */
export interface PlacedMutant extends Mutant {
  readonly edit: Span;
  readonly site: Span;
}

type Span = readonly [start: number, end: number];

interface Node {
  readonly type: string;
  readonly start: number;
  readonly end: number;
  readonly [key: string]: unknown;
}

interface Context {
  readonly site: Span | null;
  readonly isStatic: boolean;
  /** Inside `a?.b.c`, where putting a part into brackets would change the meaning. */
  readonly inChain: boolean;
}

const RELATIONS: Record<string, readonly string[]> = {
  '<': ['<=', '>='],
  '<=': ['<', '>'],
  '>': ['>=', '<='],
  '>=': ['>', '<'],
  '===': ['!=='],
  '!==': ['==='],
};
const ARITHMETIC: Record<string, string> = { '+': '-', '-': '+', '*': '/', '/': '*' };
const ASSIGNMENTS: Record<string, string> = { '+=': '-=', '-=': '+=', '*=': '/=', '/=': '*=', '??=': '=' };

/** Properties of one kind that are easily confused. */
const TWINS: ReadonlyMap<string, string> = new Map(
  [
    ['x', 'y'],
    ['vx', 'vy'],
    ['ax', 'ay'],
    ['left', 'right'],
    ['low', 'high'],
    ['from', 'to'],
    ['least', 'most'],
    ['back', 'front'],
    ['some', 'every'],
  ].flatMap(([a, b]): [string, string][] => [
    [a, b],
    [b, a],
  ]),
);

const FUNCTIONS = new Set(['FunctionDeclaration', 'FunctionExpression', 'ArrowFunctionExpression']);
const EXPRESSION = /(Expression|Literal|Identifier)$/;

/** All mutants of a source file, numbered from `first`. */
export function mutantsOf(file: string, text: string, first: number): PlacedMutant[] {
  const found: PlacedMutant[] = [];
  const part = (node: Node) => text.slice(node.start, node.end);
  const lineStarts = [...text.matchAll(/^/gm)].map(({ index }) => index);

  const add = (edit: Span, after: string, { site, isStatic }: Context): void => {
    if (site === null) return;
    const line = lineStarts.findLastIndex((start) => start <= edit[0]) + 1;
    const at = text.slice(lineStarts[line - 1], lineStarts[line] ?? text.length).trim();
    found.push({
      ...{ id: first + found.length, file, line, at, before: text.slice(...edit), after, isStatic, edit, site },
    });
  };

  walk(parseSync(file, text).program as unknown as Node, null, '', { site: null, isStatic: true, inChain: false });
  return found;

  function walk(node: Node, parent: Node | null, key: string, outer: Context): void {
    if (isLeftAlone(node, parent, key)) return;
    const inChain =
      node.type === 'ChainExpression' || (outer.inChain && (key === 'object' || key === 'callee' || key === 'expression'));
    const canSwitch = isSwitchable(node, parent, key) && !(outer.inChain && inChain);
    const isStatic = outer.isStatic && !FUNCTIONS.has(node.type);
    const here: Context = { site: canSwitch ? [node.start, node.end] : outer.site, isStatic, inChain };
    mutate(node, parent, key, here);
    for (const [name, value] of Object.entries(node)) {
      for (const child of Array.isArray(value) ? value : [value]) {
        // a part of a statement has no expression around it
        if (isNode(child)) walk(child, node, name, EXPRESSION.test(node.type) ? here : { ...here, site: null });
      }
    }
  }

  function mutate(node: Node, parent: Node | null, key: string, here: Context): void {
    const whole: Span = [node.start, node.end];
    const replace = (after: string) => add(whole, after, here);
    switch (node.type) {
      case 'BinaryExpression':
        binary(node, here);
        return;
      case 'LogicalExpression': {
        const [left, right] = [part(node.left as Node), part(node.right as Node)];
        if (node.operator === '??') {
          replace(`(${right})`);
          return;
        }
        replace(`(${left} ${node.operator === '&&' ? '||' : '&&'} ${right})`);
        replace(`(${left})`);
        replace(`(${right})`);
        return;
      }
      case 'UnaryExpression':
        if (node.operator === '-' || node.operator === '!') replace(`(${part(node.argument as Node)})`);
        return;
      case 'UpdateExpression':
        // a loop that counts the wrong way would only never end
        if (key !== 'update') replace(node.operator === '++' ? part(node).replace('++', '--') : part(node).replace('--', '++'));
        return;
      case 'AssignmentExpression': {
        const other = ASSIGNMENTS[node.operator as string];
        if (other !== undefined) replace(`${part(node.left as Node)} ${other} ${part(node.right as Node)}`);
        return;
      }
      case 'ConditionalExpression':
        replace(`(${part(node.consequent as Node)})`);
        replace(`(${part(node.alternate as Node)})`);
        return;
      case 'Literal':
        if (typeof node.value === 'number') for (const n of numbersNear(node.value)) replace(String(n));
        if (typeof node.value === 'boolean') replace(String(!node.value));
        return;
      case 'MemberExpression':
        member(node, here);
        return;
      case 'CallExpression':
        call(node, here);
        return;
      case 'IfStatement':
      case 'WhileStatement': {
        const test = node.test as Node;
        const inTest: Context = { ...here, site: [test.start, test.end] };
        add([test.start, test.end], 'false', inTest);
        if (node.type === 'IfStatement') add([test.start, test.end], 'true', inTest);
        return;
      }
      case 'ExpressionStatement': {
        const { type, start, end, callee } = node.expression as Node;
        if (parent !== null && FUNCTIONS.has(parent.type)) return;
        // a constructor whose parameters are properties must begin with it
        if (type === 'CallExpression' && (callee as Node).type === 'Super') return;
        add([start, end], 'undefined', { ...here, site: [start, end] });
        return;
      }
    }
  }

  function binary(node: Node, here: Context): void {
    const operator = node.operator as string;
    const [left, right] = [node.left as Node, node.right as Node];
    const isText = [left, right].some(
      ({ type, value }) => type === 'TemplateLiteral' || (type === 'Literal' && typeof value === 'string'),
    );
    const replace = (after: string) => add([node.start, node.end], `(${after})`, here);
    for (const other of RELATIONS[operator] ?? []) replace(`${part(left)} ${other} ${part(right)}`);
    if (ARITHMETIC[operator] === undefined || (isText && operator === '+')) return;
    replace(`${part(left)} ${ARITHMETIC[operator]} ${part(right)}`);
    if (operator === '+' || operator === '-') replace(part(left));
    if (operator === '+') replace(part(right));
  }

  function member(node: Node, here: Context): void {
    const property = node.property as Node;
    if (node.computed === true) return;
    if (node.optional === true) add([(node.object as Node).end, property.start], '.', here);
    const twin = TWINS.get(property.name as string);
    if (twin !== undefined) add([property.start, property.end], twin, here);
  }

  function call(node: Node, here: Context): void {
    const callee = node.callee as Node;
    const list = node.arguments as Node[];
    if (callee.type !== 'MemberExpression' || callee.computed === true) return;
    const [object, name] = [callee.object as Node, (callee.property as Node).name as string];
    const replace = (after: string) => add([node.start, node.end], after, here);
    if (part(object) !== 'Math') {
      if (['filter', 'sort', 'toSorted', 'reverse', 'toReversed', 'trim'].includes(name)) replace(part(object));
      return;
    }
    if (name === 'max' || name === 'min') {
      const other = name === 'max' ? 'min' : 'max';
      replace(`Math.${other}(${list.map(part).join(', ')})`);
      if (list.length < 2) return;
      for (const dropped of list)
        replace(`Math.${name}(${list.flatMap((one) => (one === dropped ? [] : [part(one)])).join(', ')})`);
    } else if (['abs', 'floor', 'ceil', 'round', 'trunc', 'sign'].includes(name)) {
      replace(`(${list.map(part).join(', ')})`);
    }
  }
}

/** Numbers for a bound that is looser or tighter, or a count that is one more or less. */
function numbersNear(n: number): number[] {
  if (n === 0) return [1];
  if (n === 1) return [0, 2];
  if (Number.isInteger(n) && n < 16) return [n - 1, n + 1];
  return [n / 2, n * 2];
}

const isNode = (value: unknown): value is Node =>
  typeof value === 'object' && value !== null && typeof (value as Node).type === 'string' && 'start' in value;

/** Whether a node is left unchanged: types, imports, names, and the targets of bindings cannot be switched. */
function isLeftAlone(node: Node, parent: Node | null, key: string): boolean {
  const { type } = node;
  if (type === 'ImportDeclaration' || type === 'ImportExpression' || type === 'ExportAllDeclaration') return true;
  if (type.startsWith('TS') && !['TSAsExpression', 'TSNonNullExpression', 'TSSatisfiesExpression'].includes(type)) return true;
  if (type.startsWith('JSX') && type !== 'JSXElement' && type !== 'JSXFragment' && type !== 'JSXExpressionContainer') return true;
  if (type === 'ExpressionStatement' && typeof node.directive === 'string') return true;
  if (key === 'typeAnnotation' || key === 'typeArguments' || key === 'typeParameters' || key === 'id' || key === 'label')
    return true;
  return parent !== null && (key === 'key' || key === 'property') && parent.computed !== true;
}

function isSwitchable(node: Node, parent: Node | null, key: string): boolean {
  if (!EXPRESSION.test(node.type) || parent === null) return false;
  if (key === 'callee' || key === 'params' || key === 'tag' || key === 'quasi') return false;
  if (key === 'left' && /^(Assignment|For)/.test(parent.type)) return false;
  if (key === 'argument' && (parent.type === 'UpdateExpression' || parent.type === 'RestElement')) return false;
  if (parent.type === 'UnaryExpression' && parent.operator === 'delete') return false;
  if (parent.type === 'ArrayPattern' || parent.type === 'ExportSpecifier' || parent.type === 'ClassDeclaration') return false;
  // the value of a property in a pattern is the target of a binding
  return !(parent.type === 'Property' && key === 'value' && node.type === 'Identifier');
}

/** The mutants of several files, numbered from 1 in the order of the files. */
export function allMutants(root: string, files: readonly string[]): PlacedMutant[] {
  const found: PlacedMutant[] = [];
  for (const file of files) found.push(...mutantsOf(file, readFileSync(join(root, file), 'utf8'), found.length + 1));
  return found;
}
