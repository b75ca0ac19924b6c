import { existsSync, readFileSync } from 'node:fs';
import process from 'node:process';
import { FETCH_MORE, type Git } from '../io/index.ts';
import { Failure, shellPath } from '../terminal/index.ts';

/** The commit with which files are compared. */
interface Base {
  /** In words: `main (merge base 1a2b3c4)`. */
  readonly inWords: string;
  /** Its hash; null in a repository without a commit, where every file is new. */
  readonly commit: string | null;
}

/** Why nothing tells what has changed, in words. */
interface Unknown {
  readonly unknown: string;
}

/**
 * The commit from which the working directory has changed: where its history leaves that of a ref, or what the job's service names.
 * @param ref null: what the service names, else the branch that changes go into, as far as it is known
 * @throws Failure if there is no such commit, or if it is missing because the clone is shallow
 */
export function findBase(git: Git, ref: string | null): Base | Unknown {
  if (!isCommit(git, 'HEAD')) {
    if (ref !== null)
      throw new Failure(`--changed ${ref}: the repository has no commit yet; --changed without a ref checks all its levels`);
    return { inWords: 'the beginning, as there is no commit yet', commit: null };
  }
  if (ref !== null) {
    if (ref.startsWith('-') || !isCommit(git, ref)) throw new Failure(unknownRef(git, ref));
    return isOwn(ref) ? commonBase(git, ref) : unlessAllIsIn(git, commonBase(git, ref), ref);
  }
  const change = jobChange();
  return change === null ? fromDefaultBranch(git) : fromJob(git, change);
}

const isCommit = (git: Git, name: string): boolean => git.line(['rev-parse', '--verify', '--quiet', `${name}^{commit}`]) !== null;

/** Whether a ref is named by way of the commit that is checked out, as in `HEAD~2`: what has changed since is then known. */
const isOwn = (ref: string): boolean => /^(HEAD|@)(?![\w/-])/.test(ref);

function fromJob(git: Git, change: JobChange): Base | Unknown {
  if (change.kind === 'nothing') return { unknown: change.why };
  if (change.kind === 'push') {
    const short = change.before.slice(0, 7);
    // compared with itself, even if the push has left it: what was checked then is its content
    if (isCommit(git, change.before)) return { inWords: `the last push (${short})`, commit: change.before };
    if (git.isShallow()) throw new Failure(`--changed: the commit before this push, ${short}, is not there: ${FETCH_MORE}`);
    return { unknown: `the commit before this push, ${short}, is gone, as after a forced push` };
  }
  const found = change.bases.find((name) => isCommit(git, name));
  if (found !== undefined) return unlessAllIsIn(git, commonBase(git, found), shortName(found));
  if (change.kind === 'new branch') return { unknown: 'this branch is new, and the default branch is not there' };
  const { into } = change;
  throw new Failure(
    `--changed: the branch ${into}, into which this pull request goes, is not there: ${git.isShallow() ? FETCH_MORE : `git fetch origin ${into} gets it`}`,
  );
}

/** From the branch of the remote, or a local one with the usual name; else from the last commit. */
function fromDefaultBranch(git: Git): Base | Unknown {
  const named = git.line(['symbolic-ref', '--quiet', 'refs/remotes/origin/HEAD']);
  const usual = ['refs/remotes/origin/main', 'refs/remotes/origin/master', 'refs/heads/main', 'refs/heads/master'];
  const name = [...(named === null ? [] : [named]), ...usual].find((ref) => isCommit(git, ref)) ?? 'HEAD';
  return unlessAllIsIn(git, commonBase(git, name), shortName(name));
}

/** The last commit that is in both histories. */
function commonBase(git: Git, name: string): Base {
  const commit = git.line(['merge-base', name, 'HEAD']);
  const shown = shortName(name);
  if (commit === null) {
    const why = git.isShallow() ? `: ${FETCH_MORE}` : '';
    throw new Failure(`--changed: ${shown} and the commit that is checked out have no common commit${why}`);
  }
  return {
    inWords: name === 'HEAD' ? `the last commit (${commit.slice(0, 7)})` : `${shown} (merge base ${commit.slice(0, 7)})`,
    commit,
  };
}

/**
 * In a job, and in a shallow clone, which jobs have: a branch that has the commit which is checked out says nothing about what a
 * push has changed. Elsewhere, what is not committed has changed.
 */
function unlessAllIsIn(git: Git, base: Base, name: string): Base | Unknown {
  if (base.commit !== git.line(['rev-parse', 'HEAD']) || !(isJob(process.env) || git.isShallow())) return base;
  return { unknown: `nothing tells what has changed: ${name} has the commit that is checked out` };
}

