import { existsSync, readFileSync, realpathSync, rmSync } from 'node:fs';
import { dirname, isAbsolute, join, relative } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { Git, writeWhole } from '../io/index.ts';
import { Failure, systemReason } from '../terminal/index.ts';

/** What happens when no run completes a merged level any more. */
export type OnBrokenRun = 'stop' | 'warn';

/** git's settings for levels, by key. */
function settingsFor(root: string, onBrokenRun: OnBrokenRun): ReadonlyMap<string, string> {
  const gq = ownFunction(root);
  const option = onBrokenRun === 'stop' ? '' : ` --on-broken-run=${onBrokenRun}`;
  return new Map([
    [`merge.${DRIVER}.name`, 'levels of Gravity Quest, by object and run'],
    // git replaces what begins with % in the command of a merge driver
    [
      `merge.${DRIVER}.driver`,
      `${gq.replaceAll('%', '%%')}; gq merge-driver --marker-size=%L${option} %O %A %B %P; ${OR_AS_TEXT}`,
    ],
    [`diff.${DRIVER}.textconv`, `${gq}; text() { gq diff --textconv "$1" || cat "$1"; }; text`],
    [`difftool.${DRIVER}.cmd`, `${gq}; gq difftool "$LOCAL" "$REMOTE" "$MERGED"`],
  ]);
}

/**
 * What the merge driver does after gq. git takes an exit code up to 128 for a conflict in a file that holds both sides: if gq did
 * not start, the file would hold our version only, and theirs would be lost with the next commit.
 */
const OR_AS_TEXT = [
  'c=$?; if test $c -lt 2 || test $c -gt 128; then exit $c; fi',
  "echo %P': merged as text, as gq did not run: see gq git-setup --check' >&2",
  'git merge-file -q --marker-size=%L -L ours -L base -L theirs %A %O %B',
].join('; ');

/** git in the working directory. */
const GIT = new Git('.', 'gq git-setup', 'leave files to git as they are');

/** The root of the working tree. @throws Failure outside of one */
function workingTree(): string {
  const root = GIT.workTree();
  if (root !== null) return root;
  throw new Failure('expected a git repository, found none in this folder or above it: go to one, or run git init first');
}

const current = (key: string): string | null => GIT.line(['config', '--local', '--get', key]);

const attributesIn = (root: string): string => join(root, '.gitattributes');

function readAttributes(path: string): string {
  try {
    return existsSync(path) ? readFileSync(path, 'utf8') : '';
  } catch (error) {
    throw new Failure(`${path}: can't be read: ${systemReason(error)}`);
  }
}

/** Tells git to use gq for levels. @returns what was done, in words */
export async function setUp(onBrokenRun: OnBrokenRun): Promise<string[]> {
  const root = workingTree();
  const done: string[] = [];
  for (const [key, value] of settingsFor(root, onBrokenRun)) {
    const before = current(key);
    if (before === value) continue;
    GIT.read(['config', '--local', '--replace-all', key, value]);
    done.push(`${before === null ? 'set' : 'changed'} ${key} in the configuration of this clone`);
  }
  const path = attributesIn(root);
  const text = readAttributes(path);
  if (!hasAttributes(text)) {
    await writeWhole(path, withAttributes(text));
    done.push(`${text === '' ? 'wrote' : 'added a line for levels to'} ${path}: commit it`);
  }
  return done;
}

/** Takes back what `setUp` has done. @returns what was done, in words */
export async function undo(): Promise<string[]> {
  const root = workingTree();
  const done: string[] = [];
  for (const key of settingsFor(root, 'stop').keys()) {
    if (current(key) === null) continue;
    GIT.read(['config', '--local', '--unset-all', key]);
    done.push(`removed ${key} from the configuration of this clone`);
  }
  const path = attributesIn(root);
  const text = readAttributes(path);
  const without = withoutAttributes(text);
  const left = editedLines(without).map((line) => `left ${path}:${line}: it was edited, so remove "${DRIVER}" from it yourself`);
  if (without === text) return [...done, ...left];
  if (without === '') rmSync(path);
  else await writeWhole(path, without);
  const what = left.length > 0 ? 'the comment about levels' : 'the line for levels';
  done.push(without === '' ? `removed ${path}` : `removed ${what} from ${path}`);
  return [...done, ...left];
}

