import { readFileSync } from 'node:fs';
import process from 'node:process';

/** What a service that checks pushes and pull requests tells of the change that it checks. */
export type Told =
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
export const isJob = (env: NodeJS.ProcessEnv): boolean => SERVICES.some((name) => !['', '0', 'false'].includes(env[name] ?? ''));

/** What GitHub or GitLab tells; null where neither does. */
export function whatIsTold(env: NodeJS.ProcessEnv = process.env): Told | null {
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

function fromGithub(env: NodeJS.ProcessEnv): Told | null {
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

function fromGitlab(env: NodeJS.ProcessEnv): Told | null {
  const into = env.CI_MERGE_REQUEST_TARGET_BRANCH_NAME;
  const base = hashes(env.CI_MERGE_REQUEST_DIFF_BASE_SHA);
  if (into || base.length > 0)
    return { kind: 'request', into: into ?? base[0], bases: [...base, ...(into ? branchRefs(into) : [])] };
  const ref = env.CI_COMMIT_BRANCH ? `refs/heads/${env.CI_COMMIT_BRANCH}` : '';
  return fromPush(env.CI_COMMIT_BEFORE_SHA, ref, env.CI_DEFAULT_BRANCH);
}

/** @param ref the branch or tag, as `refs/heads/...` or `refs/tags/...` */
function fromPush(before: unknown, ref: unknown, defaultBranch: unknown): Told {
  const [commit] = hashes(before);
  if (commit !== undefined) return { kind: 'push', before: commit };
  const isBranch = typeof ref === 'string' && ref.startsWith('refs/heads/');
  if (isBranch && typeof defaultBranch === 'string' && ref !== `refs/heads/${defaultBranch}`)
    return { kind: 'new branch', bases: branchRefs(defaultBranch) };
  return { kind: 'nothing', why: 'this job is for no push onto a branch that was there before, and for no pull request' };
}