const shortName = (ref: string): string => ref.replace(/^refs\/(remotes|heads)\//, '');

function unknownRef(git: Git, ref: string): string {
  const what = `--changed ${shellPath(ref)}: there is no commit of that name`;
  if (existsSync(ref)) {
    const path = shellPath(ref);
    return `${what}, but a path: to check what has changed below it, write gq check ${path} --changed, or --changed=REF ${path}`;
  }
  if (git.isShallow()) return `${what}; ${FETCH_MORE}`;
  return `${what}: expected a branch, a tag or a commit, as git branch --all and git tag list them`;
}

/** What a service that checks pushes and pull requests tells of the change that it checks. */
type JobChange =
  /** A push onto a branch, which was at this commit before. */
  | { readonly kind: 'push'; readonly before: string }
  /** A pull request. Its own commits lead from the first of these that is there, names of refs or hashes of commits. */
  | { readonly kind: 'request'; readonly into: string; readonly bases: readonly string[] }
  /** A branch that is new. It is compared with the default branch, if that is there. */
  | { readonly kind: 'new branch'; readonly bases: readonly string[] }
  /** Nothing. */
  | { readonly kind: 'nothing'; readonly why: string };

/** A hash of a commit; others must not reach the command line of git. */
const HASH = /^(?:[0-9a-f]{40}|[0-9a-f]{64})$/;
const ZEROS = /^0+$/;

/** Variables by which services say that they run a job; some don't set CI. */
const SERVICES = ['CI', 'GITHUB_ACTIONS', 'GITLAB_CI', 'TF_BUILD', 'JENKINS_URL', 'TEAMCITY_VERSION'];

/** Whether this is a job of such a service. */
const isJob = (env: NodeJS.ProcessEnv): boolean => SERVICES.some((name) => !['', '0', 'false'].includes(env[name] ?? ''));

/** What GitHub or GitLab tells; null where neither does. */
function jobChange(env: NodeJS.ProcessEnv = process.env): JobChange | null {
  if (env.GITHUB_EVENT_PATH || env.GITHUB_BASE_REF) return fromGithub(env);
  if (env.CI_COMMIT_BEFORE_SHA || env.CI_MERGE_REQUEST_DIFF_BASE_SHA || env.CI_MERGE_REQUEST_TARGET_BRANCH_NAME)
    return fromGitlab(env);
  return null;
}

const branchRefs = (name: string): string[] => [`refs/remotes/origin/${name}`, `refs/heads/${name}`];

const hashes = (...values: readonly unknown[]): string[] =>
  values.filter((value) => typeof value === 'string' && HASH.test(value) && !ZEROS.test(value)) as string[];

/** The parts of an event that matter: https://docs.github.com/webhooks/webhook-events-and-payloads */
interface Event {
  readonly pull_request?: { readonly base?: { readonly ref?: unknown; readonly sha?: unknown } };
  readonly merge_group?: { readonly base_ref?: unknown; readonly base_sha?: unknown };
  readonly before?: unknown;
  readonly ref?: unknown;
  readonly repository?: { readonly default_branch?: unknown };
}

function fromGithub(env: NodeJS.ProcessEnv): JobChange | null {
  const event = readEvent(env.GITHUB_EVENT_PATH);
  const { pull_request: request, merge_group: group } = event ?? {};
  const into = env.GITHUB_BASE_REF || request?.base?.ref || group?.base_ref;
  if (typeof into === 'string') {
    const name = into.replace(/^refs\/heads\//, '');
    return { kind: 'request', into: name, bases: [...branchRefs(name), ...hashes(request?.base?.sha, group?.base_sha)] };
  }
  if (event === null) return { kind: 'nothing', why: 'the event of GitHub can not be read (GITHUB_EVENT_PATH)' };
  return fromPush(event.before, event.ref, event.repository?.default_branch);
}

function readEvent(path: string | undefined): Event | null {
  try {
    const event = JSON.parse(readFileSync(path ?? '', 'utf8'));
    return typeof event === 'object' ? event : null;
  } catch {
    return null;
  }
}

function fromGitlab(env: NodeJS.ProcessEnv): JobChange | null {
  const into = env.CI_MERGE_REQUEST_TARGET_BRANCH_NAME;
  const base = hashes(env.CI_MERGE_REQUEST_DIFF_BASE_SHA);
  if (into || base.length > 0)
    return { kind: 'request', into: into ?? base[0], bases: [...base, ...(into ? branchRefs(into) : [])] };
  const ref = env.CI_COMMIT_BRANCH ? `refs/heads/${env.CI_COMMIT_BRANCH}` : '';
  return fromPush(env.CI_COMMIT_BEFORE_SHA, ref, env.CI_DEFAULT_BRANCH);
}

/** @param ref the branch or tag, as `refs/heads/...` or `refs/tags/...` */
function fromPush(before: unknown, ref: unknown, defaultBranch: unknown): JobChange {
  const [commit] = hashes(before);
  if (commit !== undefined) return { kind: 'push', before: commit };
  const isBranch = typeof ref === 'string' && ref.startsWith('refs/heads/');
  if (isBranch && typeof defaultBranch === 'string' && ref !== `refs/heads/${defaultBranch}`)
    return { kind: 'new branch', bases: branchRefs(defaultBranch) };
  return { kind: 'nothing', why: 'this job is for no push onto a branch that was there before, and for no pull request' };
}
