import { type Finding, MAX_FILE_SIZE, MAX_FINDINGS, MAX_PROBLEMS, type Path, type Problem, toPointer } from '../basics/index.ts';
import { foreignKind, hintForKind, isUtf16, unmarkedUtf16 } from './foreign-file.ts';
import { mergeMarkers, pointerFile } from './git-leftovers.ts';
import { createLocator, createPlaceFinder, type Locator } from './locate.ts';
import { explainMistake } from './mistakes.ts';
import { readPlain, scanJson } from './scan.ts';
import { decodeUtf8 } from './utf8.ts';

/** A JSON document, or what is wrong with it. `text` has no byte order mark. */
export type JsonReading =
  | {
      readonly ok: true;
      readonly text: string;
      readonly value: unknown;
      readonly locator: Locator;
      /** Whether any key begins with x-. */
      readonly hasExtensions: boolean;
      /** Problems of a text that could be read all the same. */
      readonly findings: readonly Finding[];
    }
  | { readonly ok: false; readonly problems: Problem[]; readonly text: string };

// a key of a megabyte must not appear in a report
const MAX_POINTER = 500;

const MARK = '\ufeff';

function markFinding(isWanted: boolean): Finding[] {
  if (!isWanted) return [];
  const message = 'the file begins with a byte order mark (EF BB BF)';
  const hint = 'Save it as UTF-8 without a BOM; gq fmt removes the mark.';
  return [{ code: 'byte-order-mark', message, hint, path: [], part: 'value', offset: 0 }];
}

function wholeFile(code: Finding['code'], message: string, hint: string): JsonReading {
  return { ok: false, problems: [{ code, severity: 'error', message, hint, pointer: '', line: null, column: null }], text: '' };
}

type Content = 'level' | 'configuration' | 'pack' | 'lock';

const EMPTY: Readonly<Record<Content, string>> = {
  level: 'a level',
  configuration: '{ }',
  pack: 'the order of the levels',
  lock: '{ "version": 1, "levels": {} }',
};

function hintFor(kind: string, content: Content): string {
  const own = hintForKind(kind);
  if (own !== null) return own;
  if (content !== 'level') return 'Write a JSON text that begins with {, or name another file.';
  return kind.endsWith('archive')
    ? 'Unpack it and take the level files that are in it.'
    : 'Level files end in .level.json and begin with {. Choose one of those.';
}

function badByteFinding(bytes: Uint8Array, bad: { byte: number; at: number; offset: number }): Finding {
  const hex = bad.byte.toString(16).toUpperCase().padStart(2, '0');
  return {
    code: 'not-utf8',
    message: `the byte ${hex} at offset ${bad.at} is not UTF-8${isUtf16(bytes) ? ': the file looks like UTF-16' : ''}`,
    hint: 'Save the file as UTF-8.',
    path: [],
    part: 'value',
    offset: bad.offset,
  };
}

/** What is wrong with a text that is not JSON: what git has left there rather than what follows from it. */
function failureOf(text: string, failure: Finding): Finding {
  const markers = mergeMarkers(text, failure.offset ?? 0);
  return markers === null ? failure : { code: 'merge-markers', ...markers, path: [], part: 'value' };
}

/** The pointer of a path; if a key makes it too long, that of the value around it. */
function readablePointer(path: Path): string {
  const pointer = toPointer(path);
  return pointer.length > MAX_POINTER ? readablePointer(path.slice(0, -1)) : pointer;
}

/**
 * Turns findings into problems with places, in the order of the text: at most `MAX_PROBLEMS`, and one more that counts the
 * rest.
 */
