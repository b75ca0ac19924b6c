import { KINDS, OBJECT_KINDS, OBJECT_LISTS } from '../../schema/index.ts';
import { lineOf, type Node, treeOf, walk } from './syntax.ts';

/** A text in a source file; `parts` are what stands between the expressions of a template. */
interface Text {
  readonly line: number;
  readonly parts: readonly string[];
  /** The code of the expression after each part but the last. */
  readonly between: readonly string[];
}

/** Every string, template and text between tags in a source file. Comments are none of them. */
function textsOf(path: string, source: string): Text[] {
  const texts: Text[] = [];
  walk(treeOf(path, source), (node) => {
    if ((node.type === 'Literal' || node.type === 'JSXText') && typeof node.value === 'string') {
      texts.push({ line: lineOf(source, node), parts: [node.value], between: [] });
    } else if (node.type === 'TemplateLiteral') {
      const quasis = node.quasis as { readonly value: { readonly cooked: string } }[];
      const expressions = node.expressions as (Node & { readonly end: number })[];
      const between = expressions.map(({ start, end }) => source.slice(start, end));
      texts.push({ line: lineOf(source, node), parts: quasis.map(({ value }) => value.cooked), between });
    }
  });
  return texts;
}

const KIND_NAMES = OBJECT_KINDS.map((kind) => KINDS[kind].one).join('|');
const LISTS = [...OBJECT_LISTS, 'runs', 'holds'].join('|');

/** An entry of a list as code writes it: `asteroids[3]`. */
const INDEX = new RegExp(`\\b(?:${LISTS})\\[`);
/** An object counted from 0: `asteroid 0`. */
const ZERO = new RegExp(`\\b(?:${KIND_NAMES}|run|hold) 0\\b`, 'i');
/** The name of a kind at the end of a part of a template: its number follows. */
const KIND_AT_END = new RegExp(`\\b(?:${KIND_NAMES}) $`, 'i');

/** Words and phrases that a plain text has no use for. */
const PHRASES: readonly RegExp[] = [
  /\b(?:is|are) told\b/i,
  /\bwhoever\b/i,
  /\bmend\b/i,
  /\ball is well\b/i,
  /\breally different\b/i,
  /\bcanonically\b/i,
  /\bhangs? (?:by|on)\b/i,
  /\bexclude each other\b/i,
  /\blooked into\b/i,
  /\bsomething deadly\b/i,
  /\bso (?:much|many) (?:as|succeeds?|levels|runs|times|ticks)\b/i,
  /\bits \w+ is none\b/i,
  /\bdoes not understand\b/i,
];
/** What the original calls a mineral: only the import of its files speaks of it. */
const GOODIES = /\bgoodies\b/i;

const isProse = (text: string): boolean => /\S \S|^ | $/.test(text);

/** Forms that must not come back in the texts of a source file: `line: the form: the text`. */
export function formsInSource(path: string, source: string, isImport = false): string[] {
  return textsOf(path, source).flatMap(({ line, parts, between }) => {
    const whole = parts.join('…');
    if (!isProse(whole)) return [];
    const forms = [INDEX, ZERO, ...PHRASES, ...(isImport ? [] : [GOODIES])].flatMap((form) => form.exec(whole)?.[0] ?? []);
    for (const [i, code] of between.entries()) {
      const kind = KIND_AT_END.exec(parts[i])?.[0];
      // counted by hand it must at least be counted from 1
      if (kind !== undefined && /index|^[a-z]$/i.test(code) && !/\+ 1$|^1 \+/.test(code)) forms.push(`${kind}«${code}»`);
    }
    return forms.map((form) => `${line}: ${form}: ${whole.trim().slice(0, 100)}`);
  });
}

/** The same for what a command prints: `line: the form`. */
export function formsInOutput(text: string): string[] {
  return text
    .split('\n')
    .flatMap((line, i) =>
      [INDEX, ZERO].flatMap((form) => form.exec(line)?.slice(0, 1) ?? []).map((found) => `${i + 1}: ${found}`),
    );
}

/** What is wrong with the tables of a glossary: `line: what`. */
export function glossaryProblems(markdown: string): string[] {
  const problems: string[] = [];
  const seen = new Map<string, number>();
  const lines = markdown.split('\n');
  let rows = 0;
  for (const [i, line] of lines.entries()) {
    if (!line.startsWith('|')) continue;
    const at = i + 1;
    if (!line.trimEnd().endsWith('|')) problems.push(`${at}: the row does not end`);
    const cells = line
      .trim()
      .slice(1, -1)
      .split('|')
      .map((cell) => cell.trim());
    if (cells.length !== 3) {
      problems.push(`${at}: expected 3 cells, found ${cells.length}`);
      continue;
    }
    if (lines[i - 1]?.startsWith('|') !== true) {
      if (cells.join() !== 'term,meaning,not') problems.push(`${at}: expected term, meaning, not; found ${cells.join(', ')}`);
      continue;
    }
    if (cells.every((cell) => /^-+$/.test(cell))) continue;
    rows++;
    const [term, meaning, not] = cells;
    if (term === '' || meaning === '') problems.push(`${at}: a term without a meaning, or a meaning without a term`);
    if (seen.has(term)) problems.push(`${at}: ${term} is in line ${seen.get(term)} already`);
    seen.set(term, at);
    if (not.split(/[,;] */).includes(term)) problems.push(`${at}: ${term} is not to be used for itself`);
  }
  if (rows === 0) problems.push('1: there is no term');
  return problems;
}
