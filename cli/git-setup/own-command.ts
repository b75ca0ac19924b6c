import { existsSync, realpathSync } from 'node:fs';
import { dirname, isAbsolute, join, relative } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

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
export function ownFunction(root: string): string {
  const main = realpathSync(fileURLToPath(new URL('../main.js', import.meta.url)));
  // programs with windows often have no node on their PATH
  const node = `"$(command -v node || echo ${quoted(process.execPath)})"`;
  const inside = insideOf(root, main);
  const choose = inside === null ? `m=${quoted(main)}` : `m=${quoted(inside)}; test -e "$m" || m=${quoted(main)}`;
  const check = 'test -e "$m" || { echo "gq is not at $m any more: install it, and run gq git-setup again" >&2; return 127; }';
  return `gq() { ${choose}; ${check}; ${node} "$m" "$@"; }`;
}