export function toProblems(findings: readonly Finding[], locator: Locator): Problem[] {
  const placed = findings.map((finding) => {
    const offset = finding.offset ?? locator.offsetOf(toPointer(finding.path), finding.part);
    return { finding, pointer: readablePointer(finding.path), offset };
  });
  placed.sort((a, b) => a.offset - b.offset);
  const problems: Problem[] = placed.slice(0, MAX_PROBLEMS).map(({ finding, pointer, offset }) => {
    const { code, message, hint } = finding;
    return { code, severity: 'error', message, hint, pointer, ...locator.placeAt(offset) };
  });
  const rest = findings.length - problems.length;
  if (rest > 0) {
    problems.push({
      code: 'more-problems',
      severity: 'error',
      message: `and ${findings.length >= MAX_FINDINGS ? 'at least ' : ''}${rest} more`,
      hint: 'Fix the problems above first, then check again.',
      pointer: '',
      line: null,
      column: null,
    });
  }
  return problems;
}

/** Problems of a text that is not JSON, in which only offsets have places. */
function toPlacedProblems(findings: readonly Finding[], text: string): JsonReading {
  const locator: Locator = { offsetOf: () => 0, placeAt: createPlaceFinder(text) };
  return { ok: false, problems: toProblems(findings, locator), text };
}

/**
 * Reads the text of a JSON file strictly: size, encoding, syntax, nesting, repeated keys, and numbers beyond the range of
 * doubles.
 * @param source - the bytes of the file, or its text
 * @param byteOrderMark - whether a byte order mark is a problem (`refuse`) or skipped (`skip`)
 * @param content - what the file should hold
 */
export function readJson(source: Uint8Array | string, byteOrderMark: 'refuse' | 'skip', content: Content = 'level'): JsonReading {
  if (source.length > MAX_FILE_SIZE) {
    return wholeFile(
      'file-too-large',
      'a file may have 8 MiB, this one has more',
      `Check that the path names a ${content === 'level' ? 'level file' : content}.`,
    );
  }
  const pointer = pointerFile(source);
  if (pointer !== null) {
    const { found, hint } = pointer;
    const message = `expected the content of the file, found ${found}`;
    const text = typeof source === 'string' ? source : decodeUtf8(source).text;
    return toPlacedProblems([{ code: 'pointer-file', message, hint, path: [], part: 'value', offset: 0 }], text);
  }
  const kind = foreignKind(source);
  if (kind !== null) return wholeFile('not-a-level', `expected a ${content} as JSON text, found ${kind}`, hintFor(kind, content));
  const order = unmarkedUtf16(source);
  if (order !== null) {
    const message = `expected UTF-8, found UTF-16 (${order}) without a byte order mark`;
    return wholeFile('not-utf8', message, 'Save the file as UTF-8.');
  }
  const decoded = typeof source === 'string' ? { text: source, bad: null } : decodeUtf8(source);
  const hasMark = decoded.text.startsWith(MARK);
  const text = hasMark ? decoded.text.slice(1) : decoded.text;
  const marks = markFinding(hasMark && byteOrderMark === 'refuse');
  if (decoded.bad !== null && typeof source !== 'string') {
    const bad = { ...decoded.bad, offset: decoded.bad.offset - (hasMark ? 1 : 0) };
    return toPlacedProblems([...marks, badByteFinding(source, bad)], text);
  }
  if (text.trim() === '') {
    return toPlacedProblems(
      [
        ...marks,
        {
          code: 'empty-file',
          message: 'the file is empty',
          hint: `Write ${EMPTY[content]} into it, or delete it.`,
          path: [],
          part: 'value',
          offset: 0,
        },
      ],
      text,
    );
  }
  const plain = readPlain(text);
  if (plain !== null)
    return { ok: true, text, value: plain[0], locator: createLocator(text), hasExtensions: false, findings: marks };
  const { failure, repeated, hasExtensions } = scanJson(text);
  const findings = [...marks, ...repeated.map((mistake) => explainMistake(text, mistake))];
  if (failure !== null) return toPlacedProblems([...findings, failureOf(text, explainMistake(text, failure))], text);
  return { ok: true, text, value: JSON.parse(text), locator: createLocator(text), hasExtensions, findings };
}