/** What is missing for git to use gq for levels, in words; nothing if it is set up. */
export function missing(): string[] {
  const root = workingTree();
  const lacking: string[] = [];
  for (const [key, value] of settingsFor(root, 'stop')) {
    const now = current(key);
    if (now === null) lacking.push(`${key} is not set in this clone`);
    else if (now.replace(' --on-broken-run=warn', '') !== value) lacking.push(`${key} starts another gq than this one: ${now}`);
  }
  const path = attributesIn(root);
  if (!hasAttributes(readAttributes(path))) lacking.push(`${path} has no line for levels`);
  else {
    const used = GIT.in(root).line(['check-attr', 'merge', '--', 'x.level.json']) ?? '';
    if (!used.endsWith(`: ${DRIVER}`)) lacking.push(`another line of git attributes wins for levels: ${used}`);
  }
  return lacking;
}

const quoted = (path: string): string => `'${path.replaceAll('\\', '/').replaceAll("'", "'\\''")}'`;

/** Where gq lies in a repository, seen from its root; null if it is installed elsewhere. */
function insideOf(root: string, main: string): string | null {
  const here = realpathSync(root);
  const candidates = [join(here, 'dist', 'cli', 'main.js')];
  // git may be set up from a folder that has gq installed for itself
  for (let at = realpathSync(process.cwd()); ; at = dirname(at)) {
    candidates.push(join(at, 'node_modules', 'gravity-quest-toolkit', 'dist', 'cli', 'main.js'));
    if (at === here || dirname(at) === at) break;
  }
  const found = candidates.find((candidate) => existsSync(candidate) && realpathSync(candidate) === main);
  const path = found === undefined ? null : relative(here, found);
  return path === null || path.startsWith('..') || isAbsolute(path) ? null : path;
}

/**
 * The shell commands that define the function `gq` for git, which starts this gq in the root of a working tree. It takes the one
 * installed in that tree first, so that each worktree uses its own, and else the one that runs now.
 */
function ownFunction(root: string): string {
  const main = realpathSync(fileURLToPath(new URL('../main.js', import.meta.url)));
  // programs with windows often have no node on their PATH
  const node = `"$(command -v node || echo ${quoted(process.execPath)})"`;
  const inside = insideOf(root, main);
  const choose = inside === null ? `m=${quoted(main)}` : `m=${quoted(inside)}; test -e "$m" || m=${quoted(main)}`;
  const check = 'test -e "$m" || { echo "gq is not at $m any more: install it, and run gq git-setup again" >&2; return 127; }';
  return `gq() { ${choose}; ${check}; ${node} "$m" "$@"; }`;
}

/** The name of merge driver, diff driver and diff tool in git's configuration. */
const DRIVER = 'gq-level';

const COMMENT = '# gq git-setup: levels are merged and compared by gq';
const LINE = `*.level.json merge=${DRIVER} diff=${DRIVER} text eol=lf`;

const plain = (line: string): string => line.replace(/\r$/, '');
const isOurs = (line: string): boolean => plain(line) === COMMENT || plain(line) === LINE;

const OURS = LINE.split(' ');

/** A line for levels that names gq, and to which somebody has added attributes of their own. */
function isEdited(line: string): boolean {
  const words = plain(line).trim().split(/\s+/);
  return words[0] === OURS[0] && words.length > OURS.length && OURS.every((word) => words.includes(word));
}

/** Whether a `.gitattributes` has the line for levels, perhaps with further attributes. */
const hasAttributes = (text: string): boolean => text.split('\n').some((line) => plain(line) === LINE || isEdited(line));

/** The numbers, from 1, of lines for levels that somebody has edited: `withoutAttributes` leaves them. */
const editedLines = (text: string): number[] => text.split('\n').flatMap((line, i) => (isEdited(line) ? [i + 1] : []));

/** Adds the line for levels to a `.gitattributes`, at its end, where it wins over other lines. The rest stays as it is. */
function withAttributes(text: string): string {
  if (hasAttributes(text)) return text;
  const lines = text.split('\n');
  const end = lines.length > 1 && plain(lines[0]) !== lines[0] ? '\r' : '';
  const added = [COMMENT, LINE].map((line) => line + end);
  // a last line without a line end stays one, so that undo restores the file
  if (lines.at(-1) === '') lines.splice(-1, 0, ...added);
  else lines.push(COMMENT + end, LINE);
  return lines.join('\n');
}

/** Removes what `withAttributes` has added. */
function withoutAttributes(text: string): string {
  return text
    .split('\n')
    .filter((line) => !isOurs(line))
    .join('\n');
}
