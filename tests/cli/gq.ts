import { type ChildProcess, fork, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

/** The shipped command line; `npm test` builds it first. */
export const MAIN = fileURLToPath(new URL('../../dist/gq/main.js', import.meta.url));

const WARM = fileURLToPath(new URL('./warm-process.mjs', import.meta.url));

export interface Ended {
  readonly code: number | null;
  readonly signal: NodeJS.Signals | null;
  readonly stdout: string;
  readonly stderr: string;
}

/** ms; only a process that hangs takes this long, even on a busy machine */
const TOO_LONG = 120_000;

/** Variables for colours, and those of a CI service. */
const FROM_OUTSIDE = /^(FORCE_COLOR|CI|CI_.*|GITHUB_.*|GITLAB_.*|JENKINS_URL|TF_BUILD|TEAMCITY_VERSION)$/;

/** The environment without the user's settings for colours and those of a CI service, which must not affect tests. */
function quietEnvironment(): NodeJS.ProcessEnv {
  const rest = Object.entries(process.env).filter(([name]) => !FROM_OUTSIDE.test(name));
  return { ...Object.fromEntries(rest), NO_COLOR: '1' };
}

/** What the shared process answers. */
interface Answer {
  readonly ended: Ended;
  /** Both streams, as a terminal shows them. */
  readonly shown: string;
}

interface WarmProcess {
  readonly child: ChildProcess;
  readonly waiting: Map<number, { resolve(answer: Answer): void; reject(error: Error): void }>;
  asked: number;
}

let warm: WarmProcess | null = null;

function startWarmProcess(): WarmProcess {
  const child = fork(WARM, { env: quietEnvironment(), execArgv: [], stdio: ['ignore', 'inherit', 'inherit', 'ipc'] });
  const started: WarmProcess = { child, waiting: new Map(), asked: 0 };
  child.on('message', ({ id, ...answer }: Answer & { id: number }) => {
    started.waiting.get(id)?.resolve(answer);
    started.waiting.delete(id);
  });
  child.on('exit', (code, signal) => {
    if (warm === started) warm = null;
    for (const { reject } of started.waiting.values()) reject(new Error(`gq ended its process with ${signal ?? code}`));
  });
  // it ends with the process that has started it, and does not keep that process alive
  child.unref();
  child.channel?.unref();
  return started;
}

// the commands of the shared process, one after the other
let earlier: Promise<unknown> = Promise.resolve();

interface Place {
  /** The working directory; the one of this process if it is left out. */
  readonly cwd?: string;
  /** Added to the environment. */
  readonly env?: Readonly<Record<string, string>>;
  /** The standard input, a file. It is empty if it is left out. */
  readonly input?: string | Uint8Array;
}

/**
 * Runs gq to its end. The commands of a worker run one after the other in a shared process, so that the start-up time is
 * spent only once. The work of threads is done in its main thread. Tests about the process itself and its threads use `gqProcess`.
 */
export const gq = async (args: readonly string[], place: Place = {}): Promise<Ended> => (await inTurn(args, place)).ended;

/** The same as in a terminal: with what a person sees. */
export async function gqInTerminal(args: readonly string[], cwd: string): Promise<{ code: number | null; shown: string }> {
  const { ended, shown } = await inTurn(args, { cwd });
  return { code: ended.code, shown };
}

function inTurn(args: readonly string[], place: Place): Promise<Answer> {
  // the time limit of a command begins when those before it have ended
  const answer = earlier.then(() => ask(args, place));
  earlier = answer.catch(() => undefined);
  return answer;
}

function ask(args: readonly string[], { cwd = process.cwd(), env = {}, input }: Place): Promise<Answer> {
  warm ??= startWarmProcess();
  const { child, waiting } = warm;
  const id = warm.asked++;
  return new Promise<Answer>((resolve, reject) => {
    const killer = setTimeout(() => {
      reject(new Error(`gq ${args.join(' ')}: took more than ${TOO_LONG / 1000} s`));
      child.kill('SIGKILL');
      if (warm?.child === child) warm = null;
    }, TOO_LONG);
    waiting.set(id, {
      resolve(answer) {
        clearTimeout(killer);
        resolve(answer);
      },
      reject(error) {
        clearTimeout(killer);
        reject(error);
      },
    });
    child.send({ id, args, cwd, env, input: input === undefined ? null : Buffer.from(input).toString('base64') });
  });
}

export interface ProcessOptions {
  readonly cwd?: string;
  readonly env?: NodeJS.ProcessEnv;
  /** Called with the running process. */
  readonly during?: (child: ChildProcess) => void;
}

/** Runs gq to its end in a process of its own, as a shell does. A process that hangs is killed, and so ends with a signal. */
export function gqProcess(args: readonly string[], { cwd, env, during }: ProcessOptions = {}): Promise<Ended> {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [MAIN, ...args], { cwd, env: { ...quietEnvironment(), ...env } });
    const stdout: Buffer[] = [];
    const stderr: Buffer[] = [];
    child.stdout.on('data', (data: Buffer) => stdout.push(data));
    child.stderr.on('data', (data: Buffer) => stderr.push(data));
    const killer = setTimeout(() => child.kill('SIGKILL'), TOO_LONG);
    child.on('error', reject);
    child.on('close', (code, signal) => {
      clearTimeout(killer);
      resolve({ code, signal, stdout: Buffer.concat(stdout).toString(), stderr: Buffer.concat(stderr).toString() });
    });
    during?.(child);
  });
}

