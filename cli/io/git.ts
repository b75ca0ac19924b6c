import { existsSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { Failure, systemReason } from '../terminal/index.ts';

/** The largest answer of git that is read, bytes: a list of names, or the contents of all levels. */
const MOST_OUTPUT = 2 ** 30;

/** How to ask git. */
export interface GitQuestion {
  /** The folder in which git runs. */
  readonly folder: string;
  readonly input?: string;
  /** ms after which git is ended */
  readonly timeout?: number;
}

/** The answer of git. */
export interface GitAnswer {
  /** The exit code; null if git was ended. */
  readonly status: number | null;
  readonly output: Buffer;
  /** What git says on stderr, in its own words and in full, since it often says what to do; only `fatal:` is left out. */
  readonly error: string;
}

/**
 * Asks git, with messages in English and without writing to the index. Every command that needs git comes here.
 * @returns the system's error if git can't be started
 */
export function tryGit(args: readonly string[], { folder, input, timeout }: GitQuestion): GitAnswer | Error {
  // loaded only now: it takes 5 ms, and most commands don't ask git
  const { spawnSync } = process.getBuiltinModule('node:child_process');
  const { status, stdout, stderr, error } = spawnSync('git', args, {
    cwd: folder,
    input,
    timeout,
    maxBuffer: MOST_OUTPUT,
    windowsHide: true,
    env: { ...process.env, LC_ALL: 'C', GIT_OPTIONAL_LOCKS: '0' },
  });
  if (error !== undefined) return error;
  return { status, output: stdout, error: ownWords(stderr.toString()) };
}

const ownWords = (text: string): string => text.trim().replace(/^fatal: /gm, '');

/** For a command that can't do without git. */
export class Git {
  /**
   * @param who what asks git, for messages
   * @param otherwise what to do where there is no git
   */
  constructor(
    private readonly folder: string,
    private readonly who: string,
    private readonly otherwise: string,
  ) {}

  /** The same in another folder. */
  in(folder: string): Git {
    return new Git(folder, this.who, this.otherwise);
  }

  /** @throws Failure if git can't be started */
  ask(args: readonly string[], input?: string): GitAnswer {
    const answer = tryGit(args, { folder: this.folder, input });
    if (!(answer instanceof Error)) return answer;
    if ((answer as NodeJS.ErrnoException).code !== 'ENOENT')
      throw new Failure(`${this.who} asks git, which can't be run: ${systemReason(answer)}`);
    throw new Failure(
      `${this.who} asks git, and there is no command git: expected it in PATH: install it first, or ${this.otherwise}`,
    );
  }

  /** What git prints. @throws Failure with git's own words if it fails */
  read(args: readonly string[], input?: string): Buffer {
    const { status, output, error } = this.ask(args, input);
    if (status === 0) return output;
    throw new Failure(`${this.who}: git ${args[0]} failed: ${error || `it ended with ${status}`}`);
  }

  /** What git prints, without the line end; null if it fails. */
  line(args: readonly string[]): string | null {
    const { status, output } = this.ask(args);
    return status === 0 ? output.toString().replace(/\r?\n$/, '') : null;
  }

  /**
   * The root of the working tree around the folder, with `/`; null outside of a repository.
   * @throws Failure in a repository without a working tree, and in one that git does not touch, such as one of another owner
   */
  workTree(): string | null {
    const { status, output, error } = this.ask(['rev-parse', '--is-inside-work-tree']);
    if (status !== 0 && /^not a git repository/m.test(error)) return null;
    if (status !== 0) throw new Failure(`${this.who} asks git, which refuses to work here: ${error}`);
    const root = output.toString().trim() === 'true' ? this.line(['rev-parse', '--show-toplevel']) : null;
    if (root !== null) return root;
    throw new Failure(
      `${this.who}: expected a working tree, found a bare repository or its inside: go to a clone with files, or ${this.otherwise}`,
    );
  }

  /** Whether history may be missing, since the clone has only the last commits. */
  isShallow(): boolean {
    return this.line(['rev-parse', '--is-shallow-repository']) === 'true';
  }
}

/** What to do in a shallow clone, after what is missing. */
export const FETCH_MORE =
  'this clone is shallow: git fetch --unshallow gets its history (in GitHub Actions: fetch-depth: 0 for actions/checkout; in GitLab: the variable GIT_DEPTH: 0)';

/** The root of the repository around a folder, absolute; the folder itself if there is none. */
export function repositoryOf(folder: string): string {
  for (let at = resolve(folder); ; at = dirname(at)) {
    if (existsSync(join(at, '.git'))) return at;
    if (dirname(at) === at) return resolve(folder);
  }
}