/** What V8 records of a script that a process has loaded. */
interface CoveredScript {
  readonly url: string;
  readonly functions: readonly { readonly functionName: string; readonly ranges: readonly { readonly count: number }[] }[];
}

/** What a process has loaded and called. */
interface Covered {
  /** Modules of the project, such as `engine/simulate.js`, and packages, such as `zod`. */
  readonly loaded: ReadonlySet<string>;
  /** Names of the functions of the project that it has called. */
  readonly called: ReadonlySet<string>;
}

/** Runs gq in a process of its own. @returns also what it has loaded and called */
export async function gqCovered(args: readonly string[], cwd: string): Promise<Ended & Covered> {
  const folder = mkdtempSync(join(tmpdir(), 'gq-coverage-'));
  try {
    const ended = await gqProcess(args, { cwd, env: { NODE_V8_COVERAGE: folder } });
    const scripts = readdirSync(folder).flatMap(
      (name): CoveredScript[] => JSON.parse(readFileSync(join(folder, name), 'utf8')).result,
    );
    const ours = scripts.filter(({ url }) => url.includes('/dist/gq/'));
    const called = ours
      .flatMap(({ functions }) => functions)
      .flatMap(({ functionName, ranges }) => (ranges[0].count > 0 ? [functionName] : []));
    const packages = scripts.flatMap(({ url }) => /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(url)?.[1] ?? []);
    return { ...ended, loaded: new Set([...ours.flatMap(({ url }) => modulesIn(url)), ...packages]), called: new Set(called) };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The modules that a file of the bundle is made of. */
const modulesIn = (url: string): string[] =>
  [...readFileSync(fileURLToPath(url), 'utf8').matchAll(/^\/\/ dist\/(.*\.js)$/gm)].map(([, module]) => module);

/** Makes a directory for a test. @param files its file names and contents */
export function makeFiles(files: Readonly<Record<string, string | Uint8Array>>): { directory: string; remove: () => void } {
  const directory = mkdtempSync(join(tmpdir(), 'gq-'));
  for (const [name, content] of Object.entries(files)) {
    mkdirSync(dirname(join(directory, name)), { recursive: true });
    writeFileSync(join(directory, name), content);
  }
  return { directory, remove: () => rmSync(directory, { recursive: true, force: true }) };
}

/** Falls from rest straight through a cold asteroid into the black hole behind it while the gun is held. */
export function fallThrough(changes: Readonly<Record<string, unknown>> = {}): string {
  return JSON.stringify({
    version: 1,
    name: 'Straight through',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 170, y: 0 },
    asteroids: [{ x: 100, y: 0, radius: 16 }],
    runs: [{ name: 'hold', holds: [[0, 600]] }],
    ...changes,
  });
}
